#include "qFaceToBoneBrushPanel.h"

#include "qFaceToBoneToolTip.h"
#include "qFaceToBoneUnitSpin.h"

#include <Core/sculpting/brush.hpp>

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QToolButton>
#include <QVBoxLayout>

namespace
{

struct KindName
{
  f2b::BrushKind kind;
  const char *name, *what, *typical, *term;
};
const KindName kindNames[] = {
    {f2b::BrushKind::Grab, "Grab", "Drags the skin under the brush along", "2 to 10 mm",
     "translation with falloff"},
    {f2b::BrushKind::ElasticGrab, "Elastic", "Drags it as if the face were a soft solid",
     "Radius 20 mm", "regularised Kelvinlet"},
    {f2b::BrushKind::Draw, "Draw", "Builds up; with Ctrl it carves", "Strength 30 %", "inflate"},
    {f2b::BrushKind::Smooth, "Smooth", "Evens out what was sculpted; also with Shift",
     "Strength 50 %", "Laplacian of the displacement"},
    {f2b::BrushKind::Flatten, "Flatten", "Towards the mean plane under the brush", "Strength 30 %",
     "plane projection"},
    {f2b::BrushKind::Erase, "Erase", "Back to the patient's own face", "Strength 50 %",
     "displacement to zero"},
    {f2b::BrushKind::Mask, "Mask", "Protects skin from all brushes; with Ctrl it frees",
     "Over what must stay", "vertex mask"}};

/// The button that stands for no brush.
constexpr int turnId = -2;

} // namespace

qFaceToBoneBrushPanel::qFaceToBoneBrushPanel(QWidget* parent)
    : QWidget(parent), m_brush(std::make_unique<f2b::Brush>()), m_kinds(new QButtonGroup(this))
{
  auto* parts = new QVBoxLayout(this);
  parts->setContentsMargins(0, 0, 0, 0);
  parts->addWidget(makeBrushes());
  parts->addWidget(makeSettings());
  connect(m_kinds, &QButtonGroup::idClicked, this,
          [this](int)
          {
            readControls();
            emit sculptingChanged(isSculpting());
          });
  for (QDoubleSpinBox* box : {m_radius, m_strength, m_depth})
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
            &qFaceToBoneBrushPanel::readControls);
  for (QCheckBox* box : {m_symmetric, m_frontOnly, m_depthLimited})
    connect(box, &QCheckBox::toggled, this, &qFaceToBoneBrushPanel::readControls);
  connect(m_curve, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &qFaceToBoneBrushPanel::readControls);
  readControls();
}

qFaceToBoneBrushPanel::~qFaceToBoneBrushPanel() = default;

QWidget* qFaceToBoneBrushPanel::makeBrushes()
{
  auto* group = new QWidget;
  auto* grid = new QGridLayout(group);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(3);
  auto add = [&](const QString& text, const QString& tip, int id, int place)
  {
    auto* button = new QToolButton;
    button->setText(text);
    button->setToolTip(tip);
    button->setCheckable(true);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setMinimumWidth(40);
    m_kinds->addButton(button, id);
    grid->addWidget(button, place / 4, place % 4);
    return button;
  };
  add(tr("Turn"),
      qFaceToBoneToolTip(tr("No brush: the mouse turns the view"), tr("Left drag"), tr("camera")),
      turnId, 0)
      ->setChecked(true);
  int place = 1;
  for (const KindName& k : kindNames)
    add(tr(k.name), qFaceToBoneToolTip(tr(k.what), tr(k.typical), tr(k.term)),
        static_cast<int>(k.kind), place++);
  return group;
}

