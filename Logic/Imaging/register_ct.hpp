#pragma once

#include "Core/geometry/surface_fit.hpp"
#include "Core/progress.hpp"
#include "Imaging/ct_image.hpp"
#include "Imaging/unaltered_region.hpp"

/// How does the head lie in a post-operative CT, by the bone that the operation left alone?
///
/// 1. A start from anywhere: the surface of the unaltered bone is fitted to the post-operative bone
///    (surface_fit.hpp) from 27 turns of up to 20 degrees about each axis and three shifts: none,
///    centres of the bone, tops of the bone.
/// 2. Mutual information of D. Mattes et al., IEEE Trans. Med. Imaging 22 (2003) 120, ITK's v4
///    metric on fixed points of the unaltered region, three resolutions, regular-step descent.
/// 3. The finest resolution again from disturbed starts: do they come back to the same place?
///
/// The same result for any number of threads: the metric is summed in one piece.
namespace f2b
{

struct RegisterCtOptions
{
  std::size_t samples = 30000; ///< points of the region at which the CTs are compared
  int disturbed_starts = 2;    ///< of 1.5 mm and 1.5 degrees
  double spacing_mm = 1;       ///< of the lattices on which they are compared
};

struct CtRegistration
{
  /// From pre-operative to post-operative points [mm, RAS].
  RigidMotion to_postoperative;
  double mutual_information = 0; ///< Mattes, [nat]
  std::size_t samples = 0;
  int iterations = 0;
  double overlap = 0; ///< share of the region that lies in the post-operative CT

  // How sure is it?
  double bone_median_mm = 0;     ///< distance of the unaltered bone's surface to the post-op bone
  double bone_within_1_5_mm = 0; ///< share of that surface
  double spread_mm = 0;          ///< largest, over the unaltered bone, between disturbed starts
  double spread_deg = 0;
  double from_surface_fit_mm = 0; ///< largest difference to the fit of surfaces alone
  double from_surface_fit_deg = 0;
};

/// \param unaltered  on the lattice of `preoperative`; see unaltered_region.hpp
/// Throws Error if under 30 % of the region lie in the post-operative CT, if no turn makes half of
/// the bone's surface meet (another head, or bone that was moved), and (Numerical) if mutual
/// information leads away from the bone or if disturbed starts come to different places.
CtRegistration register_ct(const CtImage& preoperative_ct, const WholeBone& preoperative,
                           const BinaryMask& unaltered, const CtImage& postoperative_ct,
                           const WholeBone& postoperative, const RegisterCtOptions& options = {},
                           const Progress& progress = no_progress);

} // namespace f2b
