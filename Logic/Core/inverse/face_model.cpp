#include "Core/inverse/face_model.hpp"

namespace f2b
{

std::vector<RigidMotion> rest_motions(const FaceModel& face)
{
  std::vector<RigidMotion> motions(face.reference_points.size());
  for (std::size_t f = 0; f < motions.size(); ++f)
    motions[f].reference_point = face.reference_points[f];
  return motions;
}

Prediction predict_face(const FaceModel& face, const std::vector<RigidMotion>& motions,
                        const EquilibriumOptions& options, const Progress& progress)
{
  progress("predicting the face", 0);
  ElasticModel model(face.tissue, face.materials,
                     held_controls(face.tissue, Held::BoneAndFragments));
  EquilibriumSolver solver(model, options);
  solver.set_progress([&](double share) { progress("predicting the face", share); });
  Prediction prediction;
  prediction.x = face.tissue.rest();
  prediction.summary = solver.move_to(prediction.x, with_fragments_moved(face.tissue, motions));
  prediction.skin_displacement = face.skin.displacement(prediction.x);
  return prediction;
}

} // namespace f2b
