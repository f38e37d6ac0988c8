#pragma once

#include "Core/assembly/elastic_model.hpp"
#include "Core/models/forward_problem.hpp"
#include "Core/progress.hpp"
#include "Core/solve/equilibrium.hpp"

#include <functional>

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

/// Where a target surface is nearest to a vertex of the reference skin.
struct NearestTarget
{
  Vec3 displacement; ///< that takes the vertex there from rest [mm]
  Vec3 normal;       ///< of the surface there, unit
};

/// What the face should become: a displacement and a weight per reference-skin vertex.
struct SkinTarget
{
  std::vector<Vec3> displacement; ///< [mm]
  std::vector<double> weight;     ///< >= 0; 0: the face may do there as it likes
  /// Of a surface whose points belong to no vertex, as a face scan: where it is nearest to a vertex
  /// that is displaced. Only the distance to it counts then, and `displacement` is its value at
  /// rest. Empty: vertices have their own targets. Is called from several threads.
  std::function<NearestTarget(std::size_t vertex, const Vec3& displacement)> nearest;
  /// How far the registration that brought the whole target into the case's frame may have shifted
  /// it: likely error of each component [mm], and of a turn the same on a lever of 60 mm. A fit then
  /// finds shift and turn together with the movement: skin that no bone moves tells them. 0: the
  /// target is where it should be, as one that was drawn on the face.
  double registration_sd_mm = 0;
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
