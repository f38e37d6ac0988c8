#include "Bridge/json_file.hpp"
#include "Bridge/markups.hpp"
#include "Bridge/mesh_file.hpp"
#include "Bridge/transform_file.hpp"
#include "Case/cephalometry_case.hpp"
#include "Case/face_regions.hpp"
#include "Case/fragment_json.hpp"
#include "Case/input_records.hpp"
#include "Case/library_versions.hpp"
#include "Case/movement_rules.hpp"
#include "Case/patient_frame_json.hpp"
#include "Case/plan_findings.hpp"
#include "Case/plan_intervals.hpp"
#include "Case/plan_target.hpp"
#include "Case/verbs.hpp"
#include "Case/virtual_force_case.hpp"
#include "Core/error.hpp"
#include "Core/inverse/reachability_words.hpp"
#include "Core/inverse/rigid_fit.hpp"
#include "Core/inverse/skin_error.hpp"
#include "Core/mesh/tissue_stretch.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <sys/resource.h>

namespace f2b
{
namespace
{

using nlohmann::json;

constexpr double degree = 3.14159265358979323846 / 180;

/// Vectors per mesh node, by name [mm].
using NodeArrays = std::vector<std::pair<std::string, std::vector<Vec3>>>;

double peak_memory_mb()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// One run of the verb: the face, its target, and what the two methods find.
class Planning
{
public:
  explicit Planning(CaseSession& session)
      : m_session(session), m_face(session), m_target(session, m_face),
        m_parts(skin_parts(session.folder, m_face)), m_bones(session.folder),
        m_change(session.folder)
  {
    m_pull = virtual_force_options(session);
    // before the first solve, rather than after it
    (void)ContactSurfaces(m_face.mesh, m_face.reference_points, m_pull.landmarks);
  }

  void rigid_fit();
  /// An error of this method is told and does not cost the other's plan.
  void virtual_force();
  void finish(double seconds);

private:
  json errors(const std::vector<Vec3>& skin_displacement) const;
  json errors_in(const std::vector<double>& distance, const std::vector<char>& part) const;
  json fragments(const std::vector<RigidMotion>& motions,
                 const std::vector<BoneMeeting>& meetings) const;
  void move_bones(const std::string& method, const std::vector<RigidMotion>& motions);
  json stretch(const std::vector<Vec3>& x) const;
  json intervals(const RigidFitResult& fit, const RigidFitOptions& options);
  void warn_of_bounds(const RigidFitResult& fit, const RigidFitOptions& options);
  json stability(const std::string& method, const std::vector<Vec3>& x);
  void examine_reach(const RigidFitResult& fit);
  void measure(const RigidFitResult& fit);
  /// \param again  the face predicted with the movement that was found
  void tell_dragged(const VirtualForceResult& dragged, const Prediction& again);
  /// \param node_arrays  to be kept with the displaced mesh
  void write(const std::string& method, const std::vector<RigidMotion>& motions,
             const std::vector<Vec3>& x, const std::vector<Vec3>& skin_displacement,
             NodeArrays node_arrays = {});

