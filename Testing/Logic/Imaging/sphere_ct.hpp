#pragma once

#include "Imaging/ct_image.hpp"

#include <itkImageRegionIteratorWithIndex.h>

#include <algorithm>
#include <cmath>

namespace f2b::test
{

/// A ball of bone in a ball of soft tissue; the values at the thresholds lie on the radii exactly.
struct SphereCt
{
  double centre_lps[3] = {10.0, -20.0, 30.0};
  double skin_radius = 60.0, bone_radius = 40.0;
  double skin_threshold = -200.0, bone_threshold = 250.0;
  double spacing[3] = {1.0, 1.0, 1.0};
  int size = 136;

  double hu(double radius) const
  {
    const double soft = std::clamp(skin_threshold - 400.0 * (radius - skin_radius), -1000.0, 50.0);
    const double bone = std::clamp(bone_threshold - 300.0 * (radius - bone_radius), 50.0, 1200.0);
    return radius < 0.5 * (skin_radius + bone_radius) ? bone : soft;
  }

  CtImage::Pointer image(const CtImage::DirectionType& direction) const
  {
    auto ct = CtImage::New();
    CtImage::SizeType extent;
    CtImage::PointType origin;
    for (unsigned a = 0; a < 3; ++a)
    {
      extent[a] = static_cast<itk::SizeValueType>(size / spacing[a]);
      origin[a] = centre_lps[a];
      for (unsigned c = 0; c < 3; ++c)
        origin[a] -= direction(a, c) * 0.5 * (size - 1);
    }
    ct->SetRegions(extent);
    ct->SetSpacing(spacing);
    ct->SetOrigin(origin);
    ct->SetDirection(direction);
    ct->Allocate();
    for (itk::ImageRegionIteratorWithIndex<CtImage> it(ct, ct->GetBufferedRegion()); !it.IsAtEnd();
         ++it)
    {
      CtImage::PointType p;
      ct->TransformIndexToPhysicalPoint(it.GetIndex(), p);
      double r2 = 0.0;
      for (unsigned a = 0; a < 3; ++a)
        r2 += (p[a] - centre_lps[a]) * (p[a] - centre_lps[a]);
      it.Set(static_cast<short>(std::lround(hu(std::sqrt(r2)))));
    }
    return ct;
  }

  CtImage::Pointer image() const
  {
    CtImage::DirectionType direction;
    direction.SetIdentity();
    return image(direction);
  }
};

} // namespace f2b::test
