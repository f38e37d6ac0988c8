#include "Bridge/json_file.hpp"
#include "Bridge/mesh_file.hpp"
#include "Case/placed_osteotomies.hpp"
#include "Case/shell_of_case.hpp"
#include "Case/verbs.hpp"
#include "Core/mesh/contact.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace f2b
{
namespace
{

using nlohmann::json;

json fidelity_json(const DistanceFigures& d)
{
  return {{"p95", d.p95}, {"p99.5", d.p995}, {"max", d.max}, {"max_at_ras", to_json(d.max_place)}};
}

/// Tetrahedra by their smallest dihedral angle, and the share of those that a solver feels.
json histogram_json(const MeshQuality& quality)
{
  constexpr int poor_bins = 2; // below 10 degrees
  double all = 0, poor = 0;
  for (int bin = 0; bin < MeshQuality::bin_count; ++bin)
  {
    const double count = quality.dihedral_histogram[static_cast<std::size_t>(bin)];
    all += count;
    poor += bin < poor_bins ? count : 0;
  }
  return {{"bin_deg", MeshQuality::bin_deg},
          {"tets", quality.dihedral_histogram},
          {"share_below_10_deg", all > 0 ? poor / all : 0}};
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
          {"dihedral_histogram", histogram_json(r.quality)},
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

/// The shell with about as many tetrahedra as are asked for. Their number goes with density, but for
/// what the shape needs anyway; the density that was found becomes the case's own.
ShellMesh shell_of_size(CaseSession& session, const ShellInputs& inputs, int wanted)
{
  constexpr double near_enough = 0.05, least_density = 0.02, most_density = 20;
  constexpr int tries = 4;
  std::optional<ShellMesh> best;
  double density = session.settings.mesh_density, best_density = density;
  const auto apart = [wanted](const ShellMesh& shell)
  { return std::abs(std::log(static_cast<double>(shell.report.tets) / wanted)); };
  for (int attempt = 0; attempt < tries; ++attempt)
  {
    const Progress part = [&](std::string_view what, double fraction)
    { session.progress(what, (attempt + fraction) / tries); };
    ShellMesh shell = mesh_shell(session, inputs, density, part);
    const double next =
        std::clamp(density * wanted / shell.report.tets, least_density, most_density);
    if (!best || apart(shell) < apart(*best))
    {
      best = std::move(shell);
      best_density = density;
    }
    if (apart(*best) < std::log1p(near_enough) || next == density)
      break;
    density = next;
  }
  session.settings.mesh_density = best_density;
  session.document["mesh"]["density"] = best_density;
  return std::move(*best);
}

} // namespace

void mesh_case(CaseSession& session)
{
  const Stopwatch watch;
  const CaseFolder& folder = session.folder;
  const ShellInputs inputs(session);
  const std::vector<Osteotomy> osteotomies = placed_osteotomies(folder);

  const std::optional<int> wanted = session.settings.mesh_tetrahedra;
  ShellMesh shell =
      wanted ? shell_of_size(session, inputs, *wanted)
             : mesh_shell(session, inputs, session.settings.mesh_density, session.progress);
  session.progress("finding what the tissue hangs on", 0.95);
  const BonePartition partition = cut_bone(inputs.bone, inputs.closed_bone, osteotomies);
  const ContactReport contact =
      assign_contacts(shell.mesh, partition, session.settings.release_margin_mm);

  CaseChange change(session.folder);
  session.write_settings(change.folder());
  write_mesh(change.file("mesh.vtu"), shell.mesh);
  json report = report_json(shell.report, contact);
  report["seconds"] = watch.seconds();
  write_json(change.file("mesh.json"), report);
  change.commit("mesh");
  session.progress("meshed", 1);
}

} // namespace f2b
