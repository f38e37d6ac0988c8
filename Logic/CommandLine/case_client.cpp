#include "CommandLine/case_client.hpp"

#include <vtkMRMLFaceToBonePlanNode.h>
#include <vtkMRMLScene.h>
#include <vtkSlicerFaceToBoneLogic.h>

namespace f2b
{

CaseClient::CaseClient(Progress progress) : m_progress(std::move(progress))
{
  m_logic->SetReadData(false);
  m_logic->SetSettingsSource("command line");
  m_logic->SetMRMLScene(m_scene);
  m_callback->SetClientData(this);
  m_callback->SetCallback(
      [](vtkObject* caller, unsigned long, void* client, void*)
      {
        auto* plan = vtkMRMLFaceToBonePlanNode::SafeDownCast(caller);
        static_cast<CaseClient*>(client)->m_progress(plan->GetProgressText(), plan->GetProgress());
      });
}

CaseClient::~CaseClient()
{
  m_logic->SetMRMLScene(nullptr);
}

vtkMRMLFaceToBonePlanNode* CaseClient::watched(vtkMRMLFaceToBonePlanNode* plan)
{
  require(plan != nullptr);
  plan->AddObserver(vtkMRMLFaceToBonePlanNode::ProgressEvent, m_callback);
  return plan;
}

vtkMRMLFaceToBonePlanNode* CaseClient::begin(const std::string& case_file,
                                             const std::string& folder)
{
  vtkMRMLFaceToBonePlanNode* plan = watched(m_logic->AddPlanFromFile(case_file));
  plan->SetCaseFolder(folder);
  return plan;
}

vtkMRMLFaceToBonePlanNode* CaseClient::open(const std::string& folder)
{
  return watched(m_logic->OpenCase(folder));
}

void CaseClient::require(bool done) const
{
  if (!done)
    throw StepFailure(m_logic->GetErrorText(), m_logic->GetErrorCode());
}

} // namespace f2b
