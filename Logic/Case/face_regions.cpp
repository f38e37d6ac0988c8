#include "Case/face_regions.hpp"

#include "Bridge/grid_file.hpp"
#include "Bridge/point_labels.hpp"
#include "Core/error.hpp"
#include "Core/inverse/skin_error.hpp"
#include "Core/mesh/skin_over_bone.hpp"

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

json regions_json(const TriangleMesh& skin, const std::vector<FaceRegion>& regions,
                  const std::vector<std::string>& missing)
{
  const std::vector<double> areas = vertex_areas(skin);
  json names = json::array(), area_mm2 = json::object();
  for (const FaceRegion region : all_face_regions())
  {
    names.push_back(key_of(region));
    double area = 0;
    for (std::size_t v = 0; v < areas.size(); ++v)
      area += regions[v] == region ? areas[v] : 0;
    area_mm2[key_of(region)] = area;
  }
  return {{"array", skin_region_array},
          {"names", names},
          {"from", missing.empty() ? "landmarks" : "nothing"},
          {"missing_landmarks", missing},
          {"area_mm2", area_mm2}};
}

std::string regions_note(const std::vector<std::string>& missing)
{
  std::string list;
  for (const std::string& name : missing)
    list += (list.empty() ? "" : ", ") + name;
  return "the regions of the face are not told apart: the landmarks " + list + " are not given";
}

} // namespace f2b
