#ifndef qFaceToBoneMeasuresPanel_h
#define qFaceToBoneMeasuresPanel_h

#include <QWidget>

class QLabel;
class QPushButton;
class QTableWidget;
class qFaceToBoneCase;

/// Which angles and distances does the face have before, and as planned? And between which points
/// does the surgeon measure?
class qFaceToBoneMeasuresPanel : public QWidget
{
  Q_OBJECT

public:
  qFaceToBoneMeasuresPanel(qFaceToBoneCase* work, QWidget* parent = nullptr);

  /// The ruler that was wanted is there.
  void rulerPlaced();

signals:
  /// A ruler of so many points is to be placed in the 3D view; 0: none.
  void rulerWanted(int points);

protected:
  void showEvent(QShowEvent* event) override;

private:
  void update();

  qFaceToBoneCase* m_case;
  QTableWidget* m_table;
  QLabel* m_note;
  QPushButton *m_distance, *m_angle;
};

#endif
