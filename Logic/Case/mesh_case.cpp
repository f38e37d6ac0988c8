#include "Bridge/grid_file.hpp"
#include "Bridge/json_file.hpp"
#include "Bridge/mesh_file.hpp"
#include "Case/placed_osteotomies.hpp"
#include "Case/verbs.hpp"
#include "Core/error.hpp"
#include "Core/mesh/contact.hpp"
#include "Meshing/shell_mesh.hpp"

namespace f2b
{
namespace
{

using nlohmann::json;

ShellMeshOptions mesh_options(const CaseSession& session)
{
  const json region = read_json(session.folder.require("segment.json", "segment")).at("region_ras");
  ShellMeshOptions options;
  options.region = {vec3_from(region.at("min")), vec3_from(region.at("max"))};
  options.zeta = session.settings.skin_thickness_mm;
  options.density = session.settings.mesh_density;
  options.contact_tolerance_mm = session.settings.contact_tolerance_mm;
  return options;
}

json fidelity_json(const DistanceFigures& d)
{
  return {{"p95", d.p95}, {"p99.5", d.p995}, {"max", d.max}, {"max_at_ras", to_json(d.max_place)}};
}

json report_json(const ShellMeshReport& r, const ContactReport& contact)
{
  json remarks = json::array();
  for (const MeshRemark& remark : r.remarks)
    remarks.push_back({{"what", remark.what}, {"where_ras", to_json(remark.where)}});
  return {{"prisms", r.prisms},
          {"tets", r.tets},
          {"nodes", r.nodes},
          {"dofs", 3 * r.nodes},
          {"min_dihedral_deg", r.quality.min_dihedral_deg},
          {"min_prism_scaled_jacobian", r.quality.min_scaled_jacobian},
          {"inverted_elements", r.quality.inverted_elements},
          {"unmatched_inner_faces", r.quality.unmatched_inner_faces},
          {"mesh_volume_mm3", r.mesh_volume},
          {"label_volume_mm3", r.label_volume},
          {"skin_to_ct_mm", fidelity_json(r.fidelity.mesh_to_ct)},
          {"ct_to_skin_mm", fidelity_json(r.fidelity.ct_to_mesh)},
          {"holes", r.holes},
          {"contact_nodes",
           {{"fixed", contact.fixed},
            {"fragments", contact.fragments},
            {"released", contact.released},
            {"released_between", contact.released_between}}},
          {"remarks", remarks}};
}

/// A mesh with inverted elements would give forces without meaning.
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

void mesh_case(CaseSession& session)
{
  const Stopwatch watch;
  const CaseFolder& folder = session.folder;
  const ScalarGrid skin = read_scalar_grid(folder.require("skin_distance.nrrd", "segment"));
  const ScalarGrid bone = read_scalar_grid(folder.require("bone_distance.nrrd", "segment"));
  const ScalarGrid closed =
      read_scalar_grid(folder.require("closed_bone_distance.nrrd", "segment"));
  const ScalarGrid hu = read_scalar_grid(folder.require("ct.nrrd", "segment"));
  const std::vector<Osteotomy> osteotomies = placed_osteotomies(folder);

  ShellMesh shell =
      build_shell_mesh({skin, closed, bone, hu}, mesh_options(session), session.progress);
  require_usable(shell.report);
  session.progress("finding what the tissue hangs on", 0.95);
  const BonePartition partition = cut_bone(bone, closed, osteotomies);
  const ContactReport contact =
      assign_contacts(shell.mesh, partition, session.settings.release_margin_mm);

  CaseChange change(session.folder);
  write_mesh(change.file("mesh.vtu"), shell.mesh);
  json report = report_json(shell.report, contact);
  report["seconds"] = watch.seconds();
  write_json(change.file("mesh.json"), report);
  change.commit("mesh");
  session.progress("meshed", 1);
}

} // namespace f2b
