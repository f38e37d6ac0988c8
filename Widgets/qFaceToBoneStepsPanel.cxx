#include "qFaceToBoneStepsPanel.h"

#include "qFaceToBoneToolTip.h"

#include <QEvent>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace
{

struct StepName
{
  const char *name, *what, *typical, *term;
};
constexpr StepName stepNames[qFaceToBoneCase::StepCount] = {
    {"CT", "The patient's CT and landmarks", "Slices of 1 mm or less", "case file, DICOM series"},
    {"Surfaces", "Finds skin and bone in the CT", "10 to 60 seconds", "segmentation"},
    {"Cuts", "Cuts the bone and meshes the tissue", "One to four fragments", "osteotomies"},
    {"Target", "The face that the patient should have", "3 to 15 mm of change",
     "pre-specified target face"},
    {"Plan", "How each fragment must move for it", "5 to 15 mm", "inverse planning, rigid fit"},
    {"Report", "Pictures and figures in one file", "report.html", "planning report"}};

} // namespace

qFaceToBoneStepsPanel::qFaceToBoneStepsPanel(qFaceToBoneCase* work, QWidget* parent)
    : QWidget(parent), m_case(work)
{
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(2);
  for (int step = 0; step < qFaceToBoneCase::StepCount; ++step)
  {
    m_rows[step] = makeRow(step);
    rows->addWidget(m_rows[step].frame);
  }
  connect(m_case, &qFaceToBoneCase::changed, this, &qFaceToBoneStepsPanel::updateRows);
  updateRows();
}

qFaceToBoneStepsPanel::Row qFaceToBoneStepsPanel::makeRow(int step)
{
  Row row;
  row.frame = new QFrame;
  row.frame->setObjectName("step");
  row.frame->setAttribute(Qt::WA_StyledBackground);
  row.frame->setCursor(Qt::PointingHandCursor);
  row.frame->installEventFilter(this);
  const StepName& n = stepNames[step];
  row.frame->setToolTip(qFaceToBoneToolTip(tr(n.what), tr(n.typical), tr(n.term)));
  row.number = new QLabel;
  row.number->setFixedSize(24, 24);
  row.number->setAlignment(Qt::AlignCenter);
  row.text = new QLabel;
  row.text->setTextFormat(Qt::RichText);
  row.text->setWordWrap(true);
  row.action = new QPushButton;
  row.action->setFixedWidth(64);
  row.action->setObjectName(QString("action%1").arg(step));
  connect(row.action, &QPushButton::clicked, this,
          [this, step]
          {
            setCurrentStep(step);
            emit actionWanted(step);
          });
  auto* line = new QHBoxLayout(row.frame);
  line->setContentsMargins(6, 3, 6, 3);
  line->addWidget(row.number);
  line->addWidget(row.text, 1);
  line->addWidget(row.action);
  return row;
}

bool qFaceToBoneStepsPanel::eventFilter(QObject* object, QEvent* event)
{
  if (event->type() == QEvent::MouseButtonPress)
    for (int step = 0; step < qFaceToBoneCase::StepCount; ++step)
      if (object == m_rows[step].frame)
        setCurrentStep(step);
  return QWidget::eventFilter(object, event);
}

void qFaceToBoneStepsPanel::setCurrentStep(int step)
{
  const bool other = m_current != step;
  m_current = step;
  updateRows();
  if (other)
    emit currentStepChanged(step);
}

void qFaceToBoneStepsPanel::updateRows()
{
  bool nextFound = false;
  for (int step = 0; step < qFaceToBoneCase::StepCount; ++step)
  {
    const auto state = m_case->state(static_cast<qFaceToBoneCase::Step>(step));
    const bool next = !state.done && state.possible && !nextFound;
    nextFound = nextFound || next;
    Row& row = m_rows[step];
    row.number->setText(state.done ? QString::fromUtf8("\xe2\x9c\x93") : QString::number(step + 1));
    row.number->setStyleSheet(
        QString("border-radius:12px; font-weight:bold; color:white; background:%1")
            .arg(state.done ? "#2e7d4f"
                 : next     ? "#1f5fa8"
                            : "#8a929c"));
    row.text->setText(QString("<b>%1</b><br><span style='color:#4a5058'>%2</span>")
                          .arg(tr(stepNames[step].name), state.text.toHtmlEscaped()));
    row.action->setText(state.action);
    row.action->setEnabled(state.possible);
    row.action->setVisible(!state.action.isEmpty());
    row.action->setStyleSheet(next ? "font-weight:bold" : "");
    row.frame->setStyleSheet(step == m_current ? "#step{background:#dbe7f5;border-radius:5px}"
                                               : "#step{background:transparent}");
  }
}
