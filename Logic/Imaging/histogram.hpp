#pragma once

#include "Core/geometry/scalar_grid.hpp"

/// Which Hounsfield values part air, soft tissue and bone in this CT?
namespace f2b
{

struct TissuePeaks
{
  double air = -1000;            ///< median of the samples below -500 HU
  double soft_tissue = 40;       ///< most frequent value between -150 and 200 HU
  double soft_tissue_width = 20; ///< half width of that peak at half its height [HU]
};

TissuePeaks tissue_peaks(const ScalarGrid& hu);

/// A quarter of the way from soft tissue to air: above foam, cloth and hair, whose fibres reach
/// about -400 HU in the average over a voxel. Typically -220 HU.
double automatic_skin_threshold(const TissuePeaks& peaks);

/// 160 HU above soft tissue, more in a noisy CT. Low enough for the thin walls of maxilla and
/// orbit.
double automatic_bone_threshold(const TissuePeaks& peaks);

} // namespace f2b
