#pragma once

#include "Core/geometry/vectors.hpp"

/// How far is one face from another?
namespace f2b
{

/// Area-weighted statistics of distances at corresponding reference-skin vertices [mm].
struct SkinError
{
  double mean = 0, sd = 0, variance = 0; ///< of the absolute distance
  double median = 0, p90 = 0, p95 = 0, max = 0;
  double under_1mm = 0, under_2mm = 0; ///< shares of the area, in [0, 1]
  double signed_mean = 0;              ///< negative: predicted lies behind the target
  double area_mm2 = 0;                 ///< of the skin that counts
};

/// Distance at every vertex, negative where the predicted skin lies behind the target's [mm].
/// \param outward  the target's outward unit normals
std::vector<double> signed_distances(const std::vector<Vec3>& predicted,
                                     const std::vector<Vec3>& target,
                                     const std::vector<Vec3>& outward);

/// \param signed_distance  one per vertex [mm]
/// \param area             weight of each vertex [mm^2]; 0 leaves it out
SkinError skin_error(const std::vector<double>& signed_distance, const std::vector<double>& area);

/// Outward unit normals per vertex, weighted by the faces' areas; zero where no face has area.
std::vector<Vec3> vertex_normals(const TriangleMesh& mesh);
/// A third of the area of the faces around each vertex [mm^2].
std::vector<double> vertex_areas(const TriangleMesh& mesh);

} // namespace f2b
