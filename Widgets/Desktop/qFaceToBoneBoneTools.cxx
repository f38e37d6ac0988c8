#include "qFaceToBoneBoneTools.h"

#include "qFaceToBoneCase.h"
#include "qFaceToBoneThreeDView.h"
#include "vtkFaceToBoneFragmentWidget.h"

#include <vtkCommand.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

qFaceToBoneBoneTools::qFaceToBoneBoneTools(qFaceToBoneCase* work, qFaceToBoneThreeDView* view,
                                           QObject* parent)
    : QObject(parent), m_case(work), m_view(view)
{
  connect(m_case, &qFaceToBoneCase::planChanged, this, &qFaceToBoneBoneTools::updateGizmos);
  connect(m_case, &qFaceToBoneCase::loaded, this, &qFaceToBoneBoneTools::updateGizmos);
}

qFaceToBoneBoneTools::~qFaceToBoneBoneTools()
{
  for (const auto& tool : m_gizmos)
  {
    tool->RemoveAllObservers(); // one that is held is not let go any more
    tool->SetInteractor(nullptr);
  }
}

void qFaceToBoneBoneTools::showGizmos(bool on)
{
  m_showGizmos = on;
  updateGizmos();
}

/// One for each movement, where it is now; the one that is held leads and is left alone.
void qFaceToBoneBoneTools::updateGizmos()
{
  const auto movements = m_case->movements();
  while (m_gizmos.size() > movements.size())
  {
    m_gizmos.back()->SetEnabled(0);
    m_gizmos.back()->SetInteractor(nullptr);
    m_gizmos.pop_back();
  }
  while (m_gizmos.size() < movements.size())
  {
    auto tool = vtkSmartPointer<vtkFaceToBoneFragmentWidget>::New();
    tool->SetInteractor(m_view->interactor());
    tool->SetDefaultRenderer(m_view->mainRenderer());
    tool->AddObserver(vtkCommand::InteractionEvent, this, &qFaceToBoneBoneTools::gizmoMoved);
    m_gizmos.push_back(tool);
  }
  for (std::size_t f = 0; f < movements.size(); ++f)
  {
    vtkFaceToBoneFragmentWidget* tool = m_gizmos[f];
    if (tool->GetWidgetState() != vtkFaceToBoneFragmentWidget::Start)
      continue;
    vtkFaceToBoneFragmentRepresentation* look = tool->GetFragmentRepresentation();
    const auto& t = movements[f].translation;
    const auto& r = movements[f].rotation;
    const qFaceToBoneRules rules = m_case->cuts()->rules(movements[f].fragment);
    for (int k = 0; k < 6; ++k)
    {
      const double most = k < 3 ? vtkFaceToBoneFragmentRepresentation::MostMm
                                : vtkFaceToBoneFragmentRepresentation::MostDegrees;
      const auto coordinate = static_cast<std::size_t>(k);
      look->SetLimits(k, rules.within(coordinate, -most, most),
                      rules.within(coordinate, most, most));
      look->SetLocked(k, rules.isLocked(coordinate));
    }
    look->SetReferencePoint(m_case->referencePoint(movements[f].fragment));
    look->SetMovement({t[0], t[1], t[2], r[0], r[1], r[2]});
    if (bool(tool->GetEnabled()) != m_showGizmos)
      tool->SetEnabled(m_showGizmos);
  }
  m_view->renderSoon();
}

void qFaceToBoneBoneTools::gizmoMoved(vtkObject* tool, unsigned long, void*)
{
  const auto movements = m_case->movements();
  for (std::size_t f = 0; f < m_gizmos.size() && f < movements.size(); ++f)
    if (m_gizmos[f] == tool)
    {
      const auto& m = m_gizmos[f]->GetFragmentRepresentation()->GetMovement();
      m_case->setMovement({movements[f].fragment, {m[0], m[1], m[2]}, {m[3], m[4], m[5]}});
    }
}
