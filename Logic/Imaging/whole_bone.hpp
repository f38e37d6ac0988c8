#pragma once

#include "Imaging/ct_image.hpp"
#include "Imaging/lattice.hpp"

#include <optional>
#include <string>

/// Where, roughly, is the bone of a whole CT?
namespace f2b
{

/// Edge of the lattice [mm].
inline constexpr double whole_bone_spacing = 2.0;

struct WholeBone
{
  ScalarGrid hu;   ///< the CT on a lattice of 2 mm over all of it
  ScalarGrid bone; ///< signed distance to everything above the threshold, negative inside [mm]
  double threshold_hu = 0;
};

/// \param threshold_hu  default: as segment_head chooses it
/// \param name          of the CT, for messages
/// Throws Error if the CT holds under 30 ml of bone: it shows no head.
WholeBone find_whole_bone(const CtImage& ct, const std::string& name,
                          std::optional<double> threshold_hu = {});

} // namespace f2b
