#include "Scene/shown_cuts.hpp"

#include "Bridge/json_file.hpp"
#include "Case/case_session.hpp"
#include "Case/placed_osteotomies.hpp"
#include "Core/error.hpp"
#include "Scene/case_publisher.hpp"

#include <vtkMRMLFaceToBoneOsteotomyNode.h>
#include <vtkMRMLStorableNode.h>
#include <vtkMRMLStorageNode.h>

#include <algorithm>

namespace f2b
{
namespace
{

using OsteotomyNode = vtkMRMLFaceToBoneOsteotomyNode;
using nlohmann::json;

/// The file that says what a node does.
Path file_of(vtkMRMLStorableNode* node, const std::function<Path()>& scratch)
{
  if (!holds_data(node))
    return node->GetStorageNode()->GetFileName();
  const Path file = scratch();
  write_node(node, file);
  return file;
}

bool same_plane(const BoundedPlane& a, const BoundedPlane& b)
{
  return (a.center - b.center).norm() < same_place_mm &&
         (a.half_u * a.u - b.half_u * b.u).norm() < same_place_mm &&
         (a.half_v * a.v - b.half_v * b.v).norm() < same_place_mm;
}

bool same_curve(const ShownCurve& shown, const SweptCurve& placed)
{
  const auto& points = shown.markup.points;
  return (shown.markup.type == "ClosedCurve") == placed.closed &&
         points.size() == placed.points.size() &&
         std::equal(points.begin(), points.end(), placed.points.begin(),
                    [](const ControlPoint& a, const Vec3& b)
                    { return (a.position - b).norm() < same_place_mm; });
}

/// The name that its file bears, or the node's own; never one of those before.
std::string curve_name(vtkMRMLNode* node, const std::string& fragment,
                       const std::vector<ShownCurve>& others)
{
  const char* file = node->GetAttribute(published_file_attribute);
  const std::string wanted =
      file ? curve_name_of(fragment, file) : file_part(node->GetName() ? node->GetName() : "curve");
  std::string name = wanted;
  for (int number = 2; std::any_of(others.begin(), others.end(),
                                   [&](const ShownCurve& other) { return other.name == name; });
       ++number)
    name = wanted + "_" + std::to_string(number);
  return name;
}

} // namespace

bool holds_data(vtkMRMLStorableNode* node)
{
  return node->GetAttribute(published_time_attribute) ||
         !node->GetAttribute(published_file_attribute);
}

void write_node(vtkMRMLStorableNode* node, const Path& file)
{
  const auto storage = vtkSmartPointer<vtkMRMLStorageNode>::Take(node->CreateDefaultStorageNode());
  storage->SetFileName(file.c_str());
  if (!storage->WriteData(node))
    throw Error(node->GetName() ? node->GetName() : file.string(), "it cannot be written",
                "check the free space of " + file.parent_path().string());
}

ShownCuts shown_cuts(OsteotomyNode* osteotomy, int n, const std::function<Path()>& scratch)
{
  ShownCuts cuts;
  for (int p = 0; p < osteotomy->GetNthFragmentNumberOfPlanes(n); ++p)
    if (auto* node = vtkMRMLStorableNode::SafeDownCast(osteotomy->GetNthFragmentPlaneNode(n, p)))
      for (BoundedPlane& plane : read_planes(file_of(node, scratch)))
        cuts.planes.push_back(std::move(plane));
  for (int c = 0; c < osteotomy->GetNthFragmentNumberOfCurves(n); ++c)
    if (auto* node = vtkMRMLStorableNode::SafeDownCast(osteotomy->GetNthFragmentCurveNode(n, c)))
      cuts.curves.push_back({curve_name(node, osteotomy->GetNthFragmentName(n), cuts.curves),
                             read_points(file_of(node, scratch))});
  return cuts;
}

bool same_cuts(const ShownCuts& cuts, const Osteotomy& placed)
{
  return cuts.planes.size() == placed.planes.size() && cuts.curves.size() == placed.curves.size() &&
         std::equal(cuts.planes.begin(), cuts.planes.end(), placed.planes.begin(), same_plane) &&
         std::equal(cuts.curves.begin(), cuts.curves.end(), placed.curves.begin(), same_curve);
}

json curve_settings(const ShownCuts& cuts, const std::string& fragment, const json& stated,
                    const Osteotomy* placed)
{
  json curves = json::array();
  for (const ShownCurve& curve : cuts.curves)
  {
    const std::string file = cut_curve_file(fragment, curve.name);
    json entry = json::object();
    for (const json& known : stated)
      if (file_part(curve_name_of(fragment, known.value("markup", ""))) == curve.name)
        entry = known;
    if (entry.empty() && placed) // a template's: straight from point to point
      for (const SweptCurve& known : placed->curves)
        if (file_part(known.name) == curve.name)
          entry = {{"direction_ras", to_json(known.direction)},
                   {"depth_mm", known.depth_mm},
                   {"lead_mm", known.lead_mm},
                   {"straight", true}};
    entry["markup"] = file;
    curves.push_back(std::move(entry));
  }
  return curves;
}

} // namespace f2b
