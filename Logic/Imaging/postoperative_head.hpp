#pragma once

#include "Imaging/register_ct.hpp"
#include "Imaging/segment_head.hpp"

/// Where are skin and bone of a post-operative CT, seen in the frame of the pre-operative one?
namespace f2b
{

struct PostoperativeHead
{
  CtRegistration registration;
  HeadSegmentation
      head; ///< in the frame of the pre-operative CT; its voxels were moved, not blurred
};

/// Registers the post-operative CT and segments it.
/// \param unaltered  on the lattice of `preoperative`
/// \param segment    region_ras in the pre-operative frame
/// Throws what register_ct and segment_head throw.
PostoperativeHead
find_postoperative_head(const CtImage& preoperative_ct, const WholeBone& preoperative,
                        const BinaryMask& unaltered, const CtImage& postoperative_ct,
                        const SegmentOptions& segment, const RegisterCtOptions& options = {},
                        const Progress& progress = no_progress);

} // namespace f2b
