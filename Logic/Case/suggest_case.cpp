#include "Bridge/json_file.hpp"
#include "Case/cut_trials.hpp"
#include "Case/fragment_json.hpp"
#include "Case/verbs.hpp"
#include "Core/error.hpp"
#include "Core/geometry/movement_words.hpp"

#include <algorithm>
#include <cmath>

namespace f2b
{
namespace
{

using nlohmann::json;
using Cuts = std::vector<std::string>;

/// Enough to tell cuts from one another: the ranking is the same as at density 1.
constexpr double coarse_density = 0.3;
/// How many of the best are confirmed.
constexpr std::size_t confirmed_count = 2;

std::string text_of(const Cuts& cuts)
{
  std::string text;
  for (const std::string& cut : cuts)
    text += (text.empty() ? "" : " + ") + cut;
  return text;
}

json attainment_json(const Attainment& face)
{
  return {
      {"reached", face.reached}, {"rms_left_mm", face.rms_left_mm}, {"under_1mm", face.under_1mm}};
}

json fragments_json(const std::vector<std::string>& names, const std::vector<RigidMotion>& motions)
{
  json list = json::array();
  for (std::size_t f = 0; f < motions.size(); ++f)
  {
    json fragment = motion_json(names[f], motions[f]);
    const json& angles = fragment.at("rotation_deg");
    fragment["movement"] =
        translation_phrase(motions[f].translation) + "; " +
        rotation_phrase({angles.at("pitch"), angles.at("roll"), angles.at("yaw")});
    list.push_back(std::move(fragment));
  }
  return list;
}

SkinTarget read_target(const CaseFolder& folder, std::size_t vertices)
{
  const auto surface = read_surface(folder.require("target.vtp", "target"));
  SkinTarget target;
  target.displacement = point_vectors(surface, "displacement");
  target.weight = point_scalars(surface, "weight");
  if (target.weight.size() != vertices)
    throw Error("target.vtp", "it does not belong to this reference skin",
                "run 'facetobone target' again");
  return target;
}

/// One run of the verb.
class Suggesting
{
public:
  Suggesting(CaseSession& session, double density)
      : m_session(session), m_density(density), m_trials(session, density, part(0, 0.2)),
        m_target(read_target(session.folder, m_trials.face().skin_area.size()))
  {
    m_target_rms_mm = target_rms_mm(m_target, m_trials.face().skin_area);
  }

  void rank_all();
  void confirm_best();
  void finish();

private:
  /// A progress for a part of this verb.
  Progress part(double begin, double end) const
  {
    return [=, told = m_session.progress](std::string_view what, double fraction)
    { told(what, begin + fraction * (end - begin)); };
  }
  void try_cuts(const Cuts& cuts);
  json confirmed(const CutReach& reach);
  json suggestion(std::size_t rank) const;

