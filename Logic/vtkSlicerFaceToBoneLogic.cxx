#include "vtkSlicerFaceToBoneLogic.h"

#include "Bridge/json_file.hpp"
#include "Bridge/vtk_surface.hpp"
#include "Core/error.hpp"
#include "Core/geometry/osteotomy_templates.hpp"
#include "Rendering/atomic_file.hpp"
#include "Scene/background_step.hpp"
#include "Scene/case_publisher.hpp"
#include "Scene/scene_file.hpp"
#include "Scene/stale_steps.hpp"

#include <vtkMRMLFaceToBoneOsteotomyNode.h>
#include <vtkMRMLFaceToBonePlanNode.h>
#include <vtkMRMLFaceToBoneTargetNode.h>
#include <vtkMRMLMarkupsClosedCurveNode.h>
#include <vtkMRMLMarkupsCurveNode.h>
#include <vtkMRMLMarkupsFiducialDisplayNode.h>
#include <vtkMRMLMarkupsFiducialNode.h>
#include <vtkMRMLMarkupsJsonStorageNode.h>
#include <vtkMRMLMarkupsPlaneDisplayNode.h>
#include <vtkMRMLMarkupsPlaneJsonStorageNode.h>
#include <vtkMRMLMarkupsPlaneNode.h>
#include <vtkMRMLModelDisplayNode.h>
#include <vtkMRMLModelNode.h>
#include <vtkMRMLScene.h>

#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkWeakPointer.h>

#include <nlohmann/json.hpp>

#include <new>

namespace
{

using PlanNode = vtkMRMLFaceToBonePlanNode;

/// How a step ended: the command line's exit codes, and one for what the user stopped.
struct Ending
{
  int Code = 0;
  std::string Text;
};

constexpr int CancelledCode = 4;

/// The one place where failures become sentences.
template <class Action>
Ending Attempt(Action&& action)
{
  try
  {
    action();
    return {};
  }
  catch (const f2b::Error& error)
  {
    return {error.kind() == f2b::ErrorKind::Numerical ? 3 : 2, error.what()};
  }
  catch (const f2b::Cancelled&)
  {
    return {CancelledCode, "cancelled; the case is as it was"};
  }
  catch (const std::bad_alloc&)
  {
    return {1, "memory ran out; use a lower mesh.density or a machine with more memory"};
  }
  catch (const std::exception& error)
  {
    return {1, error.what()};
  }
}

void RegisterClass(vtkMRMLScene* scene, vtkMRMLNode* node)
{
  if (!scene->IsNodeClassRegistered(node->GetClassName()))
    scene->RegisterNodeClass(node);
}

/// Where a plan's settings came from before it had a folder.
constexpr const char* SourceAttribute = "FaceToBone.SettingsSource";

} // namespace

class vtkSlicerFaceToBoneLogic::Internals
{
public:
  using Logic = vtkSlicerFaceToBoneLogic;

  f2b::StepRequest Prepare(Logic& logic, PlanNode* plan, int step);
  void WriteScene(Logic& logic, const f2b::CaseOutlook& files);
  void Publish(Logic& logic, PlanNode* plan);
  void End(Logic& logic, PlanNode* plan, int code, const std::string& text);

  f2b::ExportOptions Exported;
  std::unique_ptr<f2b::BackgroundStep> Running;
  vtkWeakPointer<vtkMRMLFaceToBonePlanNode> RunningPlan;
};

f2b::StepRequest vtkSlicerFaceToBoneLogic::Internals::Prepare(Logic& logic, PlanNode* plan,
                                                              int step)
{
  const char* file = plan->GetAttribute(SourceAttribute);
  f2b::SettingsOrigin origin;
  origin.name = file ? file : logic.GetSettingsSource();
  origin.file = file ? f2b::Path(file) : f2b::Path(plan->GetCaseFolder()) / f2b::case_settings_name;
  f2b::StepRequest request = f2b::prepare_step(f2b::CaseNodes::of(plan), step, origin);
  request.exported = this->Exported;
  return request;
}

void vtkSlicerFaceToBoneLogic::Internals::WriteScene(Logic& logic, const f2b::CaseOutlook& files)
{
  if (!logic.GetMRMLScene()) // closed while the step ran
    throw f2b::Cancelled();
  f2b::write_file_atomically(files.staging / f2b::case_scene_name,
                             f2b::case_scene_text(files, logic.GetMRMLScene()));
}

