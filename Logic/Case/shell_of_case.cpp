#include "Case/shell_of_case.hpp"

#include "Bridge/grid_file.hpp"
#include "Bridge/json_file.hpp"
#include "Bridge/vtk_surface.hpp"
#include "Case/face_regions.hpp"
#include "Core/error.hpp"
#include "Core/geometry/skin_thickness.hpp"

#include <algorithm>

namespace f2b
{

namespace
{

/// What the case tells by the regions of skin.vtp; nothing where it tells none.
std::optional<ScalarGrid> thickness_by_region(const CaseSession& session)
{
  const auto& told = session.settings.skin_thickness_by_region_mm;
  if (told.empty())
    return std::nullopt;
  const auto skin = read_surface(session.folder.require("skin.vtp", "segment"));
  const std::vector<FaceRegion> regions = regions_of_skin(skin);
  for (const auto& [key, thickness] : told)
    if (std::none_of(regions.begin(), regions.end(),
                     [&key = key](FaceRegion region) { return key_of(region) == key; }))
      throw Error("case.json",
                  "'/skin_thickness_by_region_mm/" + key +
                      "' names a region that the skin does not have",
                  "give the landmarks that tell the regions of the face, or write them into the "
                  "array 'region' of skin.vtp");
  std::vector<double> thickness;
  for (const FaceRegion region : regions)
  {
    const auto found = told.find(key_of(region));
    thickness.push_back(found == told.end() ? session.settings.skin_thickness_mm : found->second);
  }
  return skin_thickness(to_triangle_mesh(skin), thickness, session.settings.skin_thickness_mm);
}

} // namespace

ShellInputs::ShellInputs(const CaseSession& session)
    : skin(read_scalar_grid(session.folder.require("skin_distance.nrrd", "segment"))),
      bone(read_scalar_grid(session.folder.require("bone_distance.nrrd", "segment"))),
      closed_bone(read_scalar_grid(session.folder.require("closed_bone_distance.nrrd", "segment"))),
      hu(read_scalar_grid(session.folder.require("ct.nrrd", "segment"))),
      skin_thickness(thickness_by_region(session))
{
}

namespace
{

using nlohmann::json;

ShellMeshOptions mesh_options(const CaseSession& session, double density)
{
  const json region = read_json(session.folder.require("segment.json", "segment")).at("region_ras");
  ShellMeshOptions options;
  options.region = {vec3_from(region.at("min")), vec3_from(region.at("max"))};
  options.zeta = session.settings.skin_thickness_mm;
  options.density = density;
  options.contact_tolerance_mm = session.settings.contact_tolerance_mm;
  return options;
}

void require_usable(const ShellMeshReport& r)
{
  if (r.quality.inverted_elements > 0 || r.quality.unmatched_inner_faces > 0)
    throw Error("mesh",
                std::to_string(r.quality.inverted_elements) + " elements are inverted and " +
                    std::to_string(r.quality.unmatched_inner_faces) +
                    " prisms stand on no tetrahedron",
                "try another mesh.density, a smaller skin_thickness_mm, or look at the skin in "
                "skin.vtp for sharp clefts",
                ErrorKind::Numerical);
}

} // namespace

ShellMesh mesh_shell(const CaseSession& session, const ShellInputs& inputs, double density,
                     const Progress& progress, std::optional<double> skin_thickness_mm)
{
  ShellMeshOptions options = mesh_options(session, density);
  options.zeta = skin_thickness_mm.value_or(options.zeta);
  const ScalarGrid* map =
      inputs.skin_thickness && !skin_thickness_mm ? &*inputs.skin_thickness : nullptr;
  ShellMesh shell = build_shell_mesh({inputs.skin, inputs.closed_bone, inputs.bone, inputs.hu, map},
                                     options, progress);
  require_usable(shell.report);
  return shell;
}

} // namespace f2b
