#ifndef qFaceToBoneMeasuresPanel_h
#define qFaceToBoneMeasuresPanel_h

#include <QWidget>

class QLabel;
class QTableWidget;
class qFaceToBoneCase;

/// Which angles and distances does the face have before, and as planned?
class qFaceToBoneMeasuresPanel : public QWidget
{
  Q_OBJECT

public:
  qFaceToBoneMeasuresPanel(qFaceToBoneCase* work, QWidget* parent = nullptr);

protected:
  void showEvent(QShowEvent* event) override;

private:
  void update();

  qFaceToBoneCase* m_case;
  QTableWidget* m_table;
  QLabel* m_note;
};

#endif
