#include "Case/face_regions.hpp"

#include "Bridge/grid_file.hpp"
#include "Bridge/json_file.hpp"
#include "Bridge/point_labels.hpp"
#include "Core/error.hpp"
#include "Core/inverse/skin_error.hpp"
#include "Core/mesh/skin_over_bone.hpp"

#include <vtkNew.h>
#include <vtkStaticPointLocator.h>

#include <cmath>
#include <cstdio>

namespace f2b
{

using nlohmann::json;

std::vector<FaceRegion> regions_of_skin(vtkPolyData* skin)
{
  if (!has_point_array(skin, skin_region_array))
    return std::vector<FaceRegion>(static_cast<std::size_t>(skin->GetNumberOfPoints()),
                                   FaceRegion::Other);
  std::vector<FaceRegion> regions;
  for (const double value : point_scalars(skin, skin_region_array))
  {
    const auto region = face_region_of(value);
    if (!region)
    {
      char problem[120];
      std::snprintf(problem, sizeof problem, "its array 'region' holds %g, and regions are 0 to %d",
                    value, static_cast<int>(face_region_count) - 1);
      throw Error("skin.vtp", problem, "use the values that segment.json names under 'regions'");
    }
    regions.push_back(*region);
  }
  return regions;
}

void add_regions(vtkPolyData* skin, const std::vector<FaceRegion>& regions)
{
  std::vector<int> values;
  for (const FaceRegion region : regions)
    values.push_back(static_cast<int>(region));
  add_point_labels(skin, skin_region_array, values);
}

SkinParts skin_parts(const CaseFolder& folder, const LoadedFace& face)
{
  return {face.skin_area, regions_of_skin(face.skin),
          fragments_below(read_scalar_grid(folder.require("closed_bone_distance.nrrd", "segment")),
                          read_label_grid(folder.require("bone_parts.nrrd", "cut")),
                          face.reference_skin.points)};
}

json region_areas(const TriangleMesh& skin, const std::vector<FaceRegion>& regions)
{
  const std::vector<double> areas = vertex_areas(skin);
  json area_mm2 = json::object();
  for (const FaceRegion region : all_face_regions())
  {
    double area = 0;
    for (std::size_t v = 0; v < areas.size(); ++v)
      area += regions[v] == region ? areas[v] : 0;
    area_mm2[key_of(region)] = area;
  }
  return area_mm2;
}

namespace
{

/// Whether a skin's regions are not those whose areas are told.
bool are_edited(const TriangleMesh& skin, const std::vector<FaceRegion>& regions, const json& told)
{
  if (!told.contains(made_area_key))
    return false;
  const json areas = region_areas(skin, regions);
  for (const auto& [key, area] : areas.items())
    if (std::abs(area.get<double>() - told.at(made_area_key).value(key, 0.0)) > 0.01)
      return true;
  return false;
}

} // namespace

std::optional<std::vector<FaceRegion>>
edited_regions(const CaseSession& session, const TriangleMesh& skin, std::vector<FaceRegion> made)
{
  constexpr double same_place_mm = 3;
  const CaseFolder& folder = session.folder;
  for (const char* name : {case_settings_name, "skin.vtp", "segment.json"})
    if (!folder.has(name))
      return std::nullopt;
  if (read_json(folder.file(case_settings_name)).value("ct", "") !=
      session.document.value("ct", ""))
    return std::nullopt;
  const auto before = read_surface(folder.file("skin.vtp"));
  const std::vector<FaceRegion> edited = regions_of_skin(before);
  const json told = read_json(folder.file("segment.json")).value("regions", json::object());
  if (!are_edited(to_triangle_mesh(before), edited, told))
    return std::nullopt;
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(before);
  locator->BuildLocator();
  for (std::size_t v = 0; v < made.size(); ++v)
  {
    double squared = 0;
    const vtkIdType near =
        locator->FindClosestPointWithinRadius(same_place_mm, skin.points[v].data(), squared);
    if (near >= 0)
      made[v] = edited[static_cast<std::size_t>(near)];
  }
  return made;
}

json regions_json(const TriangleMesh& skin, const std::vector<FaceRegion>& regions,
                  const std::vector<std::string>& missing)
{
  json names = json::array();
  for (const FaceRegion region : all_face_regions())
    names.push_back(key_of(region));
  return {{"array", skin_region_array},
          {"names", names},
          {"from", missing.empty() ? "landmarks" : "nothing"},
          {"missing_landmarks", missing},
          {"area_mm2", region_areas(skin, regions)}};
}

std::string regions_note(const std::vector<std::string>& missing)
{
  std::string list;
  for (const std::string& name : missing)
    list += (list.empty() ? "" : ", ") + name;
  return "the regions of the face are not told apart: the landmarks " + list + " are not given";
}

} // namespace f2b
