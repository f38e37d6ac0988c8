#pragma once

#include "Core/inverse/rigid_fit.hpp"

/// How do bones and face follow while the surgeon sculpts the target?
namespace f2b
{

/// The fit linearised about one equilibrium: a target in, a plan and a predicted face out, in
/// milliseconds.
///
/// The face is u(q) = u0 + C (q - q0) to first order; the plan is the minimum of the fit's objective
/// with it, within the same bounds. The movements themselves are exact for their coordinates.
class LiveOperator
{
public:
  struct Answer
  {
    Eigen::VectorXd q;
    std::vector<RigidMotion> motions;    ///< one per fragment
    std::vector<Vec3> skin_displacement; ///< of the reference skin [mm]
    /// How far the predicted face may be off, because it is linearised: the root mean square over
    /// the skin that counts, grown with the square of the distance from the linearisation [mm].
    double doubt_mm = 0;
    std::vector<int> held_fragments; ///< of which the target says nothing: see unseen_fragments
  };

  /// Linearises about the plan of a full fit: one factorisation. Another equilibrium, that at rest or
  /// if the plan is at rest a probe of 3 mm, shows how fast the linearisation goes wrong.
  /// \param face  parts outlive the operator
  LiveOperator(const FaceModel& face, const RigidFitOptions& options, const RigidFitResult& plan,
               const Progress& progress);
  /// Linearises about the face at rest.
  LiveOperator(const FaceModel& face, const RigidFitOptions& options, const Progress& progress);

  /// Sets what of the face counts, a weight per reference-skin vertex as in SkinTarget.
  /// Throws Error if the skin that counts leaves a combination of the coordinates free; the weights
  /// are as they were then.
  void set_weight(const std::vector<double>& weight);
  /// \param displacement  of the target, one per reference-skin vertex [mm]
  Answer update(const std::vector<Vec3>& displacement) const;

  const MovementSpace& space() const { return m_space; }

private:
  void linearize(const Progress& progress);
  Eigen::VectorXd skin_at(const Eigen::VectorXd& q) const;
  double length_mm(const Eigen::VectorXd& change) const;
  /// What of the face counts, and what follows from that.
  struct Weighting
  {
    std::vector<double> weight;         ///< area times weight, one per vertex [mm^2]
    std::vector<Eigen::Index> counting; ///< vertices whose weight is not 0
    std::vector<int> held_fragments;
    Eigen::MatrixXd H;
    double curvature = 0; ///< error of the linearised face per squared distance [1/mm]
  };
  Eigen::MatrixXd normal_matrix(const std::vector<Eigen::Index>& counting,
                                const std::vector<double>& weight) const;
  bool is_held(const Weighting& now, Eigen::Index k) const;

  const FaceModel& m_face;
  RigidFitOptions m_options;
  MovementSpace m_space;
  Eigen::VectorXd m_q0, m_probe_q;
  std::vector<Vec3> m_x;
  Eigen::VectorXd m_u0;       ///< skin displacement at q0, three per vertex [mm]
  std::vector<double> m_area; ///< one per vertex, 0 where none is meshed [mm^2]
  /// Skin displacement per unit of each coordinate; a vertex's three rows lie together.
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> m_C;
  Eigen::VectorXd m_probe_error; ///< of the linearised face at the probe, squared [mm^2]
  Eigen::VectorXd m_moved_skin;  ///< by every coordinate, of all skin
  Weighting m_now;
};

} // namespace f2b
