#pragma once

#include "Core/geometry/scalar_grid.hpp"

#include <functional>

/// Which points lie on the surface of a sampled signed distance?
namespace f2b
{

/// A point of a surface [mm, RAS] and the outward unit normal there.
struct SurfaceSample
{
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
};

/// Where the grid's edges cross the zero level, in the grid's order; about two for each voxel face
/// of the surface.
/// \param distance  negative inside
/// \param counts    points for which it does not hold are left out
/// \param at_most   evenly thinned to about this number; the same ones every time
std::vector<SurfaceSample> surface_points(const ScalarGrid& distance,
                                         const std::function<bool(const Vec3&)>& counts,
                                         std::size_t at_most);

} // namespace f2b
