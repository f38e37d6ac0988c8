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
#include <QToolButton>
#include <QVBoxLayout>

namespace
{

/// The coordinates of a movement.
const struct
{
  const char *name, *what, *term;
} columns[] = {{"right", "To the patient's right", "R"},
               {"forward", "Forward", "A"},
               {"up", "Up", "S"},
               {"pitch", "Turn about the axis to the right", "about +R, right-handed"},
               {"roll", "Turn about the axis forward", "about +A, right-handed"},
               {"yaw", "Turn about the axis up", "about +S, right-handed"}};

/// Beyond this no movement is made by hand [mm, degrees].
constexpr double mostByHand[] = {40, 45};

QString unitOf(int coordinate)
{
  return coordinate < 3 ? QStringLiteral(" mm") : QString::fromUtf8("\xc2\xb0");
}

} // namespace

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
  m_hand->setObjectName("hand");
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

double qFaceToBonePlanPanel::shareShown() const
{
  return m_shown->value() / 100.0;
}

auto qFaceToBonePlanPanel::makeBox(const QString& fragment) -> FragmentBox
{
  FragmentBox made;
  made.fragment = fragment;
  made.box = new QGroupBox(fragment);
  auto* grid = new QGridLayout(made.box);
  for (int k = 0; k < 6; ++k)
  {
    auto* number = new QDoubleSpinBox;
    number->setRange(-mostByHand[k / 3], mostByHand[k / 3]);
    number->setDecimals(2);
    number->setSingleStep(0.5);
    number->setMinimumWidth(60);
    number->setSuffix(unitOf(k));
    number->setKeyboardTracking(false);
    number->setObjectName(columns[k].name);
    number->setToolTip(qFaceToBoneToolTip(
        tr(columns[k].what), k < 3 ? tr("0 to 12 mm") : tr("0 to 5 degrees"), tr(columns[k].term)));
    made.numbers[k] = number;
    grid->addWidget(new QLabel(tr(columns[k].name)), 2 * (k / 3), k % 3);
    grid->addWidget(number, 2 * (k / 3) + 1, k % 3);
  }
  made.restraint = new QLabel;
  made.restraint->setWordWrap(true);
  grid->addWidget(made.restraint, 4, 0, 1, 3);
  makeRules(made);
  auto* show = new QToolButton;
  show->setText(tr("Rules"));
  show->setObjectName("rules");
  show->setCheckable(true);
  show->setToolTip(qFaceToBoneToolTip(tr("What this piece may do: coordinates that stay, ranges"),
                                      tr("No roll and no yaw"), tr("movement rules")));
  grid->addWidget(show, 5, 0);
  grid->addWidget(made.rules, 6, 0, 1, 3);
  connect(show, &QToolButton::toggled, made.rules, &QWidget::setVisible);
  return made;
}

/// One row a coordinate: locked, or within a range.
void qFaceToBonePlanPanel::makeRules(FragmentBox& made)
{
  made.rules = new QWidget;
  made.rules->hide();
  auto* grid = new QGridLayout(made.rules);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(2);
  grid->addWidget(new QLabel(tr("locked")), 0, 1);
  grid->addWidget(new QLabel(tr("range [mm, degrees]")), 0, 2, 1, 3);
  for (int k = 0; k < 6; ++k)
  {
    made.locks[k] = new QCheckBox;
    made.locks[k]->setObjectName(QString("lock_%1").arg(columns[k].name));
    made.locks[k]->setToolTip(qFaceToBoneToolTip(tr("It stays at 0, in the plan and by hand"),
                                                 tr("Off"), tr("locked coordinate")));
    made.bounds[k] = new QCheckBox;
    made.bounds[k]->setObjectName(QString("bound_%1").arg(columns[k].name));
    made.bounds[k]->setToolTip(qFaceToBoneToolTip(tr("It stays within a range"), tr("Off"),
                                                  tr("bounds of the coordinate")));
    grid->addWidget(new QLabel(tr(columns[k].name)), k + 1, 0);
    grid->addWidget(made.locks[k], k + 1, 1);
    grid->addWidget(made.bounds[k], k + 1, 2);
    for (const bool isMost : {false, true})
    {
      auto* end = new QDoubleSpinBox;
      end->setRange(-mostByHand[k / 3], mostByHand[k / 3]);
      end->setDecimals(1);
      end->setMinimumWidth(60);
      end->setKeyboardTracking(false);
      end->setValue(isMost ? 10 : -10);
      end->setObjectName(QString(isMost ? "most_%1" : "least_%1").arg(columns[k].name));
      end->setToolTip(qFaceToBoneToolTip(isMost ? tr("The most that is allowed")
                                                : tr("The least that is allowed"),
                                         k < 3 ? tr("10 mm") : tr("5 degrees"), tr("bound")));
      (isMost ? made.most : made.least)[k] = end;
      grid->addWidget(end, k + 1, isMost ? 4 : 3);
    }
  }
}

void qFaceToBonePlanPanel::applyRule(const FragmentBox& box, int k)
{
  qFaceToBoneRule rule;
  rule.locked = box.locks[k]->isChecked();
  rule.bounded = box.bounds[k]->isChecked();
  rule.least = box.least[k]->value();
  rule.most = box.most[k]->value();
  if (m_case->cuts()->setRule(box.fragment, static_cast<std::size_t>(k), rule))
    return;
  emit refused(m_case->cuts()->error());
  update();
}

void qFaceToBonePlanPanel::updateRules(const FragmentBox& box)
{
  const qFaceToBoneRules rules = m_case->cuts()->rules(box.fragment);
  box.restraint->setText(rules.restraint);
  box.restraint->setVisible(!rules.restraint.isEmpty());
  for (int k = 0; k < 6; ++k)
  {
    const auto coordinate = static_cast<std::size_t>(k);
    const qFaceToBoneRule& rule = rules.coordinates[coordinate];
    const QSignalBlocker lock(box.locks[k]), bound(box.bounds[k]), least(box.least[k]),
        most(box.most[k]), number(box.numbers[k]);
    const bool free = rules.restraint.isEmpty();
    box.locks[k]->setChecked(rule.locked);
    box.locks[k]->setEnabled(free);
    box.bounds[k]->setChecked(rule.bounded && !rule.locked);
    box.bounds[k]->setEnabled(free && !rule.locked);
    if (rule.bounded)
    {
      box.least[k]->setValue(rule.least);
      box.most[k]->setValue(rule.most);
    }
    for (QDoubleSpinBox* end : {box.least[k], box.most[k]})
      end->setEnabled(free && rule.bounded && !rule.locked);
    const double wide = mostByHand[k / 3];
    box.numbers[k]->setEnabled(!rules.isLocked(coordinate));
    if (!rules.isLocked(coordinate)) // else a planned movement would be cut off
      box.numbers[k]->setRange(rules.within(coordinate, -wide, wide),
                               rules.within(coordinate, wide, wide));
  }
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
      for (int k = 0; k < 6; ++k)
      {
        for (QCheckBox* check : {box.locks[k], box.bounds[k]})
          connect(check, &QCheckBox::clicked, this, [this, box, k] { applyRule(box, k); });
        for (QDoubleSpinBox* end : {box.least[k], box.most[k]})
          connect(end, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
                  [this, box, k] { applyRule(box, k); });
      }
    }
  }
  for (const FragmentBox& box : m_fragments)
    updateRules(box);
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
