#pragma once

#include "Imaging/binary_mask.hpp"
#include "Imaging/whole_bone.hpp"

/// Which part of the head does the operation leave where it is? Positions in mm, RAS.
///
/// A post-operative CT is registered on it. All masks lie on the lattice of the pre-operative
/// WholeBone and hold a shell around bone, not the bone alone: it is the edge of the bone that tells
/// where it is.
namespace f2b
{

struct UnalteredOptions
{
  /// Height above which no jaw reaches: the Frankfort plane with its margin. Default: 95 mm below
  /// the vertex, which the CT must show then.
  std::optional<double> base_level_s;
  double margin_mm = 12; ///< kept away from the fragments: what swells and what was drilled
  double shell_mm = 4;   ///< width of the shell around bone
};

/// The cranium: bone above the jaws and away from the fragments.
/// \param parts  BonePartition::labels of the operation
/// Throws Error if the vertex is needed and not in the CT, or if under 20 ml of bone remain.
BinaryMask unaltered_cranium(const WholeBone& preoperative, const LabelGrid& parts,
                             const UnalteredOptions& options = {});

/// The bone in a given box that is away from the fragments.
/// Throws Error for a box without volume, outside the CT, or that holds under 2 ml of such bone.
BinaryMask unaltered_box(const WholeBone& preoperative, const LabelGrid& parts, const Box& box_ras,
                         const UnalteredOptions& options = {});

/// The bone under a given mask (labels other than 0) that is away from the fragments.
/// Throws Error for a mask that holds under 2 ml of such bone.
BinaryMask unaltered_mask(const WholeBone& preoperative, const LabelGrid& parts,
                          const LabelGrid& mask, const UnalteredOptions& options = {});

} // namespace f2b
