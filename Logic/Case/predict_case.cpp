#include "Bridge/json_file.hpp"
#include "Bridge/mesh_file.hpp"
#include "Case/verbs.hpp"
#include "Core/error.hpp"

namespace f2b
{
namespace
{

using nlohmann::json;

RigidMotion motion_from(const json& fragment)
{
  RigidMotion motion;
  motion.reference_point = vec3_from(fragment.at("reference_point_ras"));
  const json& t = fragment.at("translation_mm");
  motion.translation = {t.at("right").get<double>(), t.at("anterior").get<double>(),
                        t.at("superior").get<double>()};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c)
      motion.rotation(r, c) =
          fragment.at("matrix_ras").at(static_cast<std::size_t>(4 * r + c)).get<double>();
  return motion;
}

/// The movements that the case states, or the plan's.
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

} // namespace

void predict_case(CaseSession& session)
{
  const Stopwatch watch;
  const LoadedFace face(session);
  const std::vector<RigidMotion> motions = motions_to_predict(session, face);
  const Prediction prediction =
      predict_face(face.model(), motions, equilibrium_options(session.settings), session.progress);
  require_converged(prediction.summary, "prediction");

  CaseChange change(session.folder);
  write_json(change.file(case_settings_name), session.document);
  write_surface(change.file("predicted.vtp"), displaced_skin(face, prediction.skin_displacement));
  write_mesh(change.file("predicted.vtu"), face.mesh,
             {{"displacement", node_displacements(face.mesh, prediction.x)}});
  for (std::size_t f = 0; f < motions.size(); ++f)
  {
    const std::string& name = face.mesh.fragments[f];
    write_moved_fragment(session.folder, name, motions[f],
                         change.file(file_part(name) + "_moved.vtp"));
  }
  write_json(change.file("predict.json"),
             {{"seconds", watch.seconds()},
              {"load_steps", prediction.summary.load_steps},
              {"newton_iterations", prediction.summary.newton_iterations},
              {"factorizations", prediction.summary.effort.factorizations}});
  change.commit("predict");
  session.progress("predicted", 1);
}

} // namespace f2b
