#include "Scene/case_publisher.hpp"

#include "Bridge/json_file.hpp"
#include "Case/case_settings.hpp"
#include "Case/placed_osteotomies.hpp"
#include "Scene/plan_results.hpp"
#include "Scene/published_nodes.hpp"

#include <vtkMRMLFaceToBoneOsteotomyNode.h>
#include <vtkMRMLFaceToBonePlanNode.h>
#include <vtkMRMLFaceToBoneTargetNode.h>
#include <vtkMRMLLinearTransformNode.h>
#include <vtkMRMLModelDisplayNode.h>
#include <vtkMRMLModelNode.h>

#include <nlohmann/json.hpp>

#include <vtkMatrix4x4.h>
#include <vtkNew.h>

namespace f2b
{
namespace
{

using nlohmann::json;
using Osteotomy = vtkMRMLFaceToBoneOsteotomyNode;
using Plan = vtkMRMLFaceToBonePlanNode;
using Target = vtkMRMLFaceToBoneTargetNode;

const ModelLook skin_look = {0.94, 0.80, 0.71, 0.45, true};
const ModelLook bone_look = {0.95, 0.91, 0.80, 1, true};
const ModelLook mesh_look = {0.80, 0.60, 0.55, 1, false};
const ModelLook target_look = {0.45, 0.75, 0.55, 0.6, false};
const ModelLook face_look = {0.94, 0.80, 0.71, 0.8, true};
/// Fragments one after another, by day and by colour-blind eyes.
const ModelLook fragment_looks[] = {{0.34, 0.71, 0.91, 1, true},
                                    {0.90, 0.62, 0.00, 1, true},
                                    {0.00, 0.62, 0.45, 1, true},
                                    {0.80, 0.47, 0.65, 1, true}};

ModelLook fragment_look(std::size_t f)
{
  return fragment_looks[f % std::size(fragment_looks)];
}

class CasePublisher
{
public:
  CasePublisher(const CaseOutlook& files, vtkMRMLScene* scene, const CaseNodes& nodes,
                bool read_data)
      : m_files(files), m_nodes(nodes), m_published(files, scene, read_data)
  {
  }

  void publish()
  {
    m_nodes.plan->SetCaseFolder(m_files.folder.string());
    segment();
    cut();
    target();
    plan();
    prediction();
    read_results(m_files, m_nodes.plan);
    set_step_statuses(m_files, m_nodes.plan);
  }

private:
  void segment();
  void cut();
  void fragment(std::size_t f, const json& told);
  void target();
  void plan();
  void method(int method, const json& told);
  void planned_fragment(int method, std::size_t f, const json& told);
  void prediction();
  std::vector<std::string> fragment_names() const;

