#pragma once

#include "Core/geometry/osteotomy_templates.hpp"

/// Which faces does Experiment 3 ask for (Resources/evaluation/targets.json)?
namespace f2b
{

/// A stroke of a wide brush over the face: the skin along its path moves as told at the path's
/// points, evenly up to `full_mm` from the path and not at all beyond `reach_mm`.
struct BrushStroke
{
  struct PathPoint
  {
    std::string place; ///< landmark, or the mean of some as "A|B|B"; the nearest vertex is meant
    Vec3 shift;        ///< [mm, RAS]
  };
  std::vector<PathPoint> path;
  double full_mm = 0, reach_mm = 0;
};

/// A face by the strokes that make it of the reference face.
struct TargetRecipe
{
  std::string name, title;
  bool moves_chin = false;
  std::vector<BrushStroke> strokes;

  /// Displacement of every vertex [mm]; strokes that overlap blend and do not add up.
  /// Throws Error naming a landmark that is not there.
  std::vector<Vec3> displacement(const std::vector<Vec3>& skin, const Landmarks& landmarks) const;
};

/// Those that the program carries.
std::vector<TargetRecipe> target_recipes();

} // namespace f2b