void vtkSlicerFaceToBoneLogic::Internals::Publish(Logic& logic, PlanNode* plan)
{
  const f2b::Path folder = std::filesystem::canonical(plan->GetCaseFolder());
  const f2b::CaseOutlook files = f2b::committed_files(folder);
  logic.CompletePlan(plan); // what was deleted while the step ran
  const f2b::CaseNodes nodes = f2b::CaseNodes::of(plan);
  plan->RemoveAttribute(SourceAttribute);
  f2b::settings_to_nodes(f2b::read_json(files.file(f2b::case_settings_name)), nodes);
  f2b::publish_case(files, logic.GetMRMLScene(), nodes, logic.GetReadData());
}

void vtkSlicerFaceToBoneLogic::Internals::End(Logic& logic, PlanNode* plan, int code,
                                              const std::string& text)
{
  {
    MRMLNodeModifyBlocker blocker(plan);
    plan->SetRunningStep(-1);
    plan->SetStatusCode(code);
    plan->SetStatusText(text);
  }
  logic.ErrorCode = code;
  logic.ErrorText = text;
  logic.InvokeEvent(StepFinishedEvent, plan);
}

vtkStandardNewMacro(vtkSlicerFaceToBoneLogic);

vtkSlicerFaceToBoneLogic::vtkSlicerFaceToBoneLogic() : Internal(std::make_unique<Internals>()) {}

vtkSlicerFaceToBoneLogic::~vtkSlicerFaceToBoneLogic() = default;

void vtkSlicerFaceToBoneLogic::PrintSelf(ostream& os, vtkIndent indent)
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Running: " << this->IsRunning() << "\n";
  os << indent << "ErrorText: " << this->ErrorText << "\n";
}

void vtkSlicerFaceToBoneLogic::RegisterNodes()
{
  vtkMRMLScene* scene = this->GetMRMLScene();
  if (!scene)
    return;
  RegisterClass(scene, vtkNew<vtkMRMLFaceToBoneTargetNode>());
  RegisterClass(scene, vtkNew<vtkMRMLFaceToBoneOsteotomyNode>());
  RegisterClass(scene, vtkNew<vtkMRMLFaceToBonePlanNode>());
  // Slicer's Markups module has registered these; a standalone scene has not
  RegisterClass(scene, vtkNew<vtkMRMLMarkupsFiducialNode>());
  RegisterClass(scene, vtkNew<vtkMRMLMarkupsPlaneNode>());
  RegisterClass(scene, vtkNew<vtkMRMLMarkupsCurveNode>());
  RegisterClass(scene, vtkNew<vtkMRMLMarkupsClosedCurveNode>());
  RegisterClass(scene, vtkNew<vtkMRMLMarkupsDisplayNode>());
  RegisterClass(scene, vtkNew<vtkMRMLMarkupsFiducialDisplayNode>());
  RegisterClass(scene, vtkNew<vtkMRMLMarkupsPlaneDisplayNode>());
  RegisterClass(scene, vtkNew<vtkMRMLMarkupsJsonStorageNode>());
  RegisterClass(scene, vtkNew<vtkMRMLMarkupsPlaneJsonStorageNode>());
}

// --- Plans

vtkMRMLFaceToBonePlanNode* vtkSlicerFaceToBoneLogic::AddPlan(const std::string& name)
{
  vtkMRMLFaceToBonePlanNode* plan = nullptr;
  const Ending ending = Attempt(
      [&]
      {
        plan = PlanNode::SafeDownCast(
            this->GetMRMLScene()->AddNewNodeByClass("vtkMRMLFaceToBonePlanNode", name));
        this->CompletePlan(plan);
      });
  this->ErrorCode = ending.Code;
  this->ErrorText = ending.Text;
  return plan;
}

vtkMRMLFaceToBonePlanNode* vtkSlicerFaceToBoneLogic::AddPlanFromFile(const std::string& fileName)
{
  vtkMRMLFaceToBonePlanNode* plan = nullptr;
  const Ending ending = Attempt(
      [&]
      {
        const nlohmann::json document = f2b::read_case(fileName);
        const f2b::CaseSettings settings = f2b::parse_settings(document, fileName);
        const f2b::CaseNodes nodes = f2b::add_case_nodes(this->GetMRMLScene(), settings.name);
        f2b::settings_to_nodes(document, nodes);
        nodes.plan->SetAttribute(SourceAttribute, fileName.c_str());
        plan = nodes.plan;
      });
  this->ErrorCode = ending.Code;
  this->ErrorText = ending.Text;
  return plan;
}

vtkMRMLFaceToBonePlanNode* vtkSlicerFaceToBoneLogic::OpenCase(const std::string& folder)
{
  vtkMRMLFaceToBonePlanNode* plan = nullptr;
  const Ending ending = Attempt(
      [&]
      {
        f2b::Path path;
        {
          // finishes what a killed process left, and says what is wrong with the case
          const f2b::CaseSession session = f2b::CaseSession::open(folder);
          path = session.folder.path();
        }
        plan =
            f2b::open_case_scene(f2b::committed_files(path), this->GetMRMLScene(), this->ReadData)
                .plan;
      });
  this->ErrorCode = ending.Code;
  this->ErrorText = ending.Text;
  return plan;
}

