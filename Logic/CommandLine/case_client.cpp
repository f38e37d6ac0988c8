#include "CommandLine/case_client.hpp"

#include "Case/case_session.hpp"
#include "Core/error.hpp"

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

void CaseClient::write_bundle(const std::string& folder, const Path& file)
{
  if (!file.empty() && file.extension() != ".mrb")
    throw Error(file.string(), "Slicer knows a scene in one file by the ending .mrb",
                "end the file's name in .mrb");
  m_progress("reading the scene", 0);
  m_logic->SetReadData(true);
  open(folder);
  m_progress("packing the scene", 0.3);
  const auto pack = [this](const Path& bundle)
  {
    if (!m_scene->WriteToMRB(bundle.c_str()))
      throw Error(bundle.string(), "it cannot be written",
                  "give a file in a folder that you may write to, with room for all data");
  };
  if (file.empty())
  {
    CaseSession session = CaseSession::open(folder, m_progress);
    CaseChange change(session.folder);
    pack(change.file("export.mrb"));
    change.commit("export mrb");
  }
  else
    pack(std::filesystem::absolute(file));
  m_progress("packed", 1);
}

void CaseClient::require(bool done) const
{
  if (!done)
    throw StepFailure(m_logic->GetErrorText(), m_logic->GetErrorCode());
}

} // namespace f2b
