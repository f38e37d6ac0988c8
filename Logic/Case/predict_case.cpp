#include "Bridge/json_file.hpp"
#include "Bridge/mesh_file.hpp"
#include "Case/verbs.hpp"
#include "Core/error.hpp"
#include "Core/models/face_models.hpp"

#include <algorithm>

namespace f2b
{
namespace
{

using nlohmann::json;

void require_rest(const RelaxationSummary& relaxation, double tolerance)
{
  if (relaxation.converged)
    return;
  char numbers[100];
  std::snprintf(numbers, sizeof numbers, "%d steps (residual %.2g of the reactions, %.2g wanted)",
                relaxation.steps, relaxation.residual, tolerance);
  throw Error("prediction", std::string("the mass-tensor model did not come to rest in ") + numbers,
              "use the model lfem, which has the same state of rest", ErrorKind::Numerical);
}

/// Linear elasticity does not keep elements upright.
long inverted_tets(const MixedMesh& mesh, const std::vector<Vec3>& x)
{
  return std::count_if(mesh.tets.begin(), mesh.tets.end(),
                       [&](const auto& tet)
                       {
                         auto at = [&](std::size_t i) -> const Vec3&
                         { return x[static_cast<std::size_t>(tet[i])]; };
                         return !(tet_volume6(at(0), at(1), at(2), at(3)) > 0);
                       });
}

json told(FaceModelKind model, const FaceModelResult& result, const MixedMesh& mesh)
{
  const EquilibriumSummary& solve = result.equilibrium;
  json document = {{"model", name_of(model)},
                   {"time_s", time_split(solve.effort)},
                   {"inverted_tets", inverted_tets(mesh, result.x)}};
  if (model == FaceModelKind::Mtm)
    document["relaxation"] = {{"steps", result.relaxation.steps},
                              {"residual", result.relaxation.residual},
                              {"largest_eigenvalue", result.relaxation.largest_eigenvalue},
                              {"time_step_s", result.relaxation.time_step}};
  else
    document.update(to_json(solve));
  return document;
}

std::vector<std::string> warnings_of(const FaceModelResult& result)
{
  return result.stability ? result.stability->warnings() : std::vector<std::string>();
}

FaceModelResult predict_or_throw(const CaseSession& session, FaceModelKind model,
                                 const LoadedFace& face, const std::vector<RigidMotion>& motions)
{
  FaceModelOptions options;
  options.equilibrium = equilibrium_options(session.settings);
  FaceModelResult result = predict_with(model, {face.mesh, face.materials, motions}, face.map,
                                        options, session.progress);
  if (model == FaceModelKind::Mtm)
    require_rest(result.relaxation, options.relaxation.tolerance);
  else
    require_converged(result.equilibrium, "prediction", warnings_of(result));
  return result;
}

} // namespace

void predict_case(CaseSession& session)
{
  const Stopwatch watch;
  const LoadedFace face(session);
  const std::vector<RigidMotion> motions = motions_to_predict(session, face);
  const FaceModelKind model = *face_model_named(session.settings.predict_model);
  const FaceModelResult prediction = predict_or_throw(session, model, face, motions);

  CaseChange change(session.folder);
  session.write_settings(change.folder());
  write_surface(change.file("predicted.vtp"), displaced_skin(face, prediction.skin_displacement));
  write_mesh(change.file("predicted.vtu"), face.mesh,
             {{"displacement", node_displacements(face.mesh, prediction.x)}});
  for (std::size_t f = 0; f < motions.size(); ++f)
  {
    const std::string& name = face.mesh.fragments[f];
    write_moved_fragment(session.folder, name, motions[f],
                         change.file(file_part(name) + "_moved.vtp"));
  }
  json document = told(model, prediction, face.mesh);
  document["seconds"] = watch.seconds();
  document["warnings"] = warnings_of(prediction);
  if (prediction.stability)
    document["stability"] = to_json(*prediction.stability);
  write_json(change.file("predict.json"), document);
  change.commit("predict");
  session.progress("predicted", 1);
}

} // namespace f2b
