#pragma once

#include "Core/geometry/vectors.hpp"
#include "Imaging/geodesic_contour.hpp"

/// What can be said to the level set that finds bone?
namespace f2b
{

struct LevelSetBoneOptions
{
  GeodesicContourOptions contour;
  std::vector<Vec3> seeds_ras; ///< in bone that is to be found: balls to start from besides
  double seed_radius_mm = 2.5;
};

} // namespace f2b
