#include "Core/inverse/face_model.hpp"

namespace f2b
{

std::vector<char> held_controls(const Discretization& tissue, Held held)
{
  const MixedMesh& mesh = tissue.mesh();
  std::vector<char> flags(mesh.X.size(), 0);
  for (std::size_t n = 0; n < flags.size(); ++n)
  {
    const Boundary part = mesh.node_boundary[n];
    flags[n] = part == Boundary::FixedBone || part == Boundary::Crop ||
               (held == Held::BoneAndFragments && part == Boundary::Fragment);
  }
  return tissue.control_flags(flags);
}

std::vector<Vec3> with_fragments_moved(const Discretization& tissue,
                                       const std::vector<RigidMotion>& motions)
{
  const MixedMesh& mesh = tissue.mesh();
  std::vector<Vec3> x = tissue.rest();
  for (std::size_t n = 0; n < mesh.X.size(); ++n)
    if (mesh.node_boundary[n] == Boundary::Fragment)
      x[n] = motions[static_cast<std::size_t>(mesh.node_fragment[n])].apply(mesh.X[n]);
  return x;
}

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
