#pragma once

#include <array>
#include <vector>

/// On which edges of an image does a contour come to rest?
///
/// Geodesic active contour (Caselles, Kimmel and Sapiro 1997), by ITK's sparse field: the front is
/// drawn to where the blurred image's gradient is strongest, held smooth by its curvature, and
/// pressed outwards where it started from seeds. Plain arrays, because ITK's headers bring an Eigen of
/// their own.
namespace f2b
{

struct GeodesicContourOptions
{
  double blur_mm = 0.8;     ///< of the image before its gradient is taken
  double curvature = 0.3;   ///< weight of smoothness
  double advection = 2.0;   ///< weight of the pull towards edges
  double propagation = 0.0; ///< pressure outwards; needed by seeds alone
  int iterations = 40;
  double settled = 0.003; ///< stops when the front moves less [voxels, RMS]
};

/// \param size   samples along i, j, k; i fastest
/// \param image  grey values
/// \param start  level function, negative inside
/// \returns      level function of the contour: distance near it, clipped far from it
std::vector<float> geodesic_contour(const std::array<int, 3>& size, double spacing_mm,
                                    const std::vector<float>& image,
                                    const std::vector<float>& start,
                                    const GeodesicContourOptions& options);

/// The image blurred by a Gaussian.
std::vector<float> blurred(const std::array<int, 3>& size, double spacing_mm,
                           const std::vector<float>& image, double sigma_mm);

} // namespace f2b
