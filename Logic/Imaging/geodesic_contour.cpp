#include "Imaging/geodesic_contour.hpp"

#include <itkGeodesicActiveContourLevelSetImageFilter.h>
#include <itkGradientMagnitudeRecursiveGaussianImageFilter.h>
#include <itkImage.h>
#include <itkSmoothingRecursiveGaussianImageFilter.h>

#include <algorithm>
#include <cmath>

namespace f2b
{
namespace
{

using Image = itk::Image<float, 3>;

Image::Pointer image_of(const std::array<int, 3>& size, double spacing_mm,
                        const std::vector<float>& values)
{
  auto image = Image::New();
  Image::SizeType extent;
  Image::SpacingType spacing;
  for (unsigned a = 0; a < 3; ++a)
  {
    extent[a] = static_cast<itk::SizeValueType>(size[a]);
    spacing[a] = spacing_mm;
  }
  image->SetRegions(extent);
  image->SetSpacing(spacing);
  image->Allocate();
  std::copy(values.begin(), values.end(), image->GetBufferPointer());
  return image;
}

std::vector<float> values_of(const Image& image)
{
  const float* begin = image.GetBufferPointer();
  return {begin, begin + image.GetBufferedRegion().GetNumberOfPixels()};
}

/// The gradient at which an edge counts half: the median of those under the starting front.
float usual_edge(const std::vector<float>& gradient, const std::vector<float>& start, float reach)
{
  std::vector<float> under;
  for (std::size_t s = 0; s < start.size(); ++s)
    if (std::abs(start[s]) < reach)
      under.push_back(gradient[s]);
  if (under.empty())
    return 1;
  std::nth_element(under.begin(), under.begin() + static_cast<std::ptrdiff_t>(under.size() / 2),
                   under.end());
  return std::max(under[under.size() / 2], 1e-3F);
}

} // namespace

std::vector<float> blurred(const std::array<int, 3>& size, double spacing_mm,
                           const std::vector<float>& image, double sigma_mm)
{
  auto filter = itk::SmoothingRecursiveGaussianImageFilter<Image, Image>::New();
  filter->SetInput(image_of(size, spacing_mm, image));
  filter->SetSigma(sigma_mm);
  filter->Update();
  return values_of(*filter->GetOutput());
}

std::vector<float> geodesic_contour(const std::array<int, 3>& size, double spacing_mm,
                                    const std::vector<float>& image,
                                    const std::vector<float>& start,
                                    const GeodesicContourOptions& options)
{
  auto gradient = itk::GradientMagnitudeRecursiveGaussianImageFilter<Image, Image>::New();
  gradient->SetInput(image_of(size, spacing_mm, image));
  gradient->SetSigma(options.blur_mm);
  gradient->Update();
  std::vector<float> edge = values_of(*gradient->GetOutput());
  const float half = usual_edge(edge, start, static_cast<float>(spacing_mm));
  for (float& e : edge)
    e = 1 / (1 + (e / half) * (e / half));

  // ITK counts the front in voxels
  std::vector<float> front = start;
  for (float& value : front)
    value /= static_cast<float>(spacing_mm);
  auto contour = itk::GeodesicActiveContourLevelSetImageFilter<Image, Image, float>::New();
  contour->SetInput(image_of(size, 1.0, front));
  contour->SetFeatureImage(image_of(size, 1.0, edge));
  contour->SetPropagationScaling(options.propagation);
  contour->SetCurvatureScaling(options.curvature);
  contour->SetAdvectionScaling(options.advection);
  contour->SetDerivativeSigma(0.7);
  contour->SetMaximumRMSError(options.settled);
  contour->SetNumberOfIterations(static_cast<itk::IdentifierType>(options.iterations));
  contour->Update();
  std::vector<float> result = values_of(*contour->GetOutput());
  for (float& value : result)
    value *= static_cast<float>(spacing_mm);
  return result;
}

} // namespace f2b
