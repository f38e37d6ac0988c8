#include "qFaceToBoneSculptPanel.h"

#include "qFaceToBoneBrushPanel.h"
#include "qFaceToBoneCase.h"
#include "qFaceToBoneToolTip.h"
#include "qFaceToBoneUnitSpin.h"

#include <Core/sculpting/sculpting_session.hpp>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

qFaceToBoneSculptPanel::qFaceToBoneSculptPanel(qFaceToBoneCase* work, QWidget* parent)
    : QWidget(parent), m_case(work), m_brush(std::make_unique<f2b::Brush>()),
      m_brushes(new qFaceToBoneBrushPanel)
{
  auto* parts = new QVBoxLayout(this);
  parts->setContentsMargins(4, 4, 4, 4);
  parts->addWidget(m_brushes);
  parts->addWidget(makeLandmarkMove());
  parts->addWidget(makeMaskAndFiles());
  parts->addStretch(1);
  connect(m_brushes, &qFaceToBoneBrushPanel::brushChanged, this,
          &qFaceToBoneSculptPanel::readControls);
  connect(m_brushes, &qFaceToBoneBrushPanel::sculptingChanged, this,
          &qFaceToBoneSculptPanel::sculptingChanged);
  connect(m_case, &qFaceToBoneCase::loaded, this, &qFaceToBoneSculptPanel::updateLandmarks);
  connect(m_case, &qFaceToBoneCase::landmarksChanged, this,
          &qFaceToBoneSculptPanel::updateLandmarks);
  updateLandmarks();
}

qFaceToBoneSculptPanel::~qFaceToBoneSculptPanel() = default;

QWidget* qFaceToBoneSculptPanel::makeLandmarkMove()
{
  auto* group = new QGroupBox(tr("Move a landmark"));
  auto* grid = new QGridLayout(group);
  m_landmark = new QComboBox;
  m_landmark->setMinimumWidth(60);
  m_landmark->setObjectName("landmark");
  m_landmark->setToolTip(qFaceToBoneToolTip(tr("The point of the face that moves"),
                                            tr("sn: subnasale; Pg': chin"),
                                            tr("soft-tissue landmark")));
  grid->addWidget(m_landmark, 0, 0, 1, 3);
  static const char* const axes[] = {"right", "forward", "up"};
  for (int k = 0; k < 3; ++k)
  {
    m_move[k] = qFaceToBoneUnitSpin(-40, 40, 0, "mm", 0.5);
    m_move[k]->setObjectName(QString("move_%1").arg(axes[k]));
    m_move[k]->setToolTip(qFaceToBoneToolTip(tr("How far it goes %1").arg(tr(axes[k])),
                                             tr("4 mm forward"), tr("R, A, S")));
    grid->addWidget(new QLabel(tr(axes[k])), 1, k);
    grid->addWidget(m_move[k], 2, k);
  }
  m_moveRadius = qFaceToBoneUnitSpin(5, 100, 35, "mm", 5);
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
  return m_brushes->isSymmetric();
}

bool qFaceToBoneSculptPanel::isSculpting() const
{
  return m_brushes->isSculpting();
}

void qFaceToBoneSculptPanel::readControls()
{
  *m_brush = m_brushes->brush();
  if (m_brushes->isSymmetric())
    m_brush->symmetry = m_case->symmetryPlane();
  emit brushChanged();
}

void qFaceToBoneSculptPanel::setBrush(const f2b::Brush& brush)
{
  m_brushes->setBrush(brush);
  m_brush->radius_mm = brush.radius_mm;
  m_brush->strength = brush.strength;
}

void qFaceToBoneSculptPanel::updateLandmarks()
{
  m_landmark->clear();
  m_landmark->addItems(m_case->faceLandmarks());
  const int sn = m_landmark->findText("sn");
  m_landmark->setCurrentIndex(sn >= 0 ? sn : 0);
  m_brushes->setMiddleGuessed(m_case->isSymmetryGuessed());
  readControls();
}

void qFaceToBoneSculptPanel::moveLandmark()
{
  const std::array<double, 3> by{m_move[0]->value(), m_move[1]->value(), m_move[2]->value()};
  if (!m_case->moveLandmark(m_landmark->currentText(), by, m_moveRadius->value()))
    QMessageBox::warning(this, tr("Move a landmark"), m_case->error());
}
