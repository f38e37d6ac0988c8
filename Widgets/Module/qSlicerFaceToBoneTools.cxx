#include "qSlicerFaceToBoneTools.h"

#include "qFaceToBoneBrushPanel.h"
#include "vtkFaceToBoneFragmentHands.h"
#include "vtkFaceToBoneSkinSculpting.h"

#include <vtkMRMLFaceToBonePlanNode.h>
#include <vtkMRMLFaceToBoneTargetNode.h>
#include <vtkSlicerFaceToBoneLogic.h>

#include <qMRMLThreeDView.h>
#include <qMRMLThreeDWidget.h>
#include <qSlicerApplication.h>
#include <qSlicerLayoutManager.h>

#include <vtkMRMLMarkupsNode.h>
#include <vtkMRMLModelNode.h>

#include <vtkCommand.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

namespace
{

/// None in programs without a main window, such as tests.
qSlicerLayoutManager* layoutManager()
{
  auto* application = qobject_cast<qSlicerApplication*>(QCoreApplication::instance());
  return application ? application->layoutManager() : nullptr;
}

} // namespace

qSlicerFaceToBoneTools::qSlicerFaceToBoneTools(qFaceToBoneBrushPanel* panel, QObject* parent)
    : QObject(parent), m_panel(panel)
{
  connect(m_panel, &qFaceToBoneBrushPanel::sculptingChanged, this, &qSlicerFaceToBoneTools::follow);
  connect(m_panel, &qFaceToBoneBrushPanel::brushChanged, this, &qSlicerFaceToBoneTools::takeBrush);
  m_sculpting->AddObserver(vtkCommand::ModifiedEvent, this, &qSlicerFaceToBoneTools::onChanged);
  m_hands->AddObserver(vtkCommand::ModifiedEvent, this, &qSlicerFaceToBoneTools::onChanged);
  m_hands->AddObserver(vtkCommand::EndInteractionEvent, this, &qSlicerFaceToBoneTools::onLetGo);
  takeBrush();
}

qSlicerFaceToBoneTools::~qSlicerFaceToBoneTools()
{
  m_sculpting->RemoveAllObservers();
  m_hands->RemoveAllObservers();
}

vtkFaceToBoneSkinSculpting* qSlicerFaceToBoneTools::sculpting()
{
  return m_sculpting;
}

vtkFaceToBoneFragmentHands* qSlicerFaceToBoneTools::hands()
{
  return m_hands;
}

void qSlicerFaceToBoneTools::setLogic(vtkSlicerFaceToBoneLogic* logic)
{
  m_logic = logic;
}

void qSlicerFaceToBoneTools::setPlan(vtkMRMLFaceToBonePlanNode* plan)
{
  m_plan = plan;
  vtkMRMLFaceToBoneTargetNode* target = plan ? plan->GetTargetNode() : nullptr;
  m_sculpting->SetNodes(plan ? plan->GetSkinNode() : nullptr,
                        target ? target->GetTargetSkinNode() : nullptr);
  m_hands->SetPlan(plan);
  m_sculpting->SetLandmarks(
      vtkMRMLMarkupsNode::SafeDownCast(plan ? plan->GetLandmarksNode() : nullptr));
}

void qSlicerFaceToBoneTools::findView()
{
  qSlicerLayoutManager* layout = layoutManager();
  if (layout)
  {
    connect(layout, SIGNAL(layoutChanged(int)), this, SLOT(findView()), Qt::UniqueConnection);
    connect(layout, SIGNAL(activeThreeDRendererChanged(vtkRenderer*)), this, SLOT(findView()),
            Qt::UniqueConnection);
  }
  qMRMLThreeDWidget* widget =
      layout && layout->threeDViewCount() > 0 ? layout->threeDWidget(0) : nullptr;
  qMRMLThreeDView* view = widget ? widget->threeDView() : nullptr;
  vtkRenderWindowInteractor* interactor = view ? view->interactor() : nullptr;
  vtkRenderer* renderer = view ? view->renderer() : nullptr;
  m_sculpting->SetView(interactor, renderer);
  m_hands->SetView(interactor, renderer);
  onChanged();
}

/// A brush was chosen, or put down.
void qSlicerFaceToBoneTools::follow(bool sculpting)
{
  m_following = true;
  if (sculpting)
  {
    findView();
    if (m_plan && m_logic)
      m_logic->AddTargetSkin(m_plan); // where there is none
    setPlan(m_plan);
    m_sculpting->Start();
  }
  else
    m_sculpting->Stop();
  m_following = false;
  onChanged();
}

void qSlicerFaceToBoneTools::moveByHand(bool on)
{
  if (on)
  {
    findView();
    m_hands->Start();
  }
  else
    m_hands->Stop();
  onChanged();
}

void qSlicerFaceToBoneTools::stop()
{
  m_panel->stopSculpting();
  m_hands->Stop();
}

void qSlicerFaceToBoneTools::takeBrush()
{
  m_sculpting->SetBrush(m_panel->brush(), m_panel->isSymmetric());
}

/// The panel says what is so: a brush that cannot sculpt is put down.
void qSlicerFaceToBoneTools::onChanged()
{
  if (m_following)
    return;
  m_panel->setBrush(m_sculpting->GetBrush());
  if (m_panel->isSculpting() && !m_sculpting->IsSculpting())
    m_panel->stopSculpting();
  emit changed();
}

void qSlicerFaceToBoneTools::onLetGo()
{
  emit movementStated();
}

QString qSlicerFaceToBoneTools::sculptingText()
{
  if (m_sculpting->IsSculpting())
    return tr("The brush works in the first 3D view. Escape takes a stroke back.");
  return m_plan ? QString::fromStdString(m_sculpting->GetObstacle()) : QString();
}

QString qSlicerFaceToBoneTools::handsText()
{
  if (m_hands->IsMoving())
    return tr("Arrows and rings in the first 3D view move the fragments.");
  return m_plan ? QString::fromStdString(m_hands->GetObstacle()) : QString();
}
