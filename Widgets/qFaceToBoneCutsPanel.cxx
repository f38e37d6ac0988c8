#include "qFaceToBoneCutsPanel.h"

#include "qFaceToBoneCase.h"
#include "qFaceToBoneToolTip.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>

qFaceToBoneCutsPanel::qFaceToBoneCutsPanel(qFaceToBoneCase* work, QWidget* parent)
    : QWidget(parent), m_case(work), m_planes(new QCheckBox(tr("Show and drag the planes"))),
      m_template(new QComboBox), m_kerf(new QDoubleSpinBox), m_density(new QDoubleSpinBox),
      m_explode(new QSlider(Qt::Horizontal)), m_fragments(new QLabel)
{
  m_template->setToolTip(qFaceToBoneToolTip(tr("Where the bone is cut"), tr("le-fort-1"),
                                            tr("osteotomy template, placed by landmarks")));
  for (QWidget* control : {static_cast<QWidget*>(m_template), static_cast<QWidget*>(m_kerf),
                           static_cast<QWidget*>(m_density)})
    control->setMinimumWidth(60);
  m_kerf->setRange(0, 5);
  m_kerf->setSingleStep(0.1);
  m_kerf->setSuffix(" mm");
  m_kerf->setToolTip(
      qFaceToBoneToolTip(tr("Width of bone that the saw takes"), tr("0.5 to 1 mm"), tr("kerf")));
  m_density->setRange(0.05, 4);
  m_density->setSingleStep(0.05);
  m_density->setToolTip(qFaceToBoneToolTip(tr("How finely the tissue is meshed"),
                                           tr("0.3 to try out, 1 for the final plan"),
                                           tr("elements, relative to the reference size")));
  m_explode->setRange(0, 40);
  m_explode->setToolTip(qFaceToBoneToolTip(tr("Draws the fragments apart, to see the cuts"),
                                           tr("15 mm"), tr("exploded view")));
  m_fragments->setWordWrap(true);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(4, 4, 4, 4);
  form->addRow(tr("Cut"), m_template);
  form->addRow(tr("Kerf"), m_kerf);
  form->addRow(tr("Mesh density"), m_density);
  form->addRow(tr("Explode"), m_explode);
  m_planes->setObjectName("planes");
  m_explode->setObjectName("explode");
  m_planes->setToolTip(qFaceToBoneToolTip(tr("Cut planes with handles in the 3D view"),
                                          tr("Drag the middle, the edges, the arrow"),
                                          tr("bounded planes")));
  auto* add = new QPushButton(tr("Add a plane"));
  auto* remove = new QPushButton(tr("Remove the last"));
  add->setToolTip(qFaceToBoneToolTip(tr("A plane through the slices' crosshair"),
                                     tr("60 x 60 mm, level"), tr("bounded plane")));
  form->addRow(m_planes);
  form->addRow(add, remove);
  form->addRow(m_fragments);
  connect(m_planes, &QCheckBox::toggled, this, &qFaceToBoneCutsPanel::planesShown);
  connect(add, &QPushButton::clicked, this,
          [this]
          {
            m_planes->setChecked(true);
            emit planeWanted();
          });
  connect(remove, &QPushButton::clicked, this,
          [this] { m_case->removeCutPlane(m_case->cutPlaneCount() - 1); });
  connect(m_template, QOverload<int>::of(&QComboBox::activated), this,
          [this](int) { m_case->setCutTemplate(m_template->currentText()); });
  connect(m_kerf, QOverload<double>::of(&QDoubleSpinBox::valueChanged), m_case,
          &qFaceToBoneCase::setKerf);
  connect(m_density, QOverload<double>::of(&QDoubleSpinBox::valueChanged), m_case,
          &qFaceToBoneCase::setMeshDensity);
  connect(m_explode, &QSlider::valueChanged, this, &qFaceToBoneCutsPanel::explodeChanged);
  connect(m_case, &qFaceToBoneCase::changed, this, &qFaceToBoneCutsPanel::update);
  m_template->addItems(m_case->templates());
  update();
}

bool qFaceToBoneCutsPanel::showsPlanes() const
{
  return m_planes->isChecked();
}

void qFaceToBoneCutsPanel::update()
{
  const QSignalBlocker kerf(m_kerf), density(m_density);
  m_template->setCurrentIndex(m_template->findText(m_case->cutTemplate()));
  m_kerf->setValue(m_case->kerf());
  m_density->setValue(m_case->meshDensity());
  setEnabled(m_case->isOpen() && !m_case->task()->isRunning());
  QStringList names;
  for (const qFaceToBoneObject& o : m_case->objects()->all())
    if (o.key.startsWith("fragment/"))
      names << o.name;
  m_fragments->setText(names.isEmpty() ? tr("Not cut yet. Press Cut to see the fragments.")
                                       : tr("Fragments: %1").arg(names.join(", ")));
}
