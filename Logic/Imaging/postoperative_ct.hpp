#pragma once

#include "Core/geometry/osteotomy.hpp"
#include "Core/geometry/rigid_motion.hpp"
#include "Imaging/ct_image.hpp"

#include <array>
#include <cstdint>

/// Which CT would be made of a patient after an operation whose outcome is known?
///
/// For tests of everything that reads a post-operative CT. Each voxel takes its Hounsfield value
/// from the place of the pre-operative CT that moved there: bone and the cavities in it by the
/// movement of its part, soft tissue through the inverse of the displacement field, the rest not at
/// all. What is left behind becomes air where the air around the head reaches it, else soft tissue.
namespace f2b
{

/// The patient before, and what was done to him. Positions in mm, RAS. All parts outlive the call.
struct OperatedPatient
{
  const ScalarGrid& hu;                    ///< all of the pre-operative CT
  const ScalarGrid& bone;                  ///< signed distance, negative inside
  const BonePartition& partition;          ///< on the lattice of `bone`
  const std::vector<RigidMotion>& motions; ///< one per fragment
  /// Soft tissue: tetrahedra between nodes at `X` before and `x` after.
  const std::vector<std::array<int, 4>>& tets;
  const std::vector<Vec3>& X;
  const std::vector<Vec3>& x;
};

struct PostoperativeCtOptions
{
  /// Where the patient lies in the second scan: from pre-operative to post-operative points.
  RigidMotion reslice;
  /// Voxel edges along R, A and S [mm], 0.3 to 5.
  Vec3 spacing_mm = Vec3(1, 1, 1);
  double noise_sd_hu = 12;    ///< standard deviation of white Gaussian noise [HU]
  std::uint64_t seed = 2;     ///< of the noise
  double soft_tissue_hu = 40; ///< of what fills the gaps
};

/// The field of view covers all of the resliced pre-operative CT. The image is the same for any
/// number of threads. Throws Error for options out of range or motions that are not one per
/// fragment.
CtImage::Pointer synthesize_postoperative_ct(const OperatedPatient& patient,
                                             const PostoperativeCtOptions& options = {});

} // namespace f2b
