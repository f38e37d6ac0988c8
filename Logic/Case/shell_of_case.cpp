#include "Case/shell_of_case.hpp"

#include "Bridge/grid_file.hpp"
#include "Bridge/json_file.hpp"
#include "Core/error.hpp"

namespace f2b
{

ShellInputs::ShellInputs(const CaseFolder& folder)
    : skin(read_scalar_grid(folder.require("skin_distance.nrrd", "segment"))),
      bone(read_scalar_grid(folder.require("bone_distance.nrrd", "segment"))),
      closed_bone(read_scalar_grid(folder.require("closed_bone_distance.nrrd", "segment"))),
      hu(read_scalar_grid(folder.require("ct.nrrd", "segment")))
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
  ShellMesh shell = build_shell_mesh({inputs.skin, inputs.closed_bone, inputs.bone, inputs.hu},
                                     options, progress);
  require_usable(shell.report);
  return shell;
}

} // namespace f2b