void vtkSlicerFaceToBoneLogic::WriteCaseScene(const f2b::CaseOutlook& files)
{
  const vtkNew<vtkMRMLScene> scene;
  const vtkNew<vtkSlicerFaceToBoneLogic> logic;
  logic->SetMRMLScene(scene);
  logic->Internal->WriteScene(*logic, files);
}

// --- Steps

bool vtkSlicerFaceToBoneLogic::Segment(vtkMRMLFaceToBonePlanNode* plan)
{
  return this->Do(plan, PlanNode::Segment);
}

bool vtkSlicerFaceToBoneLogic::Cut(vtkMRMLFaceToBonePlanNode* plan)
{
  return this->Do(plan, PlanNode::Cut);
}

bool vtkSlicerFaceToBoneLogic::Mesh(vtkMRMLFaceToBonePlanNode* plan)
{
  return this->Do(plan, PlanNode::Mesh);
}

bool vtkSlicerFaceToBoneLogic::Target(vtkMRMLFaceToBonePlanNode* plan)
{
  return this->Do(plan, PlanNode::Target);
}

bool vtkSlicerFaceToBoneLogic::Suggest(vtkMRMLFaceToBonePlanNode* plan)
{
  return this->Do(plan, PlanNode::Suggest);
}

bool vtkSlicerFaceToBoneLogic::Plan(vtkMRMLFaceToBonePlanNode* plan)
{
  return this->Do(plan, PlanNode::Plan);
}

bool vtkSlicerFaceToBoneLogic::Predict(vtkMRMLFaceToBonePlanNode* plan)
{
  return this->Do(plan, PlanNode::Predict);
}

bool vtkSlicerFaceToBoneLogic::Report(vtkMRMLFaceToBonePlanNode* plan)
{
  return this->Do(plan, PlanNode::Report);
}

bool vtkSlicerFaceToBoneLogic::Run(vtkMRMLFaceToBonePlanNode* plan)
{
  return this->Do(plan, RunStep);
}

bool vtkSlicerFaceToBoneLogic::Export(vtkMRMLFaceToBonePlanNode* plan, const std::string& format,
                                      const std::string& fileName, bool splitPrisms, int increments)
{
  this->Internal->Exported = {format, fileName, splitPrisms, increments};
  return this->Do(plan, f2b::export_step);
}

bool vtkSlicerFaceToBoneLogic::Do(vtkMRMLFaceToBonePlanNode* plan, int step)
{
  if (!plan || this->IsRunning())
  {
    vtkErrorMacro("Do: " << (plan ? "another step is running" : "there is no plan"));
    return false;
  }
  const Ending ending = Attempt(
      [&]
      {
        const f2b::StepRequest request = this->Internal->Prepare(*this, plan, step);
        plan->SetRunningStep(step);
        f2b::compute_step(
            request,
            [plan](std::string_view what, double fraction)
            { plan->SetProgress(fraction, std::string(what)); },
            [this](const f2b::CaseOutlook& files) { this->Internal->WriteScene(*this, files); });
        this->Internal->Publish(*this, plan);
      });
  this->Internal->End(*this, plan, ending.Code, ending.Text);
  return ending.Code == 0;
}

bool vtkSlicerFaceToBoneLogic::Start(vtkMRMLFaceToBonePlanNode* plan, int step)
{
  if (!plan || this->IsRunning())
    return false;
  const Ending ending = Attempt(
      [&]
      {
        plan->SetRunningStep(step);
        this->Internal->Running =
            std::make_unique<f2b::BackgroundStep>(this->Internal->Prepare(*this, plan, step));
        this->Internal->RunningPlan = plan;
      });
  if (ending.Code != 0)
    this->Internal->End(*this, plan, ending.Code, ending.Text);
  return ending.Code == 0;
}

bool vtkSlicerFaceToBoneLogic::ProcessEvents()
{
  if (!this->IsRunning())
    return false;
  vtkSmartPointer<vtkMRMLFaceToBonePlanNode> plan = this->Internal->RunningPlan.GetPointer();
  if (!plan || !plan->GetScene() || plan->GetScene() != this->GetMRMLScene())
  {
    plan = nullptr; // removed from the scene meanwhile
    this->Cancel();
  }
  const f2b::BackgroundStep::News news = this->Internal->Running->look(
      [this](const f2b::CaseOutlook& files) { this->Internal->WriteScene(*this, files); });
  if (plan)
    plan->SetProgress(news.fraction, news.text);
  if (!news.finished)
    return true;
  const std::unique_ptr<f2b::BackgroundStep> done = std::move(this->Internal->Running);
  const Ending ending = Attempt(
      [&]
      {
        done->finish();
        if (plan)
          this->Internal->Publish(*this, plan);
      });
  if (plan)
    this->Internal->End(*this, plan, ending.Code, ending.Text);
  return false;
}

