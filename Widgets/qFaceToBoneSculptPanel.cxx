#include "qFaceToBoneSculptPanel.h"

#include "qFaceToBoneCase.h"
#include "qFaceToBoneToolTip.h"

#include <Core/sculpting/sculpting_session.hpp>

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
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

QDoubleSpinBox* spin(double low, double high, double value, const QString& unit, double step = 1)
{
  auto* box = new QDoubleSpinBox;
  box->setRange(low, high);
  box->setDecimals(1);
  box->setSingleStep(step);
  box->setValue(value);
  box->setSuffix(" " + unit);
  box->setKeyboardTracking(false);
  box->setMinimumWidth(60); // else three of them are wider than the panel
  return box;
}

} // namespace

qFaceToBoneSculptPanel::qFaceToBoneSculptPanel(qFaceToBoneCase* work, QWidget* parent)
    : QWidget(parent), m_case(work), m_brush(std::make_unique<f2b::Brush>()),
      m_kinds(new QButtonGroup(this))
{
  auto* parts = new QVBoxLayout(this);
  parts->setContentsMargins(4, 4, 4, 4);
  parts->addWidget(makeBrushes());
  parts->addWidget(makeSettings());
  parts->addWidget(makeLandmarkMove());
  parts->addWidget(makeMaskAndFiles());
  parts->addStretch(1);
  connect(m_kinds, &QButtonGroup::idClicked, this,
          [this](int)
          {
            readControls();
            emit sculptingChanged(isSculpting());
          });
  for (QDoubleSpinBox* box : {m_radius, m_strength, m_depth})
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
            &qFaceToBoneSculptPanel::readControls);
  for (QCheckBox* box : {m_symmetric, m_frontOnly, m_depthLimited})
    connect(box, &QCheckBox::toggled, this, &qFaceToBoneSculptPanel::readControls);
  connect(m_curve, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &qFaceToBoneSculptPanel::readControls);
  connect(m_case, &qFaceToBoneCase::loaded, this, &qFaceToBoneSculptPanel::updateLandmarks);
  connect(m_case, &qFaceToBoneCase::landmarksChanged, this,
          &qFaceToBoneSculptPanel::updateLandmarks);
  readControls();
}

qFaceToBoneSculptPanel::~qFaceToBoneSculptPanel() = default;

QWidget* qFaceToBoneSculptPanel::makeBrushes()
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
      -2, 0)
      ->setChecked(true);
  int place = 1;
  for (const KindName& k : kindNames)
    add(tr(k.name), qFaceToBoneToolTip(tr(k.what), tr(k.typical), tr(k.term)),
        static_cast<int>(k.kind), place++);
  return group;
}

