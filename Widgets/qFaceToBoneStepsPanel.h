#ifndef qFaceToBoneStepsPanel_h
#define qFaceToBoneStepsPanel_h

#include "qFaceToBoneCase.h"

#include <QWidget>

class QLabel;
class QPushButton;

/// Which steps lead to a plan, which are done, and what is next? Six numbered rows.
class qFaceToBoneStepsPanel : public QWidget
{
  Q_OBJECT

public:
  qFaceToBoneStepsPanel(qFaceToBoneCase* work, QWidget* parent = nullptr);

  int currentStep() const { return m_current; }
  void setCurrentStep(int step);
  /// The button that does a step; for tests and shortcuts.
  QPushButton* actionButton(int step) const { return m_rows[step].action; }

signals:
  void currentStepChanged(int step);
  void actionWanted(int step);

protected:
  bool eventFilter(QObject* object, QEvent* event) override;

private:
  struct Row
  {
    QWidget* frame = nullptr;
    QLabel* number = nullptr;
    QLabel* text = nullptr;
    QPushButton* action = nullptr;
  };
  Row makeRow(int step);
  void updateRows();

  qFaceToBoneCase* m_case;
  Row m_rows[qFaceToBoneCase::StepCount];
  int m_current = 0;
};

#endif
