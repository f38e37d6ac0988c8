#include "qFaceToBonePlanPanel.h"

#include "qFaceToBoneCase.h"
#include "qFaceToBoneToolTip.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

qFaceToBonePlanPanel::qFaceToBonePlanPanel(qFaceToBoneCase* work, QWidget* parent)
    : QWidget(parent), m_case(work), m_follow(new QCheckBox(tr("Bones follow the brush"))),
      m_hand(new QCheckBox(tr("Move the bones by hand"))), m_shown(new QSlider(Qt::Horizontal)),
      m_boxes(new QVBoxLayout), m_state(new QLabel), m_notes(new QLabel)
{
  m_follow->setToolTip(qFaceToBoneToolTip(tr("While the face is sculpted the bones move"), tr("On"),
                                          tr("live linearised operator")));
  m_shown->setRange(0, 100);
  m_shown->setValue(100);
  m_shown->setToolTip(qFaceToBoneToolTip(tr("Shows the bones between rest and plan"), tr("100 %"),
                                         tr("share of the movement")));
  m_state->setWordWrap(true);
  m_notes->setWordWrap(true);
  m_notes->setStyleSheet("color:#7a4a00");
  auto* parts = new QVBoxLayout(this);
  parts->setContentsMargins(4, 4, 4, 4);
  m_hand->setToolTip(qFaceToBoneToolTip(tr("Arrows and rings in the 3D view; the face follows"),
                                        tr("Drag; with Ctrl in steps of 0.5"),
                                        tr("forward prediction")));
  parts->addWidget(m_follow);
  parts->addWidget(m_hand);
  parts->addWidget(new QLabel(tr("Before  -  planned")));
  parts->addWidget(m_shown);
  parts->addLayout(m_boxes);
  parts->addWidget(m_state);
  parts->addWidget(m_notes);
  parts->addStretch(1);
  connect(m_follow, &QCheckBox::clicked, m_case, &qFaceToBoneCase::setFollowsSculpting);
  connect(m_hand, &QCheckBox::toggled, this, &qFaceToBonePlanPanel::handChanged);
  connect(m_shown, &QSlider::valueChanged, this,
          [this](int percent) { m_case->setMovementShown(percent / 100.0); });
  connect(m_case, &qFaceToBoneCase::planChanged, this, &qFaceToBonePlanPanel::update);
  connect(m_case, &qFaceToBoneCase::changed, this, &qFaceToBonePlanPanel::update);
  update();
}

auto qFaceToBonePlanPanel::makeBox(const QString& fragment) -> FragmentBox
{
  static const struct
  {
    const char *name, *what, *term;
  } columns[] = {{"right", "To the patient's right", "R"},
                 {"forward", "Forward", "A"},
                 {"up", "Up", "S"},
                 {"pitch", "Turn about the axis to the right", "about +R, right-handed"},
                 {"roll", "Turn about the axis forward", "about +A, right-handed"},
                 {"yaw", "Turn about the axis up", "about +S, right-handed"}};
  FragmentBox made;
  made.fragment = fragment;
  made.box = new QGroupBox(fragment);
  auto* grid = new QGridLayout(made.box);
  for (int k = 0; k < 6; ++k)
  {
    auto* number = new QDoubleSpinBox;
    number->setRange(-40, 40);
    number->setDecimals(2);
    number->setSingleStep(0.5);
    number->setMinimumWidth(60);
    number->setSuffix(k < 3 ? " mm" : QString::fromUtf8("\xc2\xb0"));
    number->setKeyboardTracking(false);
    number->setObjectName(columns[k].name);
    number->setToolTip(qFaceToBoneToolTip(
        tr(columns[k].what), k < 3 ? tr("0 to 12 mm") : tr("0 to 5 degrees"), tr(columns[k].term)));
    made.numbers[k] = number;
    grid->addWidget(new QLabel(tr(columns[k].name)), 2 * (k / 3), k % 3);
    grid->addWidget(number, 2 * (k / 3) + 1, k % 3);
  }
  return made;
}

void qFaceToBonePlanPanel::apply(const FragmentBox& box)
{
  qFaceToBoneCase::Movement movement;
  movement.fragment = box.fragment;
  for (std::size_t k = 0; k < 3; ++k)
  {
    movement.translation[k] = box.numbers[k]->value();
    movement.rotation[k] = box.numbers[k + 3]->value();
  }
  m_case->setMovement(movement);
}

void qFaceToBonePlanPanel::update()
{
  const auto movements = m_case->movements();
  bool same = movements.size() == m_fragments.size();
  for (std::size_t f = 0; same && f < movements.size(); ++f)
    same = movements[f].fragment == m_fragments[f].fragment;
  if (!same)
  {
    for (const FragmentBox& box : m_fragments)
      box.box->deleteLater();
    m_fragments.clear();
    for (const auto& movement : movements)
    {
      m_fragments.push_back(makeBox(movement.fragment));
      m_boxes->addWidget(m_fragments.back().box);
      const FragmentBox box = m_fragments.back();
      for (QDoubleSpinBox* number : box.numbers)
        connect(number, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
                [this, box] { apply(box); });
    }
  }
  for (std::size_t f = 0; f < movements.size(); ++f)
    for (std::size_t k = 0; k < 6; ++k)
    {
      QDoubleSpinBox* number = m_fragments[f].numbers[k];
      const QSignalBlocker blocker(number);
      if (!number->hasFocus())
        number->setValue(k < 3 ? movements[f].translation[k] : movements[f].rotation[k - 3]);
    }
  m_follow->setChecked(m_case->followsSculpting());
  m_follow->setEnabled(m_case->isLive());
  m_hand->setEnabled(m_case->isLive() && !movements.empty());
  m_state->setText(m_case->planText());
  m_notes->setText(m_case->planNotes().join("\n"));
}