  CaseSession& m_session;
  LoadedFace m_face;
  PlanTarget m_target;
  SkinParts m_parts;
  MovedBones m_bones;
  std::vector<double> m_unreachable; ///< of rigid-fit, per reference-skin vertex [mm]
  CaseChange m_change;
  VirtualForceOptions m_pull;
  json m_methods = json::object(), m_failed = json::object();
  json m_seconds = json::object();
  json m_warnings = json::array();
  json m_reachability, m_bite, m_cephalometry;
};

json Planning::errors_in(const std::vector<double>& distance, const std::vector<char>& part) const
{
  std::vector<double> area = m_face.skin_area;
  for (std::size_t v = 0; v < area.size(); ++v)
    if (!part[v])
      area[v] = 0;
  return error_json(skin_error(distance, area));
}

/// Over the whole face, by the bone below it, and by its regions.
json Planning::errors(const std::vector<Vec3>& skin_displacement) const
{
  const std::vector<double> d = m_target.signed_distances(skin_displacement);
  json result = error_json(skin_error(d, m_face.skin_area));
  std::vector<char> part(d.size());
  for (const bool cut : {true, false})
  {
    for (std::size_t v = 0; v < part.size(); ++v)
      part[v] = (m_parts.fragment_below[v] >= 0) == cut;
    result[cut ? "cut" : "outside_cut"] = errors_in(d, part);
  }
  json& by_region = result["by_region"] = json::object();
  for (const FaceRegion region : all_face_regions())
  {
    for (std::size_t v = 0; v < part.size(); ++v)
      part[v] = m_parts.region[v] == region;
    json error = errors_in(d, part);
    if (error.at("area_mm2") > 0)
      by_region[key_of(region)] = std::move(error);
  }
  return result;
}

json Planning::fragments(const std::vector<RigidMotion>& motions,
                         const std::vector<BoneMeeting>& meetings) const
{
  json list = json::array();
  for (std::size_t f = 0; f < motions.size(); ++f)
  {
    const std::string& name = m_face.mesh.fragments[f];
    list.push_back(motion_json(name, motions[f]));
    for (const BoneMeeting& m : meetings)
      if (m.part == name && m.other == uncut_bone_name)
        list.back()["overlap_with_uncut_bone"] = {{"volume_mm3", m.overlap.volume_mm3},
                                                  {"depth_mm", m.overlap.depth_mm}};
  }
  return list;
}

/// What a method's movement does to the bones and the bite.
void Planning::move_bones(const std::string& method, const std::vector<RigidMotion>& motions)
{
  const std::vector<BoneMeeting> meetings = m_bones.meetings(motions);
  m_methods[method]["fragments"] = fragments(motions, meetings);
  m_methods[method]["bone_contacts"] = to_json(meetings);
  for (const std::string& warning : warnings_of(meetings, m_bones.voxel_mm()))
    m_warnings.push_back(method + ": " + warning);
  if (m_bite.is_null())
    m_bite = m_bones.bite_at_rest();
  if (const json after = m_bones.bite_after(motions); !after.is_null())
    m_bite[method] = after;
}

void Planning::examine_reach(const RigidFitResult& fit)
{
  const Reachability reach =
      reachability(m_target.for_vertices(fit.skin_displacement), fit.skin_displacement, m_parts);
  PlannedCuts planned{m_face.mesh.fragments, {}};
  for (const OsteotomySettings& o : m_session.settings.osteotomies)
    planned.templates.push_back(o.template_name);
  m_reachability = to_json(reach, reach_sentences(reach, planned));
  m_unreachable = reach.unreachable_mm;
}

void Planning::measure(const RigidFitResult& fit)
{
  const SkinTarget target = m_target.for_vertices(fit.skin_displacement);
  m_cephalometry =
      cephalometry_json(m_bones.landmarks(), m_bones.moved_landmarks(fit.motions),
                        {m_face.reference_skin.points, target.displacement, fit.skin_displacement});
}

json Planning::stretch(const std::vector<Vec3>& x) const
{
  const TissueStretch s = tissue_stretch(m_face.mesh, x);
  return {{"p99", s.p99}, {"max", s.max}, {"max_at_ras", to_json(s.where)}};
}

json Planning::stability(const std::string& method, const std::vector<Vec3>& x)
{
  const StabilityReport report = examine_stability(m_face.tissue, m_face.materials, x);
  for (const std::string& warning : report.warnings())
    m_warnings.push_back(method + ": " + warning);
  return to_json(report);
}

void Planning::write(const std::string& method, const std::vector<RigidMotion>& motions,
                     const std::vector<Vec3>& x, const std::vector<Vec3>& skin_displacement,
                     NodeArrays node_arrays)
{
  const auto predicted = displaced_skin(m_face, skin_displacement);
  // where the face was not meshed nothing is known
  std::vector<double> distance = m_target.signed_distances(skin_displacement);
  for (std::size_t v = 0; v < distance.size(); ++v)
    if (m_face.skin_area[v] <= 0)
      distance[v] = std::nan("");
  add_point_array(predicted, "signed_distance_mm", distance);
  if (method == "rigid-fit")
    add_point_array(predicted, "unreachable_mm", m_unreachable);
  write_surface(m_change.file("predicted_" + method + ".vtp"), predicted);
  node_arrays.emplace_back("displacement", node_displacements(m_face.mesh, x));
  write_mesh(m_change.file("plan_" + method + ".vtu"), m_face.mesh, node_arrays);
  for (std::size_t f = 0; f < motions.size(); ++f)
  {
    const std::string& fragment = m_face.mesh.fragments[f];
    const std::string name = file_part(fragment) + "_" + method;
    for (const char* kind : {".tfm", ".h5"})
      write_transform(m_change.file(name + kind), motions[f].matrix());
    write_moved_fragment(m_session.folder, fragment, motions[f], m_change.file(name + ".vtp"));
  }
}

const char* text_of(RigidFitTermination termination)
{
  switch (termination)
  {
  case RigidFitTermination::Converged:
    return "converged";
  case RigidFitTermination::NoFurtherDescent:
    return "no further descent";
  case RigidFitTermination::MaxIterations:
    return "iteration limit";
  case RigidFitTermination::EquilibriumLost:
    return "equilibrium lost";
  }
  return "";
}

/// Fragments that were not moved, and coordinates that would go on if their bounds let them.
void Planning::warn_of_bounds(const RigidFitResult& fit, const RigidFitOptions& options)
{
  const MovementSpace space = movement_space(m_face.model(), options);
  for (const int f : fit.held_fragments)
    m_warnings.push_back("rigid-fit: " + stays_unseen(space.names()[static_cast<std::size_t>(f)]));
  for (const Eigen::Index k : fit.at_bounds)
  {
    const MovementSpace::Coordinate& c = space.coordinates()[static_cast<std::size_t>(k)];
    if (std::count(fit.held_fragments.begin(), fit.held_fragments.end(), c.fragment) > 0)
      continue;
    char text[200];
    std::snprintf(text, sizeof text,
                  "rigid-fit: '%s' is held back by its bound of %.4g %s (%s); the target asks for "
                  "more",
                  space.names()[static_cast<std::size_t>(c.fragment)].c_str(),
                  c.is_angle() ? fit.q[k] / degree : fit.q[k], c.is_angle() ? "degrees" : "mm",
                  c.name());
    m_warnings.push_back(text);
  }
}

/// What the plan's coordinates are sure to; a target that leaves some of them free has none.
json Planning::intervals(const RigidFitResult& fit, const RigidFitOptions& options)
{
  m_session.progress("finding how sure the plan is", 0);
  const Stopwatch watch;
  const UncertaintySources sources;
  json result = {{"assumes", to_json(sources)}};
  try
  {
    result["fragments"] =
        intervals_json(movement_space(m_face.model(), options),
                       plan_uncertainty(m_face.model(), m_target.skin(), options, fit,
                                        m_face.reference_skin.points, sources),
                       fit.at_bounds);
  }
  catch (const Error& error)
  {
    m_warnings.push_back(std::string("rigid-fit: no intervals: ") + error.what());
  }
  m_seconds["intervals"] = watch.seconds();
  return result;
}

void Planning::rigid_fit()
{
  const Stopwatch watch;
  RigidFitOptions options;
  options.rules = movement_rules(m_session, m_face.mesh);
  options.max_iterations = m_session.settings.max_fit_iterations;
  options.equilibrium = equilibrium_options(m_session.settings);
  const RigidFitResult fit =
      fit_fragments(m_face.model(), m_target.skin(), options, m_session.progress);
  if (fit.termination == RigidFitTermination::EquilibriumLost)
    throw Error(
        "rigid-fit", "the tissue cannot follow even a small movement towards this target",
        "check the target for skin that crosses bone, or release more tissue along the cuts",
        ErrorKind::Numerical);
  if (fit.termination != RigidFitTermination::Converged)
    m_warnings.push_back(std::string("rigid-fit stopped early (") + text_of(fit.termination) +
                         "): the movement is the best that was found");
  warn_of_bounds(fit, options);
  json iterations = json::array();
  for (const RigidFitIteration& i : fit.iterations)
    iterations.push_back({{"objective", i.objective},
                          {"translation_mm", i.translation_mm},
                          {"rotation_rad", i.rotation_rad}});
  m_methods["rigid-fit"] = {
      {"skin_error_mm", errors(fit.skin_displacement)}, {"tissue_stretch", stretch(fit.x)},
      {"stability", stability("rigid-fit", fit.x)},     {"intervals", intervals(fit, options)},
      {"termination", text_of(fit.termination)},        {"iterations", iterations},
      {"equilibrium", to_json(fit.equilibrium)}};
  if (m_target.skin().registration_sd_mm > 0)
    m_methods["rigid-fit"]["target_registration"] = {
        {"shift_mm", to_json(Vec3(fit.target_registration.head<3>()))},
        {"turn_deg", to_json(Vec3(fit.target_registration.tail<3>() / degree))}};
  move_bones("rigid-fit", fit.motions);
  examine_reach(fit);
  measure(fit);
  write("rigid-fit", fit.motions, fit.x, fit.skin_displacement);
  m_seconds["rigid_fit"] = watch.seconds() - m_seconds["intervals"].get<double>();
}

void Planning::virtual_force()
{
  const Stopwatch watch;
  try
  {
    const VirtualForceResult dragged =
        drag_skin(m_face.model(), m_target.skin(), m_pull, m_session.progress);
    tell_dragged(dragged, predict_face(m_face.model(), dragged.motions, m_pull.equilibrium,
                                       m_session.progress));
  }
  catch (const Error& error)
  {
    m_failed["virtual-force"] = error.what();
    m_warnings.push_back(std::string("virtual-force gives no plan: ") + error.what());
  }
  m_seconds["virtual_force"] = watch.seconds();
}

void Planning::tell_dragged(const VirtualForceResult& dragged, const Prediction& again)
{
  for (const std::string& warning : dragged.warnings(m_pull))
    m_warnings.push_back("virtual-force: " + warning);
  if (!again.summary.converged())
    m_warnings.push_back("virtual-force: the face could be predicted only for " +
                         std::to_string(std::lround(100 * again.summary.load_reached)) +
                         " % of the movement that it found");
  m_methods["virtual-force"] = {{"skin_error_mm", errors(again.skin_displacement)},
                                {"load_residual_mm", errors(dragged.skin_displacement)},
                                {"tissue_stretch", stretch(again.x)},
                                {"stability", stability("virtual-force", again.x)},
                                {"force", force_json(m_pull, dragged)},
                                {"equilibrium", to_json(dragged.equilibrium)},
                                {"prediction", to_json(again.summary)}};
  move_bones("virtual-force", dragged.motions);
  json& told = m_methods["virtual-force"]["fragments"];
  told = with_registrations(told, dragged.registrations);
  // the distance map of Fig. 9, beside the tissue's displacement that it belongs to
  write("virtual-force", dragged.motions, again.x, again.skin_displacement,
        {{"dragged_displacement", node_displacements(m_face.mesh, dragged.x)},
         {"registration_misfit", registration_misfit(m_face.mesh, dragged.motions, dragged.x)}});
}

void Planning::finish(double seconds)
{
  const json mesh = read_json(m_session.folder.require("mesh.json", "mesh"));
  json plan = {{"schema", "facetobone-plan/1"},
               {"name", m_session.settings.name},
               {"frame", "scanner RAS"},
               {"materials", m_face.materials.name},
               {"methods", m_methods},
               {"methods_failed", m_failed},
               {"reachability", m_reachability},
               {"bite", m_bite},
               {"cephalometry", m_cephalometry},
               {"versions", library_versions()},
               {"inputs", plan_inputs(m_session)},
               {"warnings", m_warnings},
               {"disclaimer", "research software, not a medical device"}};
  for (const char* key :
       {"prisms", "tets", "nodes", "dofs", "min_dihedral_deg", "min_prism_scaled_jacobian"})
    plan["mesh"][key] = mesh.at(key);
  json& timing = plan["timing_s"];
  timing = m_seconds;
  double total = seconds;
  for (const char* step : {"segment", "cut", "mesh", "target"})
  {
    timing[step] = read_json(m_session.folder.file(std::string(step) + ".json")).at("seconds");
    total += timing[step].get<double>();
  }
  timing["plan"] = seconds;
  timing["total"] = total;
  plan["peak_rss_mb"] = peak_memory_mb();
  add_patient_frame(plan, m_bones.landmarks());
  write_json(m_change.file("plan.json"), plan);
  m_change.commit("plan");
}

} // namespace

void plan_case(CaseSession& session)
{
  const Stopwatch watch;
  Planning planning(session);
  planning.rigid_fit();
  planning.virtual_force();
  planning.finish(watch.seconds());
  session.progress("planned", 1);
}

} // namespace f2b
