#include "Case/evaluation.hpp"

#include "Bridge/markups.hpp"
#include "Case/bone_part_surface.hpp"
#include "Case/fragment_json.hpp"
#include "Case/placed_osteotomies.hpp"
#include "Case/shell_of_case.hpp"
#include "Case/target_recipes.hpp"
#include "Case/virtual_force_case.hpp"
#include "Core/error.hpp"
#include "Core/inverse/forward_search.hpp"
#include "Core/inverse/reachability_words.hpp"
#include "Core/mesh/contact.hpp"
#include "Core/mesh/skin_over_bone.hpp"

#include <algorithm>
#include <cmath>

namespace f2b
{
namespace
{

using nlohmann::json;

constexpr const char* chin_template = "genioplasty";

/// A face with cuts, and what is known of its skin.
struct CutFace
{
  const MeshedFace& face;
  SkinParts parts;
  PlannedCuts cuts;
};

/// The case's face on the same mesh, with the chin cut besides.
class FaceWithChin
{
public:
  explicit FaceWithChin(const CaseSession& session)
      : m_inputs(session), m_osteotomies(placed_osteotomies(session.folder)),
        m_face(session,
               mesh_shell(session, m_inputs, session.settings.mesh_density, no_progress).mesh)
  {
    m_osteotomies.push_back(osteotomy_from_template(
        chin_template, "chin",
        read_landmarks(session.folder.require("landmarks.mrk.json", "segment")), 1.0));
    m_partition = cut_bone(m_inputs.bone, m_inputs.closed_bone, m_osteotomies);
    assign_contacts(m_face.mesh, m_partition, session.settings.release_margin_mm);
    for (std::size_t f = 0; f < m_osteotomies.size(); ++f)
    {
      const auto label = static_cast<unsigned char>(BonePartition::first_fragment + f);
      m_face.reference_points.push_back(
          area_centroid(to_triangle_mesh(bone_part_surface(m_inputs.bone, m_partition, label))));
    }
  }

  CutFace cut_face(PlannedCuts cuts) const
  {
    cuts.fragments.push_back("chin");
    cuts.templates.push_back(chin_template);
    return {
        m_face,
        {m_face.skin_area, regions_of_skin(m_face.skin),
         fragments_below(m_inputs.closed_bone, m_partition.labels, m_face.reference_skin.points)},
        std::move(cuts)};
  }

private:
  ShellInputs m_inputs;
  std::vector<Osteotomy> m_osteotomies;
  MeshedFace m_face;
  BonePartition m_partition;
};

PlannedCuts cuts_of(const Evaluation& e)
{
  PlannedCuts cuts{e.face.mesh.fragments, {}};
  for (const OsteotomySettings& o : e.session.settings.osteotomies)
    cuts.templates.push_back(o.template_name);
  return cuts;
}

json errors_of(const CutFace& cut, const std::vector<double>& distance)
{
  json errors = error_json(skin_error(distance, cut.face.skin_area));
  for (const bool inside : {true, false})
  {
    std::vector<double> area = cut.face.skin_area;
    for (std::size_t v = 0; v < area.size(); ++v)
      if ((cut.parts.fragment_below[v] >= 0) != inside)
        area[v] = 0;
    errors[inside ? "cut" : "outside_cut"] = error_json(skin_error(distance, area));
  }
  return errors;
}

/// How much of the chin's target is left, 90th percentile [mm]; nothing without a chin.
json chin_left(const Reachability& reach)
{
  for (const RegionReach& region : reach.regions)
    if (region.region == FaceRegion::Chin)
      return {{"asked_p90_mm", region.asked_p90},
              {"left_p90_mm", region.left_p90},
              {"left_rms_mm", region.left_rms}};
  return {};
}

/// One target with one set of cuts.
class TargetTrial
{
public:
  TargetTrial(const Evaluation& e, const CutFace& cut, const SkinTarget& target)
      : m_e(e), m_cut(cut), m_target(target),
        m_fit(fit_fragments(cut.face.model(), target, e.fit_options(), e.session.progress))
  {
  }

  json told() const;
  void compare_with_search(json& told) const;
  void compare_with_virtual_force(json& told) const;
  MapPanel map(const std::string& title) const;

private:
  std::vector<double> distances(const std::vector<Vec3>& u) const
  {
    return distances_to_target(m_cut.face, u, m_target.displacement);
  }

