#include "Scene/node_edits.hpp"

#include "Bridge/markups.hpp"
#include "Bridge/vtk_surface.hpp"
#include "Case/placed_osteotomies.hpp"
#include "Core/error.hpp"
#include "Scene/plan_settings.hpp"

#include <vtkMRMLFaceToBoneOsteotomyNode.h>
#include <vtkMRMLFaceToBonePlanNode.h>
#include <vtkMRMLFaceToBoneTargetNode.h>
#include <vtkMRMLModelNode.h>
#include <vtkMRMLStorableNode.h>

#include <nlohmann/json.hpp>

#include <vtkPointData.h>

#include <cstdlib>

namespace f2b
{
namespace
{

using nlohmann::json;
using OsteotomyNode = vtkMRMLFaceToBoneOsteotomyNode;
using TargetNode = vtkMRMLFaceToBoneTargetNode;

bool same_displacements(const std::vector<Vec3>& a, const std::vector<Vec3>& b)
{
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(),
                    [](const Vec3& p, const Vec3& q) { return (p - q).norm() < same_place_mm; });
}

bool has_array(vtkPolyData* surface, const char* name)
{
  return surface && surface->GetPointData()->HasArray(name);
}

/// What a target says of the skin's vertices.
struct SculptedSkin
{
  explicit SculptedSkin(vtkPolyData* surface)
      : displacement(point_vectors(surface, TargetNode::DisplacementArrayName))
  {
    if (has_array(surface, TargetNode::WeightArrayName))
      weight = point_scalars(surface, TargetNode::WeightArrayName);
  }

  std::vector<Vec3> displacement; ///< RAS [mm]
  std::vector<double> weight;     ///< empty where it has none
};

/// The model whose displacement array is the target, null where none has one in memory.
vtkMRMLModelNode* sculpted_model(TargetNode* target)
{
  for (vtkMRMLModelNode* model : {target->GetTargetSkinNode(), target->GetReferenceSkinNode()})
    if (model && holds_data(model) &&
        has_array(model->GetPolyData(), TargetNode::DisplacementArrayName))
      return model;
  return nullptr;
}

} // namespace

NodeEdits::~NodeEdits()
{
  std::error_code ignored;
  if (!m_temporary.empty())
    std::filesystem::remove_all(m_temporary, ignored);
}

Path NodeEdits::temporary_file(const std::string& name)
{
  if (m_temporary.empty())
  {
    std::string pattern = (std::filesystem::temp_directory_path() / "facetobone-XXXXXX").string();
    if (!::mkdtemp(pattern.data()))
      throw Error(pattern, "the folder cannot be made", "check the space for temporary files");
    m_temporary = pattern;
  }
  return m_temporary / name;
}

void NodeEdits::collect_cuts(const Path& folder, const CaseNodes& nodes)
{
  OsteotomyNode* osteotomy = nodes.osteotomy;
  std::vector<Osteotomy> placed;
  if (std::filesystem::exists(folder / "cut.json"))
    placed = placed_osteotomies(CaseFolder(folder));
  for (int n = 0; n < osteotomy->GetNumberOfFragments(); ++n)
  {
    const std::string name = osteotomy->GetNthFragmentName(n);
    const ShownCuts cuts =
        shown_cuts(osteotomy, n, [this] { return temporary_file("shown.mrk.json"); });
    const auto before = std::find_if(placed.begin(), placed.end(),
                                     [&](const Osteotomy& o) { return o.fragment == name; });
    const Osteotomy* known = before != placed.end() ? &*before : nullptr;
    if (!cuts.empty() && !(known && same_cuts(cuts, *known)))
      keep_cuts(osteotomy, n, cuts, known);
  }
}

