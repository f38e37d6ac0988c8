#pragma once

#include "Core/geometry/scalar_grid.hpp"

#include <vector>

/// Which bone lies under the skin?
namespace f2b
{

/// Per skin vertex: the fragment (0, 1, ...) on which its nearest point of the closed bone lies, -1
/// for bone that stays. Frame RAS, mm.
/// \param closed_bone  its signed distance
/// \param parts        BonePartition::labels
std::vector<int> fragments_below(const ScalarGrid& closed_bone, const LabelGrid& parts,
                                 const std::vector<Vec3>& skin);

} // namespace f2b
