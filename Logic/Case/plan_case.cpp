#include "Bridge/json_file.hpp"
#include "Bridge/mesh_file.hpp"
#include "Bridge/transform_file.hpp"
#include "Case/face_regions.hpp"
#include "Case/plan_findings.hpp"
#include "Case/verbs.hpp"
#include "Core/error.hpp"
#include "Core/inverse/rigid_fit.hpp"
#include "Core/inverse/skin_error.hpp"
#include "Core/inverse/virtual_force.hpp"
#include "Core/mesh/tissue_stretch.hpp"

#include <cmath>
#include <cstdio>

#include <sys/resource.h>

namespace f2b
{
namespace
{

using nlohmann::json;

constexpr double degree = 3.14159265358979323846 / 180;

double peak_memory_mb()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

json error_json(const SkinError& e)
{
  return {{"mean", e.mean},
          {"sd", e.sd},
          {"variance", e.variance},
          {"median", e.median},
          {"p90", e.p90},
          {"p95", e.p95},
          {"max", e.max},
          {"under_1mm", e.under_1mm},
          {"under_2mm", e.under_2mm},
          {"signed_mean", e.signed_mean},
          {"area_mm2", e.area_mm2}};
}

json motion_json(const std::string& name, const RigidMotion& motion)
{
  const EulerAngles angles = euler_angles(motion.rotation);
  const Mat4 m = motion.matrix();
  json matrix = json::array();
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c)
      matrix.push_back(m(r, c));
  const Vec3& t = motion.translation;
  return {{"name", name},
          {"matrix_ras", matrix},
          {"reference_point_ras", to_json(motion.reference_point)},
          {"translation_mm", {{"right", t.x()}, {"anterior", t.y()}, {"superior", t.z()}}},
          {"rotation_deg",
           {{"pitch", angles.pitch / degree},
            {"roll", angles.roll / degree},
            {"yaw", angles.yaw / degree}}}};
}

/// One run of the verb: the face, its target, and what the two methods find.
class Planning
{
public:
  explicit Planning(CaseSession& session)
      : m_session(session), m_face(session), m_parts(skin_parts(session.folder, m_face)),
        m_bones(session.folder), m_change(session.folder)
  {
    const auto surface = read_surface(session.folder.require("target.vtp", "target"));
    m_target.displacement = point_vectors(surface, "displacement");
    m_target.weight = point_scalars(surface, "weight");
    if (m_target.weight.size() != m_face.skin_area.size())
      throw Error("target.vtp", "it does not belong to this reference skin",
                  "run 'facetobone target' again");
    const TriangleMesh target = to_triangle_mesh(surface);
    m_target_points = target.points;
    m_target_normals = vertex_normals(target);
    require_overlap();
  }

  void rigid_fit();
  void virtual_force();
  void finish(double seconds);

private:
  void require_overlap() const;
  json errors(const std::vector<Vec3>& skin_displacement) const;
  json errors_in(const std::vector<double>& distance, const std::vector<char>& part) const;
  json fragments(const std::vector<RigidMotion>& motions,
                 const std::vector<BoneMeeting>& meetings) const;
  void move_bones(const std::string& method, const std::vector<RigidMotion>& motions);
  json stretch(const std::vector<Vec3>& x) const;
  json stability(const std::string& method, const std::vector<Vec3>& x);
  void examine_reach(const RigidFitResult& fit);
  void write(const std::string& method, const std::vector<RigidMotion>& motions,
             const std::vector<Vec3>& x, const std::vector<Vec3>& skin_displacement);
  std::vector<double> distances(const std::vector<Vec3>& skin_displacement) const;

