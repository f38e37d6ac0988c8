#pragma once

#include "Core/assembly/elastic_model.hpp"
#include "Core/models/forward_problem.hpp"
#include "Core/progress.hpp"
#include "Core/solve/equilibrium.hpp"

/// What do the forward and the inverse problem share?
namespace f2b
{

/// The face that is planned. All parts outlive the solves that use it.
struct FaceModel
{
  const Discretization& tissue;
  const MaterialSet& materials;
  const SkinInterpolation& skin;
  std::vector<double> skin_area; ///< per reference-skin vertex, 0 where it does not count [mm^2]
  std::vector<Vec3> reference_points; ///< per fragment, that its movement is told about [mm]
};

/// What the face should become: a displacement and a weight per reference-skin vertex.
struct SkinTarget
{
  std::vector<Vec3> displacement; ///< [mm]
  std::vector<double> weight;     ///< >= 0; 0: the face may do there as it likes
};

/// Rest motions, one per fragment, about the model's reference points.
std::vector<RigidMotion> rest_motions(const FaceModel& face);

/// The face that a movement of the fragments gives.
struct Prediction
{
  std::vector<Vec3> x;                 ///< control vectors, the mesh nodes first [mm]
  std::vector<Vec3> skin_displacement; ///< of the reference skin [mm]
  EquilibriumSummary summary;
};

/// Solves the forward problem (paper Experiment 3, step 2). Where the load cannot be reached, the
/// summary says so and the fields hold the last accepted state.
Prediction predict_face(const FaceModel& face, const std::vector<RigidMotion>& motions,
                        const EquilibriumOptions& options, const Progress& progress);

} // namespace f2b
