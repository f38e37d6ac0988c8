#pragma once

#include "Core/geometry/scalar_grid.hpp"

#include <vector>

/// Which part of the face does a skin vertex belong to?
namespace f2b
{

struct FaceRegions
{
  /// Per vertex: the nearest point on the closed bone lies on a cut fragment.
  std::vector<char> over_fragment;
};

/// \param closed_bone  its signed distance
/// \param parts        BonePartition::labels
FaceRegions face_regions(const ScalarGrid& closed_bone, const LabelGrid& parts,
                         const std::vector<Vec3>& reference_skin);

} // namespace f2b
