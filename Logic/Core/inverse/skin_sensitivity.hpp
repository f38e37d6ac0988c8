#pragma once

#include "Core/inverse/face_model.hpp"
#include "Core/inverse/movement_space.hpp"

/// How does the face follow a small change of the plan?
namespace f2b
{

/// Velocities of all control vectors on fragments per unit of every coordinate at q [mm].
/// \param x  control vectors at q [mm]
std::vector<std::vector<Vec3>> fragment_velocities(const Discretization& tissue,
                                                   const MovementSpace& space,
                                                   const Eigen::VectorXd& q,
                                                   const std::vector<Vec3>& x);

/// What a target asks of a face, linearised: residuals along rows, one per reference-skin vertex and
/// component (x, y, z; one component only where the target is a surface of its own).
class SkinResidual
{
public:
  /// \param weight  per reference-skin vertex; 0 leaves it out [mm^2]
  SkinResidual(const SkinTarget& target, std::vector<double> weight);

  const std::vector<double>& weight() const { return m_weight; }
  /// 1/2 sum_v w_v |r_v|^2 [mm^4].
  double objective(const std::vector<Vec3>& displacement) const;
  /// What is left to the target, face minus target, one vector per vertex [mm].
  std::vector<Vec3> at(const std::vector<Vec3>& displacement) const;

  /// Gradient and Gauss-Newton matrix of the objective.
  /// \param columns  skin displacement per unit of every coordinate, as at the reference skin
  void normal_equations(const std::vector<Vec3>& displacement,
                        const std::vector<std::vector<Vec3>>& columns, Eigen::MatrixXd& H,
                        Eigen::VectorXd& g) const;
  /// The columns as the target sees them: without what it does not ask for.
  std::vector<std::vector<Vec3>> seen(const std::vector<Vec3>& displacement,
                                      std::vector<std::vector<Vec3>> columns) const;

private:
  /// Which direction counts, per vertex; empty: all.
  std::vector<Vec3> directions(const std::vector<Vec3>& displacement) const;

  const SkinTarget& m_target;
  std::vector<double> m_weight;
};

/// Area times weight of the target per reference-skin vertex, 0 where no finite-element skin is
/// near [mm^2].
std::vector<double> fit_weights(const FaceModel& face, const SkinTarget& target);

/// Skin displacement per unit of every coordinate at an equilibrium, on the reference skin; in mm
/// per mm or rad.
/// \param tolerance  relative, of the solves
std::vector<std::vector<Vec3>> skin_columns(const FaceModel& face, const MovementSpace& space,
                                            const Eigen::VectorXd& q, const std::vector<Vec3>& x,
                                            EquilibriumSolver& solver, double tolerance);

} // namespace f2b
