#include "qFaceToBoneMainWindow.h"

#include "qFaceToBoneBoneTools.h"
#include "qFaceToBoneCase.h"
#include "qFaceToBoneCutTools.h"
#include "qFaceToBoneCutsPanel.h"
#include "qFaceToBoneLandmarksPanel.h"
#include "qFaceToBonePlanPanel.h"
#include "qFaceToBonePointTools.h"
#include "qFaceToBoneSculptPanel.h"
#include "qFaceToBoneSliceView.h"
#include "qFaceToBoneStepsPanel.h"
#include "qFaceToBoneThreeDView.h"
#include "vtkFaceToBoneSculptRepresentation.h"
#include "vtkFaceToBoneSculptWidget.h"

#include <Core/sculpting/sculpting_session.hpp>

#include <QCloseEvent>
#include <QDesktopServices>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QTimer>
#include <QUrl>

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

void qFaceToBoneMainWindow::connectCase()
{
  connect(m_case, &qFaceToBoneCase::loaded, this, &qFaceToBoneMainWindow::loadedAnother);
  connect(m_case, &qFaceToBoneCase::skinChanged, this, &qFaceToBoneMainWindow::showSkin);
  connect(m_case->task(), &qFaceToBoneTask::started, this,
          [this](const QString& title)
          {
            m_progress->setValue(0);
            m_progress->show();
            m_cancel->show();
            say(title);
          });
  connect(m_case->task(), &qFaceToBoneTask::progressed, this,
          [this](const QString& what, double fraction)
          {
            m_progress->setValue(static_cast<int>(1000 * fraction));
            say(what);
          });
  connect(m_case->task(), &qFaceToBoneTask::ended, this,
          [this](bool succeeded, const QString& message)
          {
            m_progress->hide();
            m_cancel->hide();
            if (!message.isEmpty())
              complain(message);
            else
              say(succeeded ? tr("%1: done").arg(m_case->task()->title()) : tr("Cancelled"));
          });
  connect(m_case->background(), &qFaceToBoneTask::started, this,
          [this](const QString& title)
          {
            if (!m_case->task()->isRunning())
              say(title);
          });
  connect(m_case->background(), &qFaceToBoneTask::ended, this,
          [this](bool succeeded, const QString& message)
          {
            if (!message.isEmpty())
              say(message);
            else if (succeeded && !m_case->task()->isRunning())
              say(tr("%1: done").arg(m_case->background()->title()));
          });
}

void qFaceToBoneMainWindow::connectTool()
{
  m_tool->SetInteractor(m_view->interactor());
  m_tool->SetDefaultRenderer(m_view->mainRenderer());
  connect(m_sculptPanel, &qFaceToBoneSculptPanel::brushChanged, this,
          [this] { m_tool->SetBrush(m_sculptPanel->brush()); });
  connect(m_sculptPanel, &qFaceToBoneSculptPanel::sculptingChanged, this,
          [this](bool on)
          {
            if (on)
            {
              m_case->objects()->setVisible("target", true);
              m_case->objects()->setVisible("skin", false);
            }
            m_tool->SetEnabled(on && m_case->sculpting());
          });
  m_tool->AddObserver(vtkCommand::InteractionEvent, this, &qFaceToBoneMainWindow::strokeMoved);
  m_tool->AddObserver(vtkCommand::EndInteractionEvent, this, &qFaceToBoneMainWindow::strokeEnded);
  m_tool->AddObserver(vtkCommand::ModifiedEvent, this, &qFaceToBoneMainWindow::brushTurned);
}

