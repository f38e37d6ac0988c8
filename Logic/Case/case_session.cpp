#include "Case/case_session.hpp"

#include "Bridge/json_file.hpp"
#include "Bridge/material_file.hpp"
#include "Bridge/mesh_file.hpp"
#include "Bridge/skin_mapping.hpp"
#include "Case/fragment_json.hpp"
#include "Case/settings_paths.hpp"
#include "Core/error.hpp"
#include "Core/inverse/skin_error.hpp"
#include "Core/solve/threads.hpp"

#include <algorithm>
#include <cstdio>

namespace f2b
{

using nlohmann::json;

CaseSession::CaseSession(const Path& path, const json& case_document, const Path& source,
                         Progress told)
    : folder(path), progress(std::move(told))
{
  change_settings(case_document, source);
}

// the folder comes first: opening it finishes what a killed process left, its settings among them
CaseSession::CaseSession(const Path& path, Progress told) : folder(path), progress(std::move(told))
{
  const Path source = folder.require(case_settings_name, "segment");
  change_settings(read_json(source), source);
}

CaseSession CaseSession::open(const Path& path, const Progress& progress)
{
  if (!std::filesystem::is_directory(path))
    throw Error(path.string(), "there is no such case folder",
                "make the case first: facetobone segment CASE.json -o " + path.string());
  return CaseSession(path, progress);
}

void CaseSession::change_settings(const json& case_document, const Path& source)
{
  settings = parse_settings(case_document, source);
  document = with_absolute_paths(case_document, source);
  document["name"] = settings.name; // kept, as the file's own name is not
  if (settings.threads > 0)
    set_thread_count(settings.threads);
}

void CaseSession::write_settings(const Path& staging) const
{
  write_json(staging / case_settings_name, with_folder_paths(document, folder.path()));
}

void require_inputs_elsewhere(const CaseSettings& settings, const Path& folder)
{
  std::vector<Path> inputs = {settings.ct,
                              settings.landmarks,
                              settings.target.mesh,
                              settings.target.warp_from,
                              settings.target.warp_to,
                              settings.seeds,
                              settings.labels};
  for (const OsteotomySettings& o : settings.osteotomies)
  {
    inputs.insert(inputs.end(), o.planes.begin(), o.planes.end());
    for (const CurveSettings& curve : o.curves)
      inputs.push_back(curve.markup);
  }
  for (const ProtectedSettings& p : settings.protected_structures)
    inputs.insert(inputs.end(), {p.curve, p.mesh});
  const Path home = std::filesystem::weakly_canonical(folder);
  for (const Path& input : inputs)
  {
    const Path relative = std::filesystem::weakly_canonical(input).lexically_relative(home);
    if (!input.empty() && !relative.empty() && *relative.begin() != "..")
      throw Error(folder.string(), "the case's own input " + input.string() + " lies in it",
                  "write the case to another folder");
  }
}

json to_json(const Vec3& v)
{
  return {v.x(), v.y(), v.z()};
}

Vec3 vec3_from(const json& value)
{
  return {value.at(0).get<double>(), value.at(1).get<double>(), value.at(2).get<double>()};
}

MeshedFace::MeshedFace(const CaseSession& session, MixedMesh meshed)
    : skin(read_surface(session.folder.require("skin.vtp", "segment"))),
      reference_skin(to_triangle_mesh(skin)), mesh(std::move(meshed)),
      materials(read_materials(session.settings.materials)), tissue(mesh, mixed_elements),
      map(map_skin(mesh, reference_skin.points)), interpolation(tissue, map),
      skin_area(vertex_areas(reference_skin))
{
  for (std::size_t v = 0; v < skin_area.size(); ++v)
    if (interpolation.vertices[v].prism < 0)
      skin_area[v] = 0;
}

LoadedFace::LoadedFace(const CaseSession& session)
    : MeshedFace(session, read_mesh(session.folder.require("mesh.vtu", "mesh")))
{
  const json cut = read_json(session.folder.require("cut.json", "cut"));
  for (const json& fragment : cut.at("fragments"))
    reference_points.push_back(vec3_from(fragment.at("reference_point_ras")));
}

EquilibriumOptions equilibrium_options(const CaseSettings& settings)
{
  EquilibriumOptions options;
  options.max_newton_iterations = settings.max_newton_iterations;
  options.step_tolerance_mm = settings.step_tolerance_mm;
  return options;
}

std::vector<RigidMotion> stated_motions(const Movements& movements, const LoadedFace& face,
                                        const std::string& source)
{
  std::vector<RigidMotion> motions = rest_motions(face.model());
  const auto& names = face.mesh.fragments;
  require_known_fragments(movements, names, source);
  for (const auto& [name, movement] : movements)
  {
    const auto f =
        static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    motions[f] = movement.about(face.reference_points[f]);
  }
  return motions;
}

std::vector<RigidMotion> motions_to_predict(const CaseSession& session, const LoadedFace& face)
{
  if (!session.settings.predict.empty())
    return stated_motions(session.settings.predict, face, "'/predict'");
  if (!session.folder.has("plan.json"))
    throw Error(session.folder.path().string(),
                "it states no movement to predict and has no plan.json",
                "give --movement, or run 'facetobone plan' first");
  std::vector<RigidMotion> motions;
  const json plan = read_json(session.folder.file("plan.json"));
  for (const json& fragment : plan.at("methods").at("rigid-fit").at("fragments"))
    motions.push_back(motion_from(fragment));
  return motions;
}

void write_moved_fragment(const CaseFolder& folder, const std::string& fragment,
                          const RigidMotion& motion, const Path& file)
{
  const auto rest = read_surface(folder.require("fragment_" + file_part(fragment) + ".vtp", "cut"));
  std::vector<Vec3> moved = points_of(rest);
  for (Vec3& p : moved)
    p = motion.apply(p);
  write_surface(file, with_points(rest, moved));
}

vtkSmartPointer<vtkPolyData> displaced_skin(const LoadedFace& face,
                                            const std::vector<Vec3>& displacement)
{
  std::vector<Vec3> points = face.reference_skin.points;
  for (std::size_t v = 0; v < points.size(); ++v)
    points[v] += displacement[v];
  auto surface = with_points(face.skin, points);
  add_point_array(surface, "displacement", displacement);
  return surface;
}

std::vector<Vec3> node_displacements(const MixedMesh& mesh, const std::vector<Vec3>& x)
{
  std::vector<Vec3> u = mesh.X;
  for (std::size_t n = 0; n < u.size(); ++n)
    u[n] = x[n] - u[n];
  return u;
}

namespace
{

/// Why a solve stopped, as the end of a sentence.
const char* reason(Termination termination)
{
  switch (termination)
  {
  case Termination::TissueCollapses:
    return "beyond that it would be crushed or torn inside out";
  case Termination::EquilibriumLost:
    return "beyond that no stable equilibrium was found";
  case Termination::IterationLimit:
    return "beyond that no equilibrium was found within the iterations that one movement is given";
  case Termination::Converged:
    break;
  }
  return "";
}

} // namespace

json to_json(const StabilityReport& stability)
{
  json told;
  for (const Tissue tissue : {Tissue::Skin, Tissue::Fat, Tissue::Muscle})
  {
    const TissueStability& t = stability.of(tissue);
    told[name_of(tissue)] = {{"share_outside", t.share_outside()},
                             {"points", t.points},
                             {"points_outside", t.points_outside},
                             {"worst_margin", t.worst_margin},
                             {"worst_at_ras", to_json(t.worst_place)}};
  }
  return told;
}

nlohmann::json to_json(const EquilibriumSummary& solve)
{
  return {{"converged", solve.converged()},
          {"load_reached", solve.load_reached},
          {"load_steps", solve.load_steps},
          {"newton_iterations", solve.newton_iterations},
          {"factorizations", solve.effort.factorizations},
          {"cg_iterations", solve.effort.cg_iterations}};
}

nlohmann::json time_split(const SolveEffort& effort)
{
  return {{"assembly", effort.assembly},
          {"energy", effort.energy},
          {"analysis", effort.analysis},
          {"factorization", effort.factorization},
          {"back_solving", effort.back_solving},
          {"products", effort.products},
          {"rest", effort.rest()},
          {"total", effort.total}};
}

void require_converged(const EquilibriumSummary& summary, const std::string& what,
                       const std::vector<std::string>& warnings)
{
  if (summary.converged())
    return;
  char problem[200];
  std::snprintf(problem, sizeof problem, "the tissue could follow only %.0f %% of the movement: %s",
                100 * summary.load_reached, reason(summary.termination));
  std::string text = problem;
  for (const std::string& warning : warnings)
    text += "; " + warning;
  throw Error(what, text,
              "state a smaller movement or one that does not run into bone, or release more tissue "
              "along the cuts (mesh.release_margin_mm)",
              ErrorKind::Numerical);
}

} // namespace f2b