QWidget* qFaceToBoneBrushPanel::makeSettings()
{
  auto* group = new QWidget;
  auto* form = new QFormLayout(group);
  form->setContentsMargins(0, 0, 0, 0);
  m_radius = qFaceToBoneUnitSpin(f2b::Brush::least_radius_mm, f2b::Brush::most_radius_mm, 15, "mm");
  m_radius->setObjectName("radius");
  m_radius->setToolTip(qFaceToBoneToolTip(tr("How far the brush reaches along the skin"),
                                          tr("10 to 25 mm; [ and ], or Shift and wheel"),
                                          tr("geodesic radius")));
  m_strength = qFaceToBoneUnitSpin(2, 100, 100, "%", 5);
  m_strength->setToolTip(qFaceToBoneToolTip(tr("How strongly it acts"),
                                            tr("100 % for grabs; { and }, or Ctrl and wheel"),
                                            tr("share of the effect")));
  m_curve = new QComboBox;
  m_curve->setMinimumWidth(60);
  m_curve->addItems({tr("Smooth"), tr("Sphere"), tr("Linear"), tr("Sharp"), tr("Constant")});
  m_curve->setToolTip(
      qFaceToBoneToolTip(tr("How it fades towards its border"), tr("Smooth"), tr("falloff curve")));
  m_symmetric = new QCheckBox(tr("Both sides alike"));
  m_symmetric->setChecked(true);
  m_symmetric->setObjectName("symmetric");
  setMiddleGuessed(false);
  m_frontOnly = new QCheckBox(tr("Only skin that is seen"));
  m_frontOnly->setChecked(true);
  m_frontOnly->setToolTip(
      qFaceToBoneToolTip(tr("Leaves skin that faces away"), tr("On"), tr("front faces only")));
  m_depthLimited = new QCheckBox(tr("Not deeper than"));
  m_depth = qFaceToBoneUnitSpin(1, 100, 20, "mm");
  m_depthLimited->setToolTip(qFaceToBoneToolTip(tr("Leaves skin farther behind the cursor"),
                                                tr("20 mm"), tr("depth limit")));
  form->addRow(tr("Radius"), m_radius);
  form->addRow(tr("Strength"), m_strength);
  form->addRow(tr("Falloff"), m_curve);
  form->addRow(m_symmetric);
  form->addRow(m_frontOnly);
  form->addRow(m_depthLimited, m_depth);
  return group;
}

bool qFaceToBoneBrushPanel::isSymmetric() const
{
  return m_symmetric->isChecked();
}

void qFaceToBoneBrushPanel::setMiddleGuessed(bool guessed)
{
  m_symmetric->setText(guessed ? tr("Both sides alike (middle guessed)") : tr("Both sides alike"));
  m_symmetric->setToolTip(qFaceToBoneToolTip(
      guessed ? tr("Does the same on the other side of a middle that is guessed from the skin")
              : tr("Does the same on the other side"),
      guessed ? tr("Landmarks N, Or_R and Or_L say it better")
              : tr("On, unless the face is asymmetric"),
      tr("mid-sagittal symmetry")));
}

bool qFaceToBoneBrushPanel::isSculpting() const
{
  return m_kinds->checkedId() >= 0;
}

void qFaceToBoneBrushPanel::stopSculpting()
{
  if (!isSculpting())
    return;
  m_kinds->button(turnId)->setChecked(true);
  emit sculptingChanged(false);
}

void qFaceToBoneBrushPanel::readControls()
{
  if (m_updating)
    return;
  f2b::Brush& b = *m_brush;
  if (isSculpting())
    b.kind = static_cast<f2b::BrushKind>(m_kinds->checkedId());
  b.radius_mm = m_radius->value();
  b.strength = m_strength->value() / 100;
  b.curve = static_cast<f2b::Falloff>(m_curve->currentIndex());
  b.front_faces_only = m_frontOnly->isChecked();
  b.depth_mm =
      m_depthLimited->isChecked() ? m_depth->value() : std::numeric_limits<double>::infinity();
  emit brushChanged();
}

void qFaceToBoneBrushPanel::setBrush(const f2b::Brush& brush)
{
  m_updating = true;
  m_radius->setValue(brush.radius_mm);
  m_strength->setValue(100 * brush.strength);
  m_updating = false;
  m_brush->radius_mm = brush.radius_mm;
  m_brush->strength = brush.strength;
}