  const CaseOutlook& m_files;
  CaseNodes m_nodes;
  PublishedNodes m_published;
  std::vector<std::string> m_fragments; ///< of the cut
};

void CasePublisher::segment()
{
  Plan* plan = m_nodes.plan;
  m_published.show(plan, Plan::CaseVolumeRole, "ct.nrrd", "vtkMRMLScalarVolumeNode", "CT");
  m_published.show(plan, Plan::LabelsRole, "labels.nrrd", "vtkMRMLLabelMapVolumeNode", "Tissues");
  m_published.show(plan, Plan::LandmarksRole, "landmarks.mrk.json", "vtkMRMLMarkupsFiducialNode",
                   "Landmarks");
  auto* skin = m_published.show_model(plan, Plan::SkinRole, "skin.vtp", "Skin", skin_look);
  ModelLook look = bone_look;
  look.visible = !m_files.has("cut.json");
  auto* bone = m_published.show_model(plan, Plan::BoneRole, "bone.vtp", "Bone", look);
  m_published.show_model(plan, Plan::MeshRole, "mesh.vtu", "Tissue mesh", mesh_look);
  m_nodes.osteotomy->SetBoneNodeID(bone ? bone->GetID() : nullptr);
  m_nodes.osteotomy->SetLandmarksNodeID(plan->GetNodeReferenceID(Plan::LandmarksRole));
  m_nodes.target->SetReferenceSkinNodeID(skin ? skin->GetID() : nullptr);
}

/// Whole bone and cut bone lie on each other: only one of them is shown when the other comes.
void show_instead(vtkMRMLModelNode* shown, vtkMRMLModelNode* hidden)
{
  if (shown && shown->GetDisplayNode())
    shown->GetDisplayNode()->SetVisibility(1);
  if (hidden && hidden->GetDisplayNode())
    hidden->GetDisplayNode()->SetVisibility(0);
}

void CasePublisher::cut()
{
  Osteotomy* osteotomy = m_nodes.osteotomy;
  MRMLNodeModifyBlocker blocker(osteotomy);
  const bool had = osteotomy->GetUncutBoneNode() != nullptr;
  auto* uncut = m_published.show_model(osteotomy, Osteotomy::UncutBoneRole, "uncut_bone.vtp",
                                       "Uncut bone", bone_look);
  if (!uncut && had)
    show_instead(m_nodes.plan->GetBoneNode(), nullptr);
  if (uncut && m_published.made_new())
    show_instead(uncut, m_nodes.plan->GetBoneNode());
  if (m_files.has("cut.json"))
  {
    const json told = read_json(m_files.file("cut.json"));
    for (std::size_t f = 0; f < told.at("fragments").size(); ++f)
      fragment(f, told.at("fragments")[f]);
  }
  for (const char* role :
       {Osteotomy::RestFragmentRole, Osteotomy::CutPlanesRole, Osteotomy::CutCurvesRole})
    m_published.hide_others(osteotomy, role, m_fragments);
}

void CasePublisher::fragment(std::size_t f, const json& told)
{
  Osteotomy* osteotomy = m_nodes.osteotomy;
  const auto name = told.at("name").get<std::string>();
  m_fragments.push_back(name);
  const int n = static_cast<int>(f);
  // Only the cut knows what a template calls its fragment; but case.json may name another template
  // since.
  if (n < osteotomy->GetNumberOfFragments())
  {
    const std::string template_name = osteotomy->GetNthFragmentTemplate(n);
    if (osteotomy->GetNthFragmentName(n) == template_name &&
        told.value("template", template_name) == template_name)
      osteotomy->SetNthFragmentName(n, name);
  }
  m_published.show_model(osteotomy, Osteotomy::RestFragmentRole + name,
                         "fragment_" + file_part(name) + ".vtp", name, fragment_look(f));
  const auto planes = told.at("planes").get<std::size_t>();
  for (std::size_t p = 0; p < planes; ++p)
    m_published.show(osteotomy, Osteotomy::CutPlanesRole + name, cut_plane_file(name, p),
                     "vtkMRMLMarkupsPlaneNode", name + " cut " + std::to_string(p + 1),
                     static_cast<int>(p));
  m_published.hide(osteotomy, Osteotomy::CutPlanesRole + name, static_cast<int>(planes));
  int c = 0;
  for (const json& curve : told.value("curves", json::array()))
  {
    const auto curve_name = curve.at("name").get<std::string>();
    m_published.show(osteotomy, Osteotomy::CutCurvesRole + name, cut_curve_file(name, curve_name),
                     curve.at("closed").get<bool>() ? "vtkMRMLMarkupsClosedCurveNode"
                                                    : "vtkMRMLMarkupsCurveNode",
                     name + " cut " + curve_name, c++);
  }
  m_published.hide(osteotomy, Osteotomy::CutCurvesRole + name, c);
}

void CasePublisher::target()
{
  m_published.show_model(m_nodes.target, Target::TargetSkinRole, "target.vtp", "Target face",
                         target_look);
  m_published.show_model(m_nodes.target, Target::ScanRole, "target_scan.vtp", "Target scan",
                         target_look);
  m_nodes.target->SetPeakDisplacementMm(
      m_files.has("target.json")
          ? read_json(m_files.file("target.json")).value("peak_displacement_mm", 0.0)
          : 0);
}

void CasePublisher::plan()
{
  const json told =
      m_files.has("plan.json") ? read_json(m_files.file("plan.json")) : json::object();
  for (int m = 0; m < Plan::Method_Last; ++m)
    method(m, told.value("methods", json::object())
                  .value(Plan::GetSelectedMethodAsString(m), json::object()));
}

void CasePublisher::method(int method, const json& told)
{
  Plan* plan = m_nodes.plan;
  const std::string name = Plan::GetSelectedMethodAsString(method);
  ModelLook look = face_look;
  look.visible = method == plan->GetSelectedMethod();
  auto* face = m_published.show_model(plan, Plan::GetPredictionRole(method),
                                      "predicted_" + name + ".vtp", "Face by " + name, look);
  if (face && m_published.made_new() && look.visible)
    show_instead(face, plan->GetSkinNode());
  if (face)
  {
    const json error = told.value("skin_error_mm", json::object());
    // half millimetres, so that the ends of the bar are round
    const double range = std::max(0.5, std::ceil(2 * error.value("p95", 0.5)) / 2);
    show_signed_distances(face, Plan::DistanceArrayName, range);
  }
  const json fragments = told.value("fragments", json::array());
  for (std::size_t f = 0; f < fragments.size(); ++f)
    planned_fragment(method, f, fragments[f]);
  const std::vector<std::string> names =
      fragments.empty() ? std::vector<std::string>() : m_fragments;
  m_published.hide_others(plan, Plan::GetFragmentRole(method, ""), names);
  m_published.hide_others(plan, Plan::GetTransformRole(method, ""), names);
}

void CasePublisher::planned_fragment(int method, std::size_t f, const json& told)
{
  Plan* plan = m_nodes.plan;
  const auto name = told.at("name").get<std::string>();
  const std::string way = Plan::GetSelectedMethodAsString(method);
  auto* transform = vtkMRMLLinearTransformNode::SafeDownCast(m_published.show(
      plan, Plan::GetTransformRole(method, name), file_part(name) + "_" + way + ".h5",
      "vtkMRMLLinearTransformNode", name + " by " + way));
  ModelLook look = fragment_look(f);
  look.visible = method == plan->GetSelectedMethod();
  auto* model = m_published.show_model(plan, Plan::GetFragmentRole(method, name),
                                       "fragment_" + file_part(name) + ".vtp",
                                       name + " planned by " + way, look);
  if (!transform || !model)
    return;
  if (m_published.made_new() && look.visible) // what is planned is solid, where it was is a ghost
    if (auto* rest =
            m_nodes.osteotomy->GetNthFragmentRestNode(m_nodes.osteotomy->GetFragmentIndex(name));
        rest && rest->GetDisplayNode())
      rest->GetDisplayNode()->SetOpacity(0.3);
  const vtkNew<vtkMatrix4x4> matrix;
  for (int i = 0; i < 16; ++i)
    matrix->SetElement(i / 4, i % 4,
                       told.at("matrix_ras").at(static_cast<std::size_t>(i)).get<double>());
  transform->SetMatrixTransformToParent(matrix);
  model->SetAndObserveTransformNodeID(transform->GetID());
}

void CasePublisher::prediction()
{
  Plan* plan = m_nodes.plan;
  ModelLook look = face_look;
  look.visible = false;
  m_published.show_model(plan, Plan::StatedPredictionRole, "predicted.vtp",
                         "Face of the stated movement", look);
  for (std::size_t f = 0; f < m_fragments.size(); ++f)
  {
    ModelLook moved = fragment_look(f);
    moved.visible = false;
    m_published.show_model(plan, Plan::StatedFragmentRole + m_fragments[f],
                           file_part(m_fragments[f]) + "_moved.vtp", m_fragments[f] + " as stated",
                           moved);
  }
  m_published.hide_others(plan, Plan::StatedFragmentRole, m_fragments);
}

} // namespace

void publish_case(const CaseOutlook& files, vtkMRMLScene* scene, const CaseNodes& nodes,
                  bool read_data)
{
  MRMLNodeModifyBlocker plan(nodes.plan), target(nodes.target);
  CasePublisher(files, scene, nodes, read_data).publish();
}

} // namespace f2b