void qFaceToBoneMainWindow::connectBoneTools()
{
  m_boneTools = new qFaceToBoneBoneTools(m_case, m_view, this);
  m_cutTools = new qFaceToBoneCutTools(m_case, m_view, this);
  connect(m_cutsPanel, &qFaceToBoneCutsPanel::explodeChanged, m_view,
          &qFaceToBoneThreeDView::setExplode);
  connect(m_cutsPanel, &qFaceToBoneCutsPanel::toolsShown, m_cutTools, &qFaceToBoneCutTools::show);
  connect(m_cutsPanel, &qFaceToBoneCutsPanel::planeWanted, this,
          [this](bool ofCurrent)
          {
            if (!m_case->cuts()->addPlane(m_slices[0]->crosshair(), ofCurrent))
              complain(m_case->cuts()->error());
          });
  connect(m_cutsPanel, &qFaceToBoneCutsPanel::lineWanted, this,
          [this](bool ofCurrent)
          {
            if (!m_cutTools->startDrawing(ofCurrent))
              complain(tr("There is no bone to draw on; find the surfaces first"));
          });
  connect(m_cutsPanel, &qFaceToBoneCutsPanel::lineFinished, this,
          [this]
          {
            if (!m_cutTools->finishDrawing())
              say(tr("A line has two points at least"));
          });
  connect(m_cutsPanel, &qFaceToBoneCutsPanel::lineDropped, m_cutTools,
          &qFaceToBoneCutTools::dropDrawing);
  connect(m_cutsPanel, &qFaceToBoneCutsPanel::refused, this, &qFaceToBoneMainWindow::complain);
  connect(m_cutTools, &qFaceToBoneCutTools::drawingChanged, m_cutsPanel,
          &qFaceToBoneCutsPanel::setDrawing);
  connect(m_cutTools, &qFaceToBoneCutTools::told, this, &qFaceToBoneMainWindow::say);
  connect(m_planPanel, &qFaceToBonePlanPanel::refused, this, &qFaceToBoneMainWindow::complain);
  connect(m_planPanel, &qFaceToBonePlanPanel::handChanged, this,
          [this](bool on)
          {
            m_byHand = on;
            m_boneTools->showGizmos(on);
          });
}

bool qFaceToBoneMainWindow::saveAll()
{
  const bool sculpted = m_case->saveSculpted();
  return m_case->saveCuts() && sculpted;
}

/// Of what the step at hand is about.
void qFaceToBoneMainWindow::undo()
{
  if (m_steps->currentStep() == qFaceToBoneCase::Cuts)
    m_case->cuts()->undo();
  else
    m_case->undo();
}

void qFaceToBoneMainWindow::redo()
{
  if (m_steps->currentStep() == qFaceToBoneCase::Cuts)
    m_case->cuts()->redo();
  else
    m_case->redo();
}

void qFaceToBoneMainWindow::connectPointTools()
{
  m_pointTools = new qFaceToBonePointTools(m_case, m_view, m_landmarksPanel, m_sculptPanel,
                                           m_measuresPanel, this);
  connect(m_landmarksPanel, &qFaceToBoneLandmarksPanel::crosshairWanted, this,
          [this](const QString& name)
          {
            if (m_case->placeLandmark(name, m_slices[0]->crosshair()))
              m_landmarksPanel->advance();
            else
              complain(m_case->error());
          });
  connect(m_landmarksPanel, &qFaceToBoneLandmarksPanel::placingChanged, this,
          [this](bool on)
          {
            if (on)
              say(tr("Click the place of %1 in the 3D view").arg(m_landmarksPanel->current()));
          });
  connect(m_landmarksPanel, &qFaceToBoneLandmarksPanel::currentChanged, this,
          [this](const QString& name)
          {
            if (m_landmarksPanel->isPlacing())
              say(tr("Click the place of %1 in the 3D view").arg(name));
          });
}

vtkFaceToBoneSculptWidget* qFaceToBoneMainWindow::sculptTool() const
{
  return m_tool;
}

void qFaceToBoneMainWindow::strokeMoved()
{
  m_case->sculpted(false);
}

void qFaceToBoneMainWindow::strokeEnded()
{
  m_case->sculpted(true);
}

void qFaceToBoneMainWindow::brushTurned()
{
  m_sculptPanel->setBrush(m_tool->GetBrush());
}