QWidget* qFaceToBoneSculptPanel::makeSettings()
{
  auto* group = new QWidget;
  auto* form = new QFormLayout(group);
  form->setContentsMargins(0, 0, 0, 0);
  m_radius = spin(f2b::Brush::least_radius_mm, f2b::Brush::most_radius_mm, 15, "mm");
  m_radius->setToolTip(qFaceToBoneToolTip(tr("How far the brush reaches along the skin"),
                                          tr("10 to 25 mm; [ and ], or Shift and wheel"),
                                          tr("geodesic radius")));
  m_strength = spin(2, 100, 100, "%", 5);
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
  m_symmetric->setToolTip(qFaceToBoneToolTip(tr("Does the same on the other side"),
                                             tr("On, unless the face is asymmetric"),
                                             tr("mid-sagittal symmetry")));
  m_frontOnly = new QCheckBox(tr("Only skin that is seen"));
  m_frontOnly->setChecked(true);
  m_frontOnly->setToolTip(
      qFaceToBoneToolTip(tr("Leaves skin that faces away"), tr("On"), tr("front faces only")));
  m_depthLimited = new QCheckBox(tr("Not deeper than"));
  m_depth = spin(1, 100, 20, "mm");
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

QWidget* qFaceToBoneSculptPanel::makeLandmarkMove()
{
  auto* group = new QGroupBox(tr("Move a landmark"));
  auto* grid = new QGridLayout(group);
  m_landmark = new QComboBox;
  m_landmark->setMinimumWidth(60);
  m_landmark->setToolTip(qFaceToBoneToolTip(tr("The point of the face that moves"),
                                            tr("sn: subnasale; Pg': chin"),
                                            tr("soft-tissue landmark")));
  grid->addWidget(m_landmark, 0, 0, 1, 3);
  static const char* const axes[] = {"right", "forward", "up"};
  for (int k = 0; k < 3; ++k)
  {
    m_move[k] = spin(-40, 40, 0, "mm", 0.5);
    m_move[k]->setToolTip(qFaceToBoneToolTip(tr("How far it goes %1").arg(tr(axes[k])),
                                             tr("4 mm forward"), tr("R, A, S")));
    grid->addWidget(new QLabel(tr(axes[k])), 1, k);
    grid->addWidget(m_move[k], 2, k);
  }
  m_moveRadius = spin(5, 100, 35, "mm", 5);
  m_moveRadius->setToolTip(qFaceToBoneToolTip(tr("How far the face around follows"), tr("35 mm"),
                                              tr("radius of the warp")));
  auto* move = new QPushButton(tr("Move"));
  move->setObjectName("moveLandmark");
  connect(move, &QPushButton::clicked, this, &qFaceToBoneSculptPanel::moveLandmark);
  grid->addWidget(new QLabel(tr("within")), 3, 0);
  grid->addWidget(m_moveRadius, 3, 1);
  grid->addWidget(move, 3, 2);
  m_handles = new QCheckBox(tr("Handles in the 3D view"));
  m_handles->setObjectName("handles");
  m_handles->setToolTip(qFaceToBoneToolTip(tr("Drag a landmark and the face follows smoothly"),
                                           tr("From the side: sn forward"),
                                           tr("landmark warp within the radius")));
  grid->addWidget(m_handles, 4, 0, 1, 3);
  connect(m_handles, &QCheckBox::toggled, this, &qFaceToBoneSculptPanel::handlesShown);
  return group;
}

QWidget* qFaceToBoneSculptPanel::makeMaskAndFiles()
{
  auto* group = new QWidget;
  auto* grid = new QGridLayout(group);
  grid->setContentsMargins(0, 0, 0, 0);
  auto add = [&](const QString& text, int row, int column, auto action)
  {
    auto* button = new QPushButton(text);
    connect(button, &QPushButton::clicked, this, action);
    grid->addWidget(button, row, column);
  };
  auto mask = [this](auto change)
  {
    return [this, change]
    {
      if (const auto session = m_case->sculpting())
      {
        change(*session);
        m_case->sculpted(false);
      }
    };
  };
  add(tr("Clear mask"), 0, 0, mask([](f2b::SculptingSession& s) { s.fill_mask(0); }));
  add(tr("Invert mask"), 0, 1, mask([](f2b::SculptingSession& s) { s.invert_mask(); }));
  add(tr("Import..."), 1, 0,
      [this]
      {
        const QString path = QFileDialog::getOpenFileName(this, tr("Edited skin"), m_case->folder(),
                                                          tr("Surfaces (*.vtp *.ply *.obj)"));
        if (!path.isEmpty() && !m_case->importTarget(path))
          QMessageBox::warning(this, tr("Import"), m_case->error());
      });
  add(tr("Export..."), 1, 1,
      [this]
      {
        const QString path = QFileDialog::getSaveFileName(
            this, tr("Target face"), m_case->folder() + "/face.vtp", tr("Surfaces (*.vtp *.ply)"));
        if (!path.isEmpty() && !m_case->exportTarget(path))
          QMessageBox::warning(this, tr("Export"), m_case->error());
      });
  return group;
}

bool qFaceToBoneSculptPanel::showsHandles() const
{
  return m_handles->isChecked();
}

double qFaceToBoneSculptPanel::warpRadius() const
{
  return m_moveRadius->value();
}

bool qFaceToBoneSculptPanel::isSymmetric() const
{
  return m_symmetric->isChecked();
}

bool qFaceToBoneSculptPanel::isSculpting() const
{
  return m_kinds->checkedId() >= 0;
}

void qFaceToBoneSculptPanel::readControls()
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
  b.symmetry.reset();
  if (m_symmetric->isChecked())
    b.symmetry = m_case->symmetryPlane();
  emit brushChanged();
}

void qFaceToBoneSculptPanel::setBrush(const f2b::Brush& brush)
{
  m_updating = true;
  m_radius->setValue(brush.radius_mm);
  m_strength->setValue(100 * brush.strength);
  m_updating = false;
  m_brush->radius_mm = brush.radius_mm;
  m_brush->strength = brush.strength;
}

void qFaceToBoneSculptPanel::updateLandmarks()
{
  m_landmark->clear();
  m_landmark->addItems(m_case->faceLandmarks());
  const int sn = m_landmark->findText("sn");
  m_landmark->setCurrentIndex(sn >= 0 ? sn : 0);
  readControls();
}

void qFaceToBoneSculptPanel::moveLandmark()
{
  const std::array<double, 3> by{m_move[0]->value(), m_move[1]->value(), m_move[2]->value()};
  if (!m_case->moveLandmark(m_landmark->currentText(), by, m_moveRadius->value()))
    QMessageBox::warning(this, tr("Move a landmark"), m_case->error());
}
