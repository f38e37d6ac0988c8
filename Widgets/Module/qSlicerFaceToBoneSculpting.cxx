#include "qSlicerFaceToBoneSculpting.h"

#include "qFaceToBoneBrushPanel.h"
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

qSlicerFaceToBoneSculpting::qSlicerFaceToBoneSculpting(qFaceToBoneBrushPanel* panel,
                                                       QObject* parent)
    : QObject(parent), m_panel(panel)
{
  connect(m_panel, &qFaceToBoneBrushPanel::sculptingChanged, this,
          &qSlicerFaceToBoneSculpting::follow);
  connect(m_panel, &qFaceToBoneBrushPanel::brushChanged, this,
          &qSlicerFaceToBoneSculpting::takeBrush);
  m_tool->AddObserver(vtkCommand::ModifiedEvent, this, &qSlicerFaceToBoneSculpting::onChanged);
  takeBrush();
}

qSlicerFaceToBoneSculpting::~qSlicerFaceToBoneSculpting()
{
  m_tool->RemoveAllObservers();
}

vtkFaceToBoneSkinSculpting* qSlicerFaceToBoneSculpting::tool()
{
  return m_tool;
}

void qSlicerFaceToBoneSculpting::setLogic(vtkSlicerFaceToBoneLogic* logic)
{
  m_logic = logic;
}

void qSlicerFaceToBoneSculpting::setPlan(vtkMRMLFaceToBonePlanNode* plan)
{
  m_plan = plan;
  vtkMRMLFaceToBoneTargetNode* target = plan ? plan->GetTargetNode() : nullptr;
  m_tool->SetNodes(plan ? plan->GetSkinNode() : nullptr,
                   target ? target->GetTargetSkinNode() : nullptr);
  m_tool->SetLandmarks(vtkMRMLMarkupsNode::SafeDownCast(plan ? plan->GetLandmarksNode() : nullptr));
}

void qSlicerFaceToBoneSculpting::findView()
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
  m_tool->SetView(view ? view->interactor() : nullptr, view ? view->renderer() : nullptr);
}

/// A brush was chosen, or put down.
void qSlicerFaceToBoneSculpting::follow(bool sculpting)
{
  m_following = true;
  if (sculpting)
  {
    findView();
    if (m_plan && m_logic)
      m_logic->AddTargetSkin(m_plan); // where there is none
    setPlan(m_plan);
    m_tool->Start();
  }
  else
    m_tool->Stop();
  m_following = false;
  onChanged();
}

void qSlicerFaceToBoneSculpting::stop()
{
  m_panel->stopSculpting();
}

void qSlicerFaceToBoneSculpting::takeBrush()
{
  m_tool->SetBrush(m_panel->brush(), m_panel->isSymmetric());
}

/// The panel says what is so: a brush that cannot sculpt is put down.
void qSlicerFaceToBoneSculpting::onChanged()
{
  if (m_following)
    return;
  m_panel->setBrush(m_tool->GetBrush());
  if (m_panel->isSculpting() && !m_tool->IsSculpting())
    m_panel->stopSculpting();
  emit changed();
}

QString qSlicerFaceToBoneSculpting::statusText()
{
  if (m_tool->IsSculpting())
    return tr("The brush works in the first 3D view. Escape takes a stroke back.");
  return m_plan ? QString::fromStdString(m_tool->GetObstacle()) : QString();
}