void NodeEdits::keep_cuts(OsteotomyNode* osteotomy, int n, const ShownCuts& cuts,
                          const Osteotomy* placed)
{
  const std::string name = osteotomy->GetNthFragmentName(n);
  double point[3];
  if (!osteotomy->GetNthFragmentPoint(n, point))
  {
    if (!placed)
      throw Error("fragment '" + name + "'",
                  "it is cut by planes or curves, but no point of it is known",
                  "give a point on the bone that is to be free");
    osteotomy->SetNthFragmentPoint(n, placed->fragment_point.data());
  }
  CutFiles files;
  std::vector<std::string> plane_names;
  if (!cuts.planes.empty())
  {
    files.planes = {temporary_file("planes " + std::to_string(n) + ".mrk.json")};
    write_planes(files.planes.front(), cuts.planes);
    for (std::size_t p = 0; p < cuts.planes.size(); ++p)
      plane_names.push_back(cut_plane_file(name, p));
  }
  for (const ShownCurve& curve : cuts.curves)
  {
    files.curves.push_back(temporary_file(cut_curve_file(name, curve.name)));
    write_points(files.curves.back(), curve.markup);
  }
  json rest = rest_from_text(osteotomy->GetNthFragmentOtherSettings(n));
  const json curves = curve_settings(cuts, name, rest.value("curves", json::array()), placed);
  rest.erase("curves");
  if (!curves.empty())
    rest["curves"] = curves;
  osteotomy->SetNthFragmentTemplate(n, "");
  osteotomy->SetNthFragmentPlaneFileNames(n, plane_names);
  osteotomy->SetNthFragmentOtherSettings(n, text_of_rest(rest));
  m_cuts[name] = std::move(files);
}

void NodeEdits::collect_target(const Path& folder, const CaseNodes& nodes)
{
  vtkMRMLModelNode* model = sculpted_model(nodes.target);
  if (!model || !std::filesystem::exists(folder / "skin.vtp"))
    return;
  const SculptedSkin sculpted(model->GetPolyData());
  const Path known = folder / "target.vtp";
  bool keep_weight = !sculpted.weight.empty();
  if (std::filesystem::exists(known))
  {
    const SculptedSkin before(read_surface(known));
    const bool painted = keep_weight && sculpted.weight != before.weight;
    if (!painted && same_displacements(before.displacement, sculpted.displacement))
      return;
    // a mask that was computed from the target before is computed anew
    keep_weight = painted || (keep_weight && nodes.target->GetKind() == TargetNode::Mesh);
  }
  const auto skin = read_surface(folder / "skin.vtp");
  std::vector<Vec3> points = points_of(skin);
  if (points.size() != sculpted.displacement.size())
    throw Error(model->GetName() ? model->GetName() : "the target",
                "it has " + std::to_string(sculpted.displacement.size()) + " vertices, the skin " +
                    std::to_string(points.size()),
                "sculpt this case's own skin");
  for (std::size_t v = 0; v < points.size(); ++v)
    points[v] += sculpted.displacement[v];
  const auto moved = with_points(skin, points);
  if (keep_weight)
    add_point_array(moved, TargetNode::WeightArrayName, sculpted.weight);
  m_target = temporary_file("target.vtp");
  write_surface(m_target, moved);
  nodes.target->SetKind(TargetNode::Mesh);
  nodes.target->SetMeshFileName(known.filename().string());
}

void NodeEdits::collect_landmarks(const Path& folder, const CaseNodes& nodes)
{
  auto* node = vtkMRMLStorableNode::SafeDownCast(nodes.plan->GetLandmarksNode());
  const Path known = folder / "landmarks.mrk.json";
  if (!node || !holds_data(node) || !std::filesystem::exists(known))
    return;
  const Path file = temporary_file("landmarks.mrk.json");
  write_node(node, file);
  const Landmarks now = read_landmarks(file), before = read_landmarks(known);
  const bool same =
      now.size() == before.size() &&
      std::equal(now.begin(), now.end(), before.begin(),
                 [](const auto& a, const auto& b)
                 { return a.first == b.first && (a.second - b.second).norm() < same_place_mm; });
  if (same)
    return;
  const Path beside = folder / ".landmarks.mrk.json";
  write_landmarks(beside, now);
  std::filesystem::rename(beside, known);
}

void NodeEdits::apply(CaseSession& session) const
{
  for (OsteotomySettings& o : session.settings.osteotomies)
    if (const auto cuts = m_cuts.find(o.fragment); cuts != m_cuts.end())
    {
      o.planes = cuts->second.planes;
      for (std::size_t c = 0; c < o.curves.size() && c < cuts->second.curves.size(); ++c)
        o.curves[c].markup = cuts->second.curves[c];
    }
  if (has_target())
    session.settings.target.mesh = m_target;
}

} // namespace f2b