  CaseSession& m_session;
  LoadedFace m_face;
  SkinTarget m_target;
  std::vector<Vec3> m_target_points, m_target_normals;
  SkinParts m_parts;
  MovedBones m_bones;
  std::vector<double> m_unreachable; ///< of rigid-fit, per reference-skin vertex [mm]
  CaseChange m_change;
  json m_methods = json::object();
  json m_seconds = json::object();
  json m_warnings = json::array();
  json m_reachability, m_bite;
};

void Planning::require_overlap() const
{
  for (std::size_t v = 0; v < m_target.weight.size(); ++v)
    if (m_target.weight[v] > 0 && m_face.skin_area[v] > 0)
      return;
  throw Error("target", "no weighted part of it lies on the meshed face",
              "widen the target's mask (target.mask_mm) or the region of interest");
}

std::vector<double> Planning::distances(const std::vector<Vec3>& skin_displacement) const
{
  std::vector<Vec3> predicted = m_face.reference_skin.points;
  for (std::size_t v = 0; v < predicted.size(); ++v)
    predicted[v] += skin_displacement[v];
  return signed_distances(predicted, m_target_points, m_target_normals);
}

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
  const std::vector<double> d = distances(skin_displacement);
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
  const Reachability reach = reachability(m_target, fit.skin_displacement, m_parts);
  PlannedCuts planned{m_face.mesh.fragments, {}};
  for (const OsteotomySettings& o : m_session.settings.osteotomies)
    planned.templates.push_back(o.template_name);
  m_reachability = to_json(reach, reach_sentences(reach, planned));
  m_unreachable = reach.unreachable_mm;
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
                     const std::vector<Vec3>& x, const std::vector<Vec3>& skin_displacement)
{
  const auto predicted = displaced_skin(m_face, skin_displacement);
  // where the face was not meshed nothing is known
  std::vector<double> distance = distances(skin_displacement);
  for (std::size_t v = 0; v < distance.size(); ++v)
    if (m_face.skin_area[v] <= 0)
      distance[v] = std::nan("");
  add_point_array(predicted, "signed_distance_mm", distance);
  if (method == "rigid-fit")
    add_point_array(predicted, "unreachable_mm", m_unreachable);
  write_surface(m_change.file("predicted_" + method + ".vtp"), predicted);
  write_mesh(m_change.file("plan_" + method + ".vtu"), m_face.mesh,
             {{"displacement", node_displacements(m_face.mesh, x)}});
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

void Planning::rigid_fit()
{
  const Stopwatch watch;
  RigidFitOptions options;
  options.max_iterations = m_session.settings.max_fit_iterations;
  options.equilibrium = equilibrium_options(m_session.settings);
  const RigidFitResult fit = fit_fragments(m_face.model(), m_target, options, m_session.progress);
  if (fit.termination == RigidFitTermination::EquilibriumLost)
    throw Error(
        "rigid-fit", "the tissue cannot follow even a small movement towards this target",
        "check the target for skin that crosses bone, or release more tissue along the cuts",
        ErrorKind::Numerical);
  if (fit.termination != RigidFitTermination::Converged)
    m_warnings.push_back(std::string("rigid-fit stopped early (") + text_of(fit.termination) +
                         "): the movement is the best that was found");
  json iterations = json::array();
  for (const RigidFitIteration& i : fit.iterations)
    iterations.push_back({{"objective", i.objective},
                          {"translation_mm", i.translation_mm},
                          {"rotation_rad", i.rotation_rad}});
  m_methods["rigid-fit"] = {{"skin_error_mm", errors(fit.skin_displacement)},
                            {"tissue_stretch", stretch(fit.x)},
                            {"stability", stability("rigid-fit", fit.x)},
                            {"termination", text_of(fit.termination)},
                            {"iterations", iterations},
                            {"equilibrium", to_json(fit.equilibrium)}};
  move_bones("rigid-fit", fit.motions);
  examine_reach(fit);
  write("rigid-fit", fit.motions, fit.x, fit.skin_displacement);
  m_seconds["rigid_fit"] = watch.seconds();
}

void Planning::virtual_force()
{
  const Stopwatch watch;
  VirtualForceOptions options;
  options.stiffness_n_per_mm3 = m_session.settings.virtual_force_stiffness;
  options.equilibrium = equilibrium_options(m_session.settings);
  const VirtualForceResult dragged =
      drag_skin(m_face.model(), m_target, options, m_session.progress);
  if (dragged.equilibrium.load_reached < 1)
    m_warnings.push_back("virtual-force: the skin could be pulled only " +
                         std::to_string(std::lround(100 * dragged.equilibrium.load_reached)) +
                         " % of the way to the target");
  const Prediction again =
      predict_face(m_face.model(), dragged.motions, options.equilibrium, m_session.progress);
  if (!again.summary.converged())
    m_warnings.push_back("virtual-force: the face could be predicted only for " +
                         std::to_string(std::lround(100 * again.summary.load_reached)) +
                         " % of the movement that it found");
  m_methods["virtual-force"] = {{"skin_error_mm", errors(again.skin_displacement)},
                                {"load_residual_mm", errors(dragged.skin_displacement)},
                                {"tissue_stretch", stretch(again.x)},
                                {"stability", stability("virtual-force", again.x)},
                                {"stiffness_n_per_mm3", options.stiffness_n_per_mm3},
                                {"equilibrium", to_json(dragged.equilibrium)},
                                {"prediction", to_json(again.summary)}};
  move_bones("virtual-force", dragged.motions);
  write("virtual-force", dragged.motions, again.x, again.skin_displacement);
  m_seconds["virtual_force"] = watch.seconds();
}

void Planning::finish(double seconds)
{
  const json mesh = read_json(m_session.folder.require("mesh.json", "mesh"));
  json plan = {{"schema", "facetobone-plan/1"},
               {"name", m_session.settings.name},
               {"frame", "scanner RAS"},
               {"materials", m_face.materials.name},
               {"methods", m_methods},
               {"reachability", m_reachability},
               {"bite", m_bite},
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