bool vtkSlicerFaceToBoneLogic::IsRunning()
{
  return this->Internal->Running != nullptr;
}

void vtkSlicerFaceToBoneLogic::Cancel()
{
  if (this->Internal->Running)
    this->Internal->Running->cancel();
}

// --- State

void vtkSlicerFaceToBoneLogic::UpdateStepStatuses(vtkMRMLFaceToBonePlanNode* plan)
{
  if (!plan || !plan->GetOsteotomyNode() || !plan->GetTargetNode())
    return;
  const Ending ending = Attempt(
      [&]
      {
        const f2b::Path folder = plan->GetCaseFolder();
        if (std::filesystem::is_directory(folder))
          f2b::mark_stale_steps(f2b::committed_files(folder), f2b::CaseNodes::of(plan));
      });
  if (ending.Code != 0)
    vtkErrorMacro("UpdateStepStatuses: " << ending.Text);
}

void vtkSlicerFaceToBoneLogic::CompletePlan(vtkMRMLFaceToBonePlanNode* plan)
{
  if (!plan || !this->GetMRMLScene())
    return;
  const std::string name = plan->GetName() ? plan->GetName() : "Plan";
  if (!plan->GetOsteotomyNode())
    plan->SetOsteotomyNodeID(
        this->GetMRMLScene()
            ->AddNewNodeByClass("vtkMRMLFaceToBoneOsteotomyNode", name + " osteotomy")
            ->GetID());
  if (!plan->GetTargetNode())
    plan->SetTargetNodeID(this->GetMRMLScene()
                              ->AddNewNodeByClass("vtkMRMLFaceToBoneTargetNode", name + " target")
                              ->GetID());
  vtkMRMLFaceToBoneOsteotomyNode* osteotomy = plan->GetOsteotomyNode();
  if (osteotomy->GetNumberOfFragments() == 0)
    osteotomy->SetNthFragmentTemplate(osteotomy->AddFragment("maxilla"), "le-fort-1");
}

void vtkSlicerFaceToBoneLogic::ShowSelectedMethod(vtkMRMLFaceToBonePlanNode* plan)
{
  for (int method = 0; plan && method < PlanNode::Method_Last; ++method)
  {
    const bool selected = method == plan->GetSelectedMethod();
    std::vector<vtkMRMLModelNode*> models = {plan->GetPredictionNode(method)};
    for (const std::string& fragment : plan->GetMovementFragments(method))
      models.push_back(plan->GetFragmentNode(method, fragment));
    for (vtkMRMLModelNode* model : models)
      if (model && model->GetDisplayNode())
        model->GetDisplayNode()->SetVisibility(selected);
  }
}

std::vector<std::string> vtkSlicerFaceToBoneLogic::GetTemplateNames()
{
  return f2b::osteotomy_template_names();
}

bool vtkSlicerFaceToBoneLogic::AddTargetSkin(vtkMRMLFaceToBonePlanNode* plan)
{
  using TargetNode = vtkMRMLFaceToBoneTargetNode;
  TargetNode* target = plan ? plan->GetTargetNode() : nullptr;
  vtkMRMLModelNode* skin = plan ? plan->GetSkinNode() : nullptr;
  if (!target || !skin || !skin->GetPolyData() || target->GetTargetSkinNode())
    return false;
  const vtkNew<vtkPolyData> surface;
  surface->DeepCopy(skin->GetPolyData());
  const auto count = static_cast<std::size_t>(surface->GetNumberOfPoints());
  f2b::add_point_array(surface, TargetNode::DisplacementArrayName,
                       std::vector<f2b::Vec3>(count, f2b::Vec3::Zero()));
  f2b::add_point_array(surface, TargetNode::WeightArrayName, std::vector<double>(count, 1.0));
  surface->GetPointData()->SetActiveVectors(TargetNode::DisplacementArrayName);
  auto* model = vtkMRMLModelNode::SafeDownCast(
      this->GetMRMLScene()->AddNewNodeByClass("vtkMRMLModelNode", "Target face"));
  model->SetAndObserveMesh(surface);
  model->CreateDefaultDisplayNodes();
  target->SetTargetSkinNodeID(model->GetID());
  return true;
}
