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
///
/// Where the target's registration is in doubt, its shift and turn are eliminated: for every face
/// they are those that lower the objective most (variable projection: G. Golub, V. Pereyra, SIAM J.
/// Numer. Anal. 10 (1973) 413; the residual is linear in them, so this is exact).
class SkinResidual
{
public:
  using Vec6 = Eigen::Matrix<double, 6, 1>;

  /// \param weight  per reference-skin vertex; 0 leaves it out [mm^2]
  SkinResidual(const SkinTarget& target, std::vector<double> weight);
  /// \param positions    of the reference skin at rest [mm]
  /// \param wish_weight  what one squared standard deviation of a prior counts [mm^4]
  void doubt_registration(std::vector<Vec3> positions, double wish_weight);

  const std::vector<double>& weight() const { return m_weight; }
  /// 1/2 sum_v w_v |r_v|^2 [mm^4], with what the registration's prior costs.
  double objective(const std::vector<Vec3>& displacement) const;
  /// What is left to the target, face minus target, one vector per vertex [mm].
  std::vector<Vec3> at(const std::vector<Vec3>& displacement) const;

  /// Gradient and Gauss-Newton matrix of the objective.
  /// \param columns  skin displacement per unit of every coordinate, as at the reference skin
  void normal_equations(const std::vector<Vec3>& displacement,
                        const std::vector<std::vector<Vec3>>& columns, Eigen::MatrixXd& H,
                        Eigen::VectorXd& g) const;
  /// The columns as the target sees them: without what it does not ask for, and what its
  /// registration explains. The gradient is sum_v w_v c_v . r_v with these.
  std::vector<std::vector<Vec3>> seen(const std::vector<Vec3>& displacement,
                                      std::vector<std::vector<Vec3>> columns) const;
  /// The target's shift [mm], and turn [rad] about the middle of what counts, that fit a face best;
  /// zero where they are not in doubt.
  Vec6 registration(const std::vector<Vec3>& displacement) const;

private:
  std::vector<std::vector<Vec3>> along_directions(const std::vector<Vec3>& direction,
                                                  std::vector<std::vector<Vec3>> columns) const;
  /// A field without its part that a shift and turn explain.
  std::vector<Vec3> less_registration(const std::vector<std::vector<Vec3>>& rigid,
                                      std::vector<Vec3> field) const;
  Vec6 explained(const std::vector<std::vector<Vec3>>& rigid, const std::vector<Vec3>& field) const;
  /// Which direction counts, per vertex; empty: all.
  std::vector<Vec3> directions(const std::vector<Vec3>& displacement) const;

  const SkinTarget& m_target;
  std::vector<double> m_weight;
  std::vector<std::vector<Vec3>> m_rigid; ///< what shifts and turns of the target do; may be empty
  Vec6 m_prior = Vec6::Zero();            ///< their weights
};

/// Of a target with all that it says; as the fit and what propagates through it see it.
/// \param wish_weight  as above
SkinResidual skin_residual(const FaceModel& face, const SkinTarget& target, double wish_weight);

/// Area times weight of the target per reference-skin vertex, 0 where no finite-element skin is
/// near [mm^2].
std::vector<double> fit_weights(const FaceModel& face, const SkinTarget& target);

/// How much skin every coordinate moves: the integral of its column's squared length over the skin
/// that counts.
/// \param weight  per reference-skin vertex [mm^2]
Eigen::VectorXd moved_skin(const std::vector<std::vector<Vec3>>& columns,
                           const std::vector<double>& weight);

/// Fragments that a target says nothing of: of the skin that they move a share counts that is less
/// than a tenth of the best seen fragment's share. What little they do to the skin that counts would
/// drive them to their bounds. Fragments that a prior or a bite speaks for are none of these.
/// \param counting, all  moved_skin of the skin that counts, and of all skin that is meshed
std::vector<int> unseen_fragments(const MovementSpace& space, const Eigen::VectorXd& q,
                                  const Eigen::VectorXd& counting, const Eigen::VectorXd& all);

/// Skin displacement per unit of every coordinate at an equilibrium, on the reference skin; in mm
/// per mm or rad.
/// \param tolerance  relative, of the solves
std::vector<std::vector<Vec3>> skin_columns(const FaceModel& face, const MovementSpace& space,
                                            const Eigen::VectorXd& q, const std::vector<Vec3>& x,
                                            EquilibriumSolver& solver, double tolerance);

} // namespace f2b
