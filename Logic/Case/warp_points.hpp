#pragma once

#include "Case/case_settings.hpp"

/// Which points of the face are dragged, and where to?
namespace f2b
{

/// Points in the same order, one pair per label [mm, RAS].
struct WarpPoints
{
  std::vector<Vec3> from, to;
};

/// Reads a target's two point files; throws Error naming the file and the point where a label has
/// no counterpart, or where two points cannot be told apart.
WarpPoints read_warp_points(const TargetSettings& target);

} // namespace f2b