/// Asks where the sculpted face would be left behind unkept. \return false if the user stays
bool qFaceToBoneMainWindow::mayLeave()
{
  if (!m_case->hasUnsavedChanges())
    return true;
  QMessageBox box(QMessageBox::Question, "FaceToBone",
                  tr("The sculpted face is not yet kept as the target. Save it, to go on with it "
                     "next time?"),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box.setDefaultButton(QMessageBox::Save);
  box.setObjectName("unsaved");
  switch (box.exec())
  {
  case QMessageBox::Save:
    if (m_case->saveSculpted())
      return true;
    complain(m_case->error());
    return false;
  case QMessageBox::Discard:
    m_case->discardSculpted();
    return true;
  default:
    return false;
  }
}

void qFaceToBoneMainWindow::openFolder()
{
  const QString path = QFileDialog::getExistingDirectory(
      this, tr("Open a DICOM folder"), QSettings().value("lastFolder").toString());
  if (!path.isEmpty())
    open(path);
}

bool qFaceToBoneMainWindow::open(const QString& path)
{
  if (!mayLeave())
    return false;
  if (!m_case->open(path))
  {
    complain(m_case->error());
    return false;
  }
  rememberRecent(path);
  return true;
}

QString qFaceToBoneMainWindow::sampleFolder() const
{
  return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)).filePath("sample");
}

void qFaceToBoneMainWindow::openSample()
{
  if (!mayLeave())
    return;
  if (!m_case->openSample(sampleFolder(), QSettings().value("meshDensity", 0.3).toDouble()))
    complain(m_case->error());
}

/// The views and the brush belong to another case, or to its new surfaces.
void qFaceToBoneMainWindow::loadedAnother()
{
  const bool open = m_case->isOpen();
  setWindowTitle(open ? m_case->name() + " - FaceToBone" : "FaceToBone");
  m_centre->setCurrentIndex(open ? 1 : 0);
  for (qFaceToBoneSliceView* slice : m_slices)
    slice->setImage(m_case->ct());
  showSkin();
  if (!open)
    return;
  for (int step = 0; step < qFaceToBoneCase::StepCount; ++step)
    if (!m_case->state(static_cast<qFaceToBoneCase::Step>(step)).done)
      return m_steps->setCurrentStep(step);
  m_steps->setCurrentStep(qFaceToBoneCase::Plan);
}

/// Gives the brush the face of the case, and brings what is shown up to it.
void qFaceToBoneMainWindow::showSkin()
{
  vtkFaceToBoneSculptRepresentation* look = m_tool->GetSculptRepresentation();
  const qFaceToBoneObject* target = m_case->objects()->find("target");
  const auto session = m_case->sculpting();
  if (!session || !target)
  {
    m_tool->SetEnabled(0);
    look->SetSession(nullptr, nullptr);
    return;
  }
  if (look->GetSession() != session.get() || m_shownTarget != target->surface)
  {
    m_tool->SetEnabled(0);
    look->SetSession(session, target->surface);
    m_shownTarget = target->surface;
    m_tool->SetEnabled(m_sculptPanel->isSculpting());
  }
  look->UpdateShown();
  emit m_case->objects()->objectChanged("target");
}

/// Each step shows what it is about.
void qFaceToBoneMainWindow::stepChosen(int step)
{
  m_pages->setCurrentIndex(step);
  m_tool->SetEnabled(step == qFaceToBoneCase::Target && m_sculptPanel->isSculpting() &&
                     m_case->sculpting());
  m_cutTools->show(step == qFaceToBoneCase::Cuts && m_cutsPanel->showsTools());
  m_case->setMovementShown(step == qFaceToBoneCase::Cuts ? 0 : m_planPanel->shareShown());
  m_boneTools->showGizmos(step == qFaceToBoneCase::Plan && m_byHand);
  m_pointTools->showLandmarks(step == qFaceToBoneCase::Surfaces);
  m_pointTools->showHandles(step == qFaceToBoneCase::Target);
  qFaceToBoneObjects* objects = m_case->objects();
  const bool planned = !m_case->movements().empty();
  const bool bones = step == qFaceToBoneCase::Cuts;
  const bool through = step >= qFaceToBoneCase::Plan;
  objects->setVisible("skin", step <= qFaceToBoneCase::Surfaces);
  objects->setOpacity("skin", 0.45);
  objects->setVisible("target", step == qFaceToBoneCase::Target);
  objects->setVisible("predicted", through && planned);
  objects->setOpacity("predicted", through ? 0.4 : 1);
  for (const qFaceToBoneObject& object : objects->all())
    if (object.key.startsWith("fragment/") || object.key.startsWith("protected/") ||
        object.key == "bone" || object.key == "uncut")
      objects->setVisible(object.key, bones || through || step == qFaceToBoneCase::Surfaces);
  m_view->renderSoon();
}

