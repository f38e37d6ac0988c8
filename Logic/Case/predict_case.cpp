#include "Bridge/json_file.hpp"
#include "Bridge/mesh_file.hpp"
#include "Case/verbs.hpp"
#include "Core/error.hpp"

namespace f2b
{
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
