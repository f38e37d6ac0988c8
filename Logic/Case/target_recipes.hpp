#pragma once

#include "Core/geometry/osteotomy_templates.hpp"

/// Which faces does Experiment 3 ask for (Resources/evaluation/targets.json)?
namespace f2b
{

/// A face by where some of its points are to go.
struct TargetRecipe
{
  std::string name, title;
  bool warps_chin = false;
  double radius_mm = 0; ///< of the warp (landmark_warp.hpp)
  /// Landmark, or two as "A|B" for their middle, and its displacement [mm, RAS].
  std::vector<std::pair<std::string, Vec3>> points;

  /// Displacement of every vertex [mm]. A point stands for the vertex that is nearest to it.
  /// Throws Error naming a landmark that is not there.
  std::vector<Vec3> displacement(const std::vector<Vec3>& skin, const Landmarks& landmarks) const;
};

/// Those that the program carries.
std::vector<TargetRecipe> target_recipes();

} // namespace f2b