  const Evaluation& m_e;
  const CutFace& m_cut;
  const SkinTarget& m_target;
  RigidFitResult m_fit;
};

json TargetTrial::told() const
{
  const Reachability reach = reachability(m_target, m_fit.skin_displacement, m_cut.parts);
  json fragments = json::array();
  for (std::size_t f = 0; f < m_fit.motions.size(); ++f)
    fragments.push_back(motion_json(m_cut.face.mesh.fragments[f], m_fit.motions[f]));
  return {
      {"error_mm", errors_of(m_cut, distances(m_fit.skin_displacement))},
      {"weighted_rms_mm", weighted_rms_mm(m_cut.face.model(), m_target, m_fit.skin_displacement)},
      {"fragments", fragments},
      {"sentences", reach_sentences(reach, m_cut.cuts)},
      {"chin", chin_left(reach)},
      {"converged", m_fit.termination == RigidFitTermination::Converged}};
}

void TargetTrial::compare_with_search(json& told) const
{
  ForwardSearchOptions options;
  options.equilibrium = m_e.fit_options().equilibrium;
  options.equilibrium.step_tolerance_mm = std::max(1e-6, options.equilibrium.step_tolerance_mm);
  const Stopwatch watch;
  const ForwardSearchResult best =
      search_by_predictions(m_cut.face.model(), m_target, options, m_e.session.progress);
  told["independent_search"] = {
      {"weighted_rms_mm", best.rms_mm},
      {"rigid_fit_over_it", told.at("weighted_rms_mm").get<double>() / best.rms_mm},
      {"forward_solves", best.predictions},
      {"converged", best.converged},
      {"seconds", watch.seconds()}};
}

void TargetTrial::compare_with_virtual_force(json& told) const
{
  const VirtualForceOptions options = virtual_force_options(m_e.session);
  const FaceModel model = m_cut.face.model();
  const VirtualForceResult dragged = drag_skin(model, m_target, options, m_e.session.progress);
  const Prediction again =
      predict_face(model, dragged.motions, options.equilibrium, m_e.session.progress);
  told["virtual_force"] = {{"error_mm", errors_of(m_cut, distances(again.skin_displacement))},
                           {"load_reached", again.summary.load_reached}};
}

MapPanel TargetTrial::map(const std::string& title) const
{
  const std::vector<double> distance = distances(m_fit.skin_displacement);
  return {skin_with_distance(m_cut.face, m_fit.skin_displacement, distance, m_cut.face.skin_area),
          title, text_of(skin_error(distance, m_cut.face.skin_area))};
}

double peak_of(const std::vector<Vec3>& displacement)
{
  double peak = 0;
  for (const Vec3& d : displacement)
    peak = std::max(peak, d.norm());
  return peak;
}

} // namespace

json reach_targets(const Evaluation& e)
{
  const Landmarks landmarks =
      read_landmarks(e.session.folder.require("landmarks.mrk.json", "segment"));
  const CutFace own{e.face, e.parts, cuts_of(e)};
  json rows = json::array();
  MapPanels maps;
  maps.bar_title = "predicted - target face [mm], negative: behind the target";
  for (const TargetRecipe& recipe : target_recipes())
  {
    SkinTarget target{recipe.displacement(e.face.reference_skin.points, landmarks), {}, {}};
    target.weight.assign(target.displacement.size(), 1.0);
    const TargetTrial trial(e, own, target);
    json row = trial.told();
    row["target"] = recipe.name;
    row["title"] = recipe.title;
    row["peak_mm"] = peak_of(target.displacement);
    trial.compare_with_virtual_force(row);
    if (e.options.check_optimum && !recipe.moves_chin)
      trial.compare_with_search(row);
    maps.panels.push_back(trial.map("Target " + recipe.name));
    if (recipe.moves_chin)
      try
      {
        const FaceWithChin with_chin(e.session);
        const CutFace cut = with_chin.cut_face(own.cuts);
        const TargetTrial again(e, cut, target);
        row["with_genioplasty"] = again.told();
        maps.panels.push_back(again.map("Target " + recipe.name + ", chin cut too"));
      }
      catch (const Error& error)
      {
        row["with_genioplasty"] = {{"not_possible", error.what()}};
      }
    rows.push_back(std::move(row));
  }
  write_png(map_panels_picture(maps, {700, 900}), e.file("experiment3.png"));
  return {{"rows", rows}, {"paper_cut_mm", {{"mean", 0.75}, {"p90", 1.5}}}};
}

} // namespace f2b