  Stopwatch m_watch;
  CaseSession& m_session;
  double m_density;
  CutTrials m_trials;
  SkinTarget m_target;
  double m_target_rms_mm = 0;
  CutSuggestionOptions m_options;
  std::vector<CutReach> m_reaches;
  std::vector<json> m_confirmed; ///< of the first of `m_reaches`
  json m_not_possible = json::array();
  double m_fit_seconds = 0, m_confirm_seconds = 0;
};

void Suggesting::try_cuts(const Cuts& cuts)
{
  try
  {
    const CutEffect effect = m_trials.effect_of(cuts);
    const Stopwatch watch;
    m_reaches.push_back(reach_of(effect, m_target, m_trials.face().skin_area, m_options));
    m_fit_seconds += watch.seconds();
  }
  catch (const Error& error)
  {
    m_not_possible.push_back({{"cuts", cuts}, {"reason", error.what()}});
  }
}

void Suggesting::rank_all()
{
  // asks whether there is anything to reach, before each cut would be told that there is not
  (void)attained(m_target.displacement, m_target, m_trials.face().skin_area);
  // those that move the face as a whole; one-sided cuts are not what a target of both sides asks for
  const std::vector<std::string> names = {"bsso", "genioplasty", "le-fort-1", "le-fort-3"};
  const auto all = static_cast<double>(names.size() * (names.size() + 1) / 2);
  double tried = 0;
  const Progress progress = part(0.2, 0.95);
  auto attempt = [&](const Cuts& cuts)
  {
    progress("trying " + text_of(cuts), tried++ / all);
    try_cuts(cuts);
  };
  for (const std::string& name : names)
    attempt({name});
  std::vector<std::string> possible;
  for (const CutReach& reach : m_reaches)
    possible.push_back(reach.cuts.front());
  for (std::size_t a = 0; a < possible.size(); ++a)
    for (std::size_t b = a + 1; b < possible.size(); ++b)
      attempt({possible[a], possible[b]});
  rank(m_reaches);
}

/// The movement of the full, non-linear fit; or why there is none.
json Suggesting::confirmed(const CutReach& reach)
{
  RigidFitOptions options;
  options.max_iterations = m_session.settings.max_fit_iterations;
  options.equilibrium = equilibrium_options(m_session.settings);
  // a tenth of a percent of a movement is enough to confirm it
  options.translation_tolerance_mm = 1e-3;
  options.rotation_tolerance_rad = 1e-5;
  options.equilibrium.step_tolerance_mm = std::max(1e-5, options.equilibrium.step_tolerance_mm);
  try
  {
    const RigidFitResult fit = m_trials.fit(reach.cuts, m_target, options, part(0.95, 0.99));
    json found =
        attainment_json(attained(fit.skin_displacement, m_target, m_trials.face().skin_area));
    found["fragments"] = fragments_json(reach.fragments, fit.motions);
    found["converged"] = fit.termination == RigidFitTermination::Converged;
    return found;
  }
  catch (const Error& error)
  {
    return {{"reason", error.what()}};
  }
}

void Suggesting::confirm_best()
{
  const Stopwatch watch;
  while (m_confirmed.size() < std::min(confirmed_count, m_reaches.size()))
    m_confirmed.push_back(confirmed(m_reaches[m_confirmed.size()]));
  m_confirm_seconds = watch.seconds();
}

json Suggesting::suggestion(std::size_t rank) const
{
  const CutReach& reach = m_reaches[rank];
  json told = attainment_json(reach.face);
  told["cuts"] = reach.cuts;
  told["score"] = reach.score;
  told["bone_volume_mm3"] = reach.bone_volume_mm3;
  told["fragments"] = fragments_json(reach.fragments, reach.motions);
  for (std::size_t f = 0; f < reach.fragments.size(); ++f)
    told["fragments"][f]["at_limit"] = reach.at_limit[f] != 0;
  if (rank < m_confirmed.size())
    told["confirmed"] = m_confirmed[rank];
  return told;
}

void Suggesting::finish()
{
  json suggestions = json::array();
  for (std::size_t i = 0; i < m_reaches.size(); ++i)
    suggestions.push_back(suggestion(i));
  const MixedMesh& mesh = m_trials.face().mesh;
  const TrialSeconds& trials = m_trials.seconds();
  CaseChange change(m_session.folder);
  write_json(change.file("suggest.json"),
             {{"schema", "facetobone-suggestion/1"},
              {"name", m_session.settings.name},
              {"frame", "scanner RAS"},
              {"target_rms_mm", m_target_rms_mm},
              {"criterion",
               {{"cost_of_cut", m_options.cost_of_cut},
                {"cost_of_movement", m_options.cost_of_movement},
                {"largest_translation_mm", m_options.largest_shift_mm},
                {"largest_rotation_deg", m_options.largest_turn_rad * 180 / M_PI}}},
              {"mesh",
               {{"density", m_density},
                {"prisms", mesh.prisms.size()},
                {"tets", mesh.tets.size()},
                {"nodes", mesh.X.size()}}},
              {"suggestions", suggestions},
              {"not_possible", m_not_possible},
              {"timing_s",
               {{"mesh", trials.mesh},
                {"cut", trials.cut},
                {"contact", trials.contact},
                {"response", trials.response},
                {"fit", m_fit_seconds},
                {"confirm", m_confirm_seconds},
                {"total", m_watch.seconds()}}},
              {"disclaimer", "research software, not a medical device"}});
  change.commit("suggest");
}

} // namespace

void suggest_case(CaseSession& session, const SuggestOptions& options)
{
  session.folder.require("target.vtp", "target"); // before the mesh takes its time
  Suggesting suggesting(
      session, options.density.value_or(std::min(coarse_density, session.settings.mesh_density)));
  suggesting.rank_all();
  if (options.confirm)
    suggesting.confirm_best();
  suggesting.finish();
  session.progress("suggested", 1);
}

} // namespace f2b
