#pragma once

#include "Core/geometry/rigid_motion.hpp"
#include "Imaging/ct_image.hpp"
#include "Imaging/lattice.hpp"

#include <memory>

/// How much does one CT tell of the other where a rigid motion lays them over each other?
namespace f2b
{

/// The mutual information of two CTs at fixed points, by ITK's v4 metric after Mattes et al. (IEEE
/// Trans. Med. Imaging 22 (2003) 120), and where it is greatest.
class MutualInformation
{
public:
  struct Options
  {
    double spacing_mm = 1; ///< of the lattices that the CTs are brought to
    int bins = 50;         ///< of the histogram, over -1000 to 2000 HU
  };

  /// \param points  of the fixed CT, where the two are compared [mm, RAS]
  MutualInformation(const CtImage& fixed, const CtImage& moving, std::vector<Vec3> points,
                    const Options& options);
  ~MutualInformation();

  struct Maximum
  {
    RigidMotion motion; ///< of points of the fixed CT to those of the moving one
    double value = 0;   ///< [nat]
    int iterations = 0;
    bool converged = false; ///< else the iterations ran out
  };

  /// Climbs from a motion, both CTs smoothed.
  /// \param sigma_mm  of the smoothing
  /// \param precision_mm  steps smaller than this are not made
  /// Throws Error (Numerical) where the CTs lose each other.
  Maximum climb(const RigidMotion& start, double sigma_mm, double precision_mm) const;

private:
  struct Images;
  std::unique_ptr<Images> m_images;
  std::vector<Vec3> m_points;
  int m_bins;
};

} // namespace f2b
