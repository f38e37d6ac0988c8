#pragma once

#include "Core/inverse/face_model.hpp"

/// Which bone cuts reach a target face best, and with which movement?
///
/// To first order about rest: the skin follows the fragments by its sensitivities there, so the
/// movement is a small linear least-squares problem (the paper's future work: cuts from the face).
/// RAS, mm, rad.
namespace f2b
{

/// What cuts made together do to the skin.
struct CutEffect
{
  std::vector<std::string> cuts;          ///< the osteotomies, by the names they are ranked under
  std::vector<std::string> fragments;     ///< that they free, one per cut
  std::vector<Vec3> reference_points;     ///< that movements are told about, one per fragment [mm]
  double bone_volume_mm3 = 0;             ///< of all fragments together
  std::vector<std::vector<Vec3>> columns; ///< six per fragment, turns about R, A, S [mm/rad], then shifts
};

struct CutSuggestionOptions
{
  /// A movement beyond these is not proposed: each fragment's shift and turn are held within.
  double largest_shift_mm = 25;
  double largest_turn_rad = 20 * 3.14159265358979323846 / 180;
  /// Share of the target's mean square that a shift of 10 mm, or a turn of 10 degrees, must win:
  /// what the skin hardly feels is not proposed. It adds share * target^2 * (|shift| / 10 mm)^2 to
  /// what is minimised, and the same for the turn.
  double cost_of_movement = 1e-2;
  /// What one more cut must add to `reached` to be worth it.
  double cost_of_cut = 0.05;
};

/// How near a face comes to its target; weighted by the skin's area and the target's weight.
struct Attainment
{
  double reached = 0;     ///< 1 - rms_left / RMS of the target; below 0: farther than at rest
  double rms_left_mm = 0; ///< of the distance at corresponding vertices
  double under_1mm = 0;   ///< share of the skin left within 1 mm of its target
};
/// Throws Error if the target asks for less than 0.01 mm (RMS): there is nothing to reach.
/// \param skin_displacement  one per reference-skin vertex [mm]
/// \param skin_area          of each; 0 leaves it out [mm^2]
Attainment attained(const std::vector<Vec3>& skin_displacement, const SkinTarget& target,
                    const std::vector<double>& skin_area);

/// How much of the target one set of cuts reaches.
struct CutReach
{
  std::vector<std::string> cuts, fragments;
  double bone_volume_mm3 = 0;
  std::vector<RigidMotion> motions; ///< the best within the limits, one per fragment
  std::vector<char> at_limit;       ///< per fragment: a limit holds it back
  Attainment face;                  ///< to first order; `reached` is in [0, 1]
  double score = 0;                 ///< `reached`, less the cost of every cut after the first
};

/// RMS of the displacement that a target asks for, weighted by area and weight [mm]; 0 where it
/// weighs nothing.
double target_rms_mm(const SkinTarget& target, const std::vector<double>& skin_area);

/// The movement of the fragments that brings the skin nearest to its target. Throws as `attained`.
CutReach reach_of(const CutEffect& effect, const SkinTarget& target,
                  const std::vector<double>& skin_area, const CutSuggestionOptions& options = {});

/// Sorts by score in whole percents, best first: more cuts come first only if they reach
/// `cost_of_cut` more for each. Among equals the fewer cuts, then the smaller fragments, come
/// first.
void rank(std::vector<CutReach>& reaches);

/// Minimises q'Hq/2 - g'q with every three consecutive unknowns inside the unit ball.
/// \param H  symmetric, positive definite; its size a multiple of three
Eigen::VectorXd minimum_in_unit_balls(const Eigen::MatrixXd& H, const Eigen::VectorXd& g);

} // namespace f2b