void qFaceToBoneMainWindow::colourTarget(int choice)
{
  qFaceToBoneObjects* objects = m_case->objects();
  objects->setColouring("predicted", choice == 3 ? "unreached_mm" : "", 3, false);
  static const char* const arrays[] = {"", vtkFaceToBoneSculptRepresentation::LengthArray,
                                       vtkFaceToBoneSculptRepresentation::MaskArray,
                                       "unreached_mm"};
  double range = choice == 2 ? 1 : 3;
  const qFaceToBoneObject* target = objects->find("target");
  vtkDataArray* moved =
      !target || choice != 1 ? nullptr : target->surface->GetPointData()->GetArray(arrays[choice]);
  if (moved)
    range = std::clamp(
        std::ceil(std::max(std::abs(moved->GetRange()[0]), std::abs(moved->GetRange()[1]))), 4.0,
        20.0);
  objects->setColouring("target", arrays[choice], range, choice == 1);
}

void qFaceToBoneMainWindow::say(const QString& text)
{
  m_message->setText(text);
}

/// Errors stand in the status bar, and in a box that does not stop anything.
void qFaceToBoneMainWindow::complain(const QString& text)
{
  say(text);
  auto* box = new QMessageBox(QMessageBox::Warning, "FaceToBone", text, QMessageBox::Ok, this);
  box->setObjectName("complaint");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

void qFaceToBoneMainWindow::rememberRecent(const QString& path)
{
  QSettings settings;
  QStringList recent = settings.value("recent").toStringList();
  const QString absolute = QFileInfo(path).absoluteFilePath();
  recent.removeAll(absolute);
  recent.prepend(absolute);
  settings.setValue("recent", QStringList(recent.mid(0, 8)));
  settings.setValue("lastFolder", QFileInfo(path).absolutePath());
  updateRecent();
}

void qFaceToBoneMainWindow::updateRecent()
{
  m_recent->clear();
  for (const QString& path : QSettings().value("recent").toStringList())
    m_recent->addAction(path, this, [this, path] { open(path); });
  m_recent->setEnabled(!m_recent->isEmpty());
}

void qFaceToBoneMainWindow::preferences()
{
  QSettings settings;
  QDialog dialog(this);
  dialog.setWindowTitle(tr("Preferences"));
  auto* form = new QFormLayout(&dialog);
  auto* density = new QDoubleSpinBox;
  density->setRange(0.05, 4);
  density->setSingleStep(0.05);
  density->setValue(settings.value("meshDensity", 0.3).toDouble());
  auto* autosave = new QSpinBox;
  autosave->setRange(5, 600);
  autosave->setSuffix(" s");
  autosave->setValue(settings.value("autosaveSeconds", 20).toInt());
  form->addRow(tr("Mesh density of the sample"), density);
  form->addRow(tr("Save the sculpted face every"), autosave);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  if (dialog.exec() != QDialog::Accepted)
    return;
  settings.setValue("meshDensity", density->value());
  settings.setValue("autosaveSeconds", autosave->value());
  m_autosave->start(1000 * autosave->value());
}

void qFaceToBoneMainWindow::about()
{
  QMessageBox::about(
      this, tr("About FaceToBone"),
      tr("<h3>FaceToBone %1</h3><p>Plans cranio-maxillofacial surgery from the face backwards.</p>"
         "<p><b>Research software, not a medical device.</b></p>"
         "<p>Apache-2.0; linked with libraries under the GPL.</p>")
          .arg(FACETOBONE_VERSION));
}

void qFaceToBoneMainWindow::closeEvent(QCloseEvent* event)
{
  if (!mayLeave())
  {
    event->ignore();
    return;
  }
  QSettings().setValue("geometry", saveGeometry());
  m_tool->SetEnabled(0);
  m_cutTools->show(false);
  m_case->task()->cancel();
  saveAll();
  event->accept();
}
