#include "Scene/node_edits.hpp"

#include "Bridge/markups.hpp"
#include "Bridge/vtk_surface.hpp"
#include "Case/placed_osteotomies.hpp"
#include "Core/error.hpp"
#include "Scene/case_publisher.hpp"

#include <vtkMRMLFaceToBoneOsteotomyNode.h>
#include <vtkMRMLFaceToBonePlanNode.h>
#include <vtkMRMLFaceToBoneTargetNode.h>
#include <vtkMRMLModelNode.h>
#include <vtkMRMLStorableNode.h>
#include <vtkMRMLStorageNode.h>

#include <vtkPointData.h>

#include <cstdlib>

namespace f2b
{
namespace
{

using OsteotomyNode = vtkMRMLFaceToBoneOsteotomyNode;
using TargetNode = vtkMRMLFaceToBoneTargetNode;

/// Closer than this [mm] two places are the same: files keep fewer digits than memory.
constexpr double same_place_mm = 1e-4;

bool same_plane(const BoundedPlane& a, const BoundedPlane& b)
{
  return (a.center - b.center).norm() < same_place_mm &&
         (a.half_u * a.u - b.half_u * b.u).norm() < same_place_mm &&
         (a.half_v * a.v - b.half_v * b.v).norm() < same_place_mm;
}

bool same_planes(const std::vector<BoundedPlane>& a, const std::vector<BoundedPlane>& b)
{
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), same_plane);
}

/// Whether a node may say something else than its file: a published one whose data were not read
/// does not.
bool holds_data(vtkMRMLStorableNode* node)
{
  return node->GetAttribute(published_time_attribute) ||
         !node->GetAttribute(published_file_attribute);
}

std::vector<BoundedPlane> planes_of(OsteotomyNode* osteotomy, int n, const Path& scratch)
{
  std::vector<BoundedPlane> planes;
  for (int p = 0; p < osteotomy->GetNthFragmentNumberOfPlanes(n); ++p)
  {
    auto* node = vtkMRMLStorableNode::SafeDownCast(osteotomy->GetNthFragmentPlaneNode(n, p));
    if (!node)
      continue;
    const bool in_memory = holds_data(node);
    if (in_memory)
      write_node(node, scratch);
    for (BoundedPlane& plane :
         read_planes(in_memory ? scratch : Path(node->GetStorageNode()->GetFileName())))
      planes.push_back(std::move(plane));
  }
  return planes;
}

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

void write_node(vtkMRMLStorableNode* node, const Path& file)
{
  const auto storage = vtkSmartPointer<vtkMRMLStorageNode>::Take(node->CreateDefaultStorageNode());
  storage->SetFileName(file.c_str());
  if (!storage->WriteData(node))
    throw Error(node->GetName() ? node->GetName() : file.string(), "it cannot be written",
                "check the free space of " + file.parent_path().string());
}

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

void NodeEdits::collect_planes(const Path& folder, const CaseNodes& nodes)
{
  OsteotomyNode* osteotomy = nodes.osteotomy;
  std::vector<Osteotomy> placed;
  if (std::filesystem::exists(folder / "cut.json"))
    placed = placed_osteotomies(CaseFolder(folder));
  for (int n = 0; n < osteotomy->GetNumberOfFragments(); ++n)
  {
    const std::string name = osteotomy->GetNthFragmentName(n);
    const std::vector<BoundedPlane> planes =
        planes_of(osteotomy, n, temporary_file("plane.mrk.json"));
    const auto before = std::find_if(placed.begin(), placed.end(),
                                     [&](const Osteotomy& o) { return o.fragment == name; });
    if (planes.empty() || (before != placed.end() && same_planes(before->planes, planes)))
      continue;
    double point[3];
    if (!osteotomy->GetNthFragmentPoint(n, point))
    {
      if (before == placed.end())
        throw Error("fragment '" + name + "'", "it is cut by planes, but no point of it is known",
                    "give a point on the bone that is to be free");
      osteotomy->SetNthFragmentPoint(n, before->fragment_point.data());
    }
    const Path file = temporary_file("planes " + std::to_string(n) + ".mrk.json");
    write_planes(file, planes);
    m_planes[name] = {file};
    std::vector<std::string> final_names;
    for (std::size_t p = 0; p < planes.size(); ++p)
      final_names.push_back((folder / cut_plane_file(name, p)).string());
    osteotomy->SetNthFragmentTemplate(n, "");
    osteotomy->SetNthFragmentPlaneFileNames(n, final_names);
  }
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
  nodes.target->SetMeshFileName(known.string());
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
    if (const auto planes = m_planes.find(o.fragment); planes != m_planes.end())
      o.planes = planes->second;
  if (has_target())
    session.settings.target.mesh = m_target;
}

} // namespace f2b
