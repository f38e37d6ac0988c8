#include "qFaceToBoneLandmarksPanel.h"

#include "qFaceToBoneCase.h"
#include "qFaceToBoneToolTip.h"

#include <QFileDialog>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>

#include <algorithm>

qFaceToBoneLandmarksPanel::qFaceToBoneLandmarksPanel(qFaceToBoneCase* work, QWidget* parent)
    : QWidget(parent), m_case(work), m_note(new QLabel), m_list(new QTreeWidget),
      m_place(new QPushButton(tr("Place in 3D"))), m_here(new QPushButton(tr("At crosshair"))),
      m_remove(new QPushButton(tr("Remove")))
{
  m_note->setWordWrap(true);
  m_list->setHeaderLabels({tr("Landmark"), tr("What it is")});
  m_list->setRootIsDecorated(false);
  m_list->header()->resizeSection(0, 74);
  m_list->setMinimumHeight(110);
  m_place->setCheckable(true);
  m_place->setObjectName("placeLandmark");
  m_here->setObjectName("landmarkAtCrosshair");
  m_list->setObjectName("landmarks");
  m_place->setToolTip(qFaceToBoneToolTip(tr("The next click on the surface puts it there"),
                                         tr("Bone for N, ANS, Or; skin for sn, Pg'"),
                                         tr("landmark placement")));
  m_here->setToolTip(qFaceToBoneToolTip(tr("Puts it where the slices' lines cross"),
                                        tr("For points inside, such as S"), tr("crosshair")));
  m_remove->setToolTip(
      qFaceToBoneToolTip(tr("Takes the landmark away"), tr("Measures with it go"), tr("delete")));
  auto* load = new QPushButton(tr("Load..."));
  load->setToolTip(qFaceToBoneToolTip(tr("Takes landmarks from a file"), tr("landmarks.mrk.json"),
                                      tr("Slicer fiducials, by label")));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(4, 4, 4, 4);
  grid->addWidget(m_note, 0, 0, 1, 2);
  grid->addWidget(m_list, 1, 0, 1, 2);
  grid->addWidget(m_place, 2, 0);
  grid->addWidget(m_here, 2, 1);
  grid->addWidget(m_remove, 3, 0);
  grid->addWidget(load, 3, 1);
  grid->setRowStretch(1, 1);
  connect(m_place, &QPushButton::toggled, this, &qFaceToBoneLandmarksPanel::placingChanged);
  connect(m_here, &QPushButton::clicked, this, [this] { emit crosshairWanted(current()); });
  connect(m_remove, &QPushButton::clicked, this,
          [this]
          {
            if (!m_case->removeLandmark(current()))
              QMessageBox::warning(this, tr("Landmarks"), m_case->error());
          });
  connect(load, &QPushButton::clicked, this, &qFaceToBoneLandmarksPanel::load);
  connect(m_list, &QTreeWidget::currentItemChanged, this,
          [this] { emit currentChanged(current()); });
  connect(m_case, &qFaceToBoneCase::landmarksChanged, this, &qFaceToBoneLandmarksPanel::update);
  connect(m_case, &qFaceToBoneCase::changed, this, &qFaceToBoneLandmarksPanel::update);
  connect(m_case, &qFaceToBoneCase::loaded, this,
          [this]
          {
            if (const QStringList missing = m_case->missingLandmarks(); !missing.isEmpty())
              setCurrent(missing.first());
          });
  update();
}

QString qFaceToBoneLandmarksPanel::current() const
{
  return m_list->currentItem() ? m_list->currentItem()->data(0, Qt::UserRole).toString()
                               : QString();
}

void qFaceToBoneLandmarksPanel::setCurrent(const QString& name)
{
  for (int row = 0; row < m_list->topLevelItemCount(); ++row)
    if (m_list->topLevelItem(row)->data(0, Qt::UserRole).toString() == name)
      m_list->setCurrentItem(m_list->topLevelItem(row));
}

bool qFaceToBoneLandmarksPanel::isPlacing() const
{
  return m_place->isChecked();
}

void qFaceToBoneLandmarksPanel::stopPlacing()
{
  m_place->setChecked(false);
}

void qFaceToBoneLandmarksPanel::advance()
{
  const auto landmarks = m_case->landmarks();
  for (const bool needed : {true, false})
    for (const qFaceToBoneCase::Landmark& landmark : landmarks)
      if (!landmark.placed && landmark.needed == needed)
        return setCurrent(landmark.name);
  stopPlacing();
}

void qFaceToBoneLandmarksPanel::load()
{
  const QString path = QFileDialog::getOpenFileName(this, tr("Landmarks"), m_case->folder(),
                                                    tr("Slicer fiducials (*.mrk.json *.json)"));
  if (!path.isEmpty() && !m_case->loadLandmarks(path))
    QMessageBox::warning(this, tr("Landmarks"), m_case->error());
}

void qFaceToBoneLandmarksPanel::update()
{
  const QStringList missing = m_case->missingLandmarks();
  m_note->setText(
      missing.isEmpty()
          ? tr("Landmarks place the cuts and give the measures. The cuts have all that they need.")
          : tr("<b>Missing for the cuts: %1.</b> Choose one, press <i>Place in 3D</i> and click "
               "its place; or load a file of Slicer fiducials.")
                .arg(missing.join(", ")));
  const QString chosen = current();
  const QSignalBlocker blocker(m_list);
  m_list->clear();
  auto landmarks = m_case->landmarks();
  std::stable_partition(landmarks.begin(), landmarks.end(), // what is to be done comes first
                        [](const auto& l) { return l.needed && !l.placed; });
  for (const qFaceToBoneCase::Landmark& landmark : landmarks)
  {
    auto* item = new QTreeWidgetItem(m_list);
    item->setData(0, Qt::UserRole, landmark.name);
    item->setText(0, (landmark.placed ? QString::fromUtf8("\xe2\x9c\x93 ") : QString("    ")) +
                         landmark.name);
    item->setText(1, landmark.meaning);
    item->setToolTip(0, landmark.meaning);
    item->setToolTip(1, landmark.meaning);
    if (landmark.needed && !landmark.placed)
      item->setForeground(0, QColor("#b03a00"));
  }
  setCurrent(chosen);
  if (current().isEmpty())
    setCurrent(missing.isEmpty() ? QString("N") : missing.first());
  const bool able = m_case->isOpen() && !m_case->task()->isRunning();
  for (QPushButton* button : {m_place, m_here, m_remove})
    button->setEnabled(able);
}
