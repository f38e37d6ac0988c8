#ifndef qFaceToBoneSparedPanel_h
#define qFaceToBoneSparedPanel_h

#include <QGroupBox>

class QDoubleSpinBox;
class QTreeWidget;
class qFaceToBoneCase;

/// What should the saw spare, and how near does it come?
class qFaceToBoneSparedPanel : public QGroupBox
{
  Q_OBJECT

public:
  qFaceToBoneSparedPanel(qFaceToBoneCase* work, QWidget* parent = nullptr);

  /// Takes over a curve or a surface. \return false if it cannot be read (see `refused`)
  bool import(const QString& file);

signals:
  void refused(const QString& why);

private:
  void choose();
  void update();
  void updateMargin();
  int chosen() const;

  qFaceToBoneCase* m_case;
  QTreeWidget* m_list;
  QDoubleSpinBox* m_margin;
};

#endif
