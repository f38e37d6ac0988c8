#pragma once

#include "Core/sculpting/brush.hpp"

#include <optional>

/// Which plane is a face nearly its own mirror image in?
namespace f2b
{

struct MirrorPlane
{
  SymmetryPlane plane;     ///< normal to the patient's right
  double asymmetry_mm = 0; ///< of the skin that was matched to its mirror image: mean distance
};

/// A first guess of the mid-sagittal plane, where no landmarks say it: the skin is reflected, laid
/// on itself by trimmed iterative closest points (Chetverikov et al. 2002), and the plane between
/// the two is taken. The part that matches worst, a fifth, does not count: that is where the face is
/// asymmetric or the scan ends. Nothing where no plane within 30 degrees of the scanner's
/// mid-sagittal direction is found.
/// \param skin  in RAS [mm]
/// \param used  the vertices to match, such as those of the face; none: all of them
std::optional<MirrorPlane> mirror_plane(const TriangleMesh& skin, std::vector<int> used = {});

} // namespace f2b
