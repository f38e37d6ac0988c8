// The system's Eigen before ITK's headers, which bring another version of it.
#include <Eigen/Dense>

#include "Imaging/mutual_information.hpp"

#include "Core/error.hpp"
#include "Imaging/resample_ct.hpp"

#include <itkEuler3DTransform.h>
#include <itkImageMaskSpatialObject.h>
#include <itkMattesMutualInformationImageToImageMetricv4.h>
#include <itkSmoothingRecursiveGaussianImageFilter.h>

#include <algorithm>
#include <cmath>

namespace f2b
{
namespace
{

/// Of values on a lattice of the RAS frame: ITK does not mind which frame its points are in, as
/// long as it is the same one everywhere.
using Volume = itk::Image<float, 3>;
using Flags = itk::Image<unsigned char, 3>;
using Mattes = itk::MattesMutualInformationImageToImageMetricv4<Volume, Volume>;
using Transform = itk::Euler3DTransform<double>;
using FieldOfView = itk::ImageMaskSpatialObject<3>;
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

/// The metric in one piece: several pieces would be summed in the order in which they are done, and
/// ITK's own limit on their number bounds the threads only.
class Metric : public Mattes
{
public:
  using Pointer = itk::SmartPointer<Metric>;
  static Pointer New()
  {
    Pointer metric = new Metric;
    metric->UnRegister();
    return metric;
  }

protected:
  Metric()
  {
    m_SparseGetValueAndDerivativeThreader->SetNumberOfWorkUnits(1);
    m_DenseGetValueAndDerivativeThreader->SetNumberOfWorkUnits(1);
  }
};

// Metal, and whatever a scanner writes beyond its field of view, tell nothing.
constexpr float least_hu = -1000, most_hu = 2000;

template <class Image>
typename Image::Pointer empty_image(const Lattice& lattice)
{
  auto image = Image::New();
  typename Image::SizeType size;
  typename Image::PointType origin;
  for (unsigned a = 0; a < 3; ++a)
  {
    size[a] = static_cast<itk::SizeValueType>(lattice.size[a]);
    origin[a] = lattice.origin[a];
  }
  image->SetRegions(typename Image::RegionType(size));
  image->SetOrigin(origin);
  image->SetSpacing(typename Image::SpacingType(lattice.spacing));
  image->Allocate();
  return image;
}

Volume::Pointer volume_of(const CtImage& ct, const Lattice& lattice)
{
  const ScalarGrid hu = resample_ct(ct, lattice);
  const auto image = empty_image<Volume>(lattice);
  std::transform(hu.values.begin(), hu.values.end(), image->GetBufferPointer(),
                 [](float v) { return std::clamp(v, least_hu, most_hu); });
  return image;
}

Volume::Pointer smoothed(const Volume::Pointer& image, double sigma_mm)
{
  const auto filter = itk::SmoothingRecursiveGaussianImageFilter<Volume, Volume>::New();
  filter->SetInput(image);
  filter->SetSigma(sigma_mm);
  filter->Update();
  return filter->GetOutput();
}

/// Where a CT shows something; null if that is all of the lattice.
FieldOfView::Pointer field_of_view(const CtImage& ct, const Lattice& lattice)
{
  const auto flags = empty_image<Flags>(lattice);
  unsigned char* flag = flags->GetBufferPointer();
  bool all = true;
  for (int k = 0; k < lattice.size.z(); ++k)
    for (int j = 0; j < lattice.size.y(); ++j)
      for (int i = 0; i < lattice.size.x(); ++i)
      {
        const Vec3 p = lattice.position(i, j, k);
        CtImage::PointType lps;
        lps[0] = -p.x();
        lps[1] = -p.y();
        lps[2] = p.z();
        itk::ContinuousIndex<double, 3> index;
        *flag = ct.TransformPhysicalPointToContinuousIndex(lps, index) ? 1 : 0;
        all = all && *flag++ != 0;
      }
  if (all)
    return nullptr;
  auto mask = FieldOfView::New();
  mask->SetImage(flags);
  mask->Update();
  return mask;
}

/// Minus mutual information over the parameters of a transform, angles times a length.
class Descent
{
public:
  Descent(Metric& metric, Transform& transform, double radius_mm)
      : m_metric(metric), m_transform(transform)
  {
    m_scale << Vec3::Constant(1 / radius_mm), Vec3::Ones();
  }

  double value(const Vec6& x, Vec6& gradient) const
  {
    set(x);
    Metric::MeasureType value;
    Metric::DerivativeType derivative;
    m_metric.GetValueAndDerivative(value, derivative);
    for (unsigned i = 0; i < 6; ++i) // ITK hands out the direction in which the value falls
      gradient[i] = -derivative[i] * m_scale[i];
    return value;
  }
  Vec6 position() const
  {
    Vec6 x;
    for (unsigned i = 0; i < 6; ++i)
      x[i] = m_transform.GetParameters()[i] / m_scale[i];
    return x;
  }
  void set(const Vec6& x) const
  {
    Transform::ParametersType parameters(6);
    for (unsigned i = 0; i < 6; ++i)
      parameters[i] = x[i] * m_scale[i];
    m_transform.SetParameters(parameters);
  }

private:
  Metric& m_metric;
  Transform& m_transform;
  Vec6 m_scale;
};

struct Descended
{
  double value = 0;
  int iterations = 0;
  bool converged = false;
};

/// BFGS with halved steps (J. Nocedal, S. Wright, Numerical Optimization, 2006, section 6.1). The
/// metric's derivative is that of a slightly smoother function, so that near the end no step may
/// lower the value: that is the end.
Descended minimise(const Descent& descent, double precision_mm)
{
  constexpr int most_iterations = 80;
  constexpr double longest_step_mm = 2, first_step_mm = 0.5;
  Vec6 x = descent.position(), gradient;
  Descended result;
  result.value = descent.value(x, gradient);
  Mat6 inverse = Mat6::Identity();
  bool fresh = true;
  for (; result.iterations < most_iterations; ++result.iterations)
  {
    Vec6 step = -inverse * gradient;
    if (fresh || step.dot(gradient) >= 0)
    {
      inverse = Mat6::Identity() * (first_step_mm / std::max(gradient.norm(), 1e-12));
      step = -inverse * gradient;
    }
    step *= std::min(1.0, longest_step_mm / step.norm());
    Vec6 next_gradient;
    double value = descent.value(x + step, next_gradient);
    for (; !(value < result.value) && step.norm() > precision_mm; step *= 0.5)
      value = descent.value(x + 0.5 * step, next_gradient);
    if (!(value < result.value))
    {
      if (fresh)
      {
        result.converged = true;
        break;
      }
      fresh = true;
      continue;
    }
    const Vec6 change = next_gradient - gradient;
    const double curvature = change.dot(step);
    if (curvature > 1e-12)
    {
      const Mat6 left = Mat6::Identity() - step * change.transpose() / curvature;
      inverse = left * inverse * left.transpose() + step * step.transpose() / curvature;
    }
    x += step;
    gradient = next_gradient;
    result.value = value;
    fresh = false;
    if (step.norm() < precision_mm)
    {
      result.converged = true;
      break;
    }
  }
  descent.set(x);
  return result;
}

Metric::FixedSampledPointSetType::Pointer point_set(const std::vector<Vec3>& points)
{
  auto set = Metric::FixedSampledPointSetType::New();
  set->Initialize();
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    Metric::FixedSampledPointSetType::PointType p;
    for (unsigned a = 0; a < 3; ++a)
      p[a] = points[n][a];
    set->SetPoint(n, p);
  }
  return set;
}

Vec3 mean_of(const std::vector<Vec3>& points)
{
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points)
    mean += p / static_cast<double>(points.size());
  return mean;
}

double radius_of_gyration(const std::vector<Vec3>& points, const Vec3& center)
{
  double squares = 0;
  for (const Vec3& p : points)
    squares += (p - center).squaredNorm() / static_cast<double>(points.size());
  return std::sqrt(squares);
}

Transform::Pointer transform_of(const RigidMotion& motion, const Vec3& center)
{
  auto transform = Transform::New();
  Transform::MatrixType matrix;
  Transform::CenterType at;
  Transform::OutputVectorType shift;
  const Vec3 moved = motion.apply(center);
  for (unsigned r = 0; r < 3; ++r)
  {
    for (unsigned c = 0; c < 3; ++c)
      matrix(r, c) = motion.rotation(r, c);
    at[r] = center[r];
    shift[r] = moved[r] - center[r];
  }
  transform->SetCenter(at);
  transform->SetMatrix(matrix, 1e-6);
  transform->SetTranslation(shift);
  return transform;
}

RigidMotion motion_of(const Transform& transform)
{
  RigidMotion motion;
  for (unsigned r = 0; r < 3; ++r)
  {
    for (unsigned c = 0; c < 3; ++c)
      motion.rotation(r, c) = transform.GetMatrix()(r, c);
    motion.reference_point[r] = transform.GetCenter()[r];
    motion.translation[r] = transform.GetTranslation()[r];
  }
  return motion;
}

Box around(const std::vector<Vec3>& points, double margin)
{
  Box box{points.front(), points.front()};
  for (const Vec3& p : points)
  {
    box.min = box.min.cwiseMin(p);
    box.max = box.max.cwiseMax(p);
  }
  box.min.array() -= margin;
  box.max.array() += margin;
  return box;
}

} // namespace

struct MutualInformation::Images
{
  Volume::Pointer fixed, moving;
  FieldOfView::Pointer moving_field;
};

MutualInformation::MutualInformation(const CtImage& fixed, const CtImage& moving,
                                     std::vector<Vec3> points, const Options& options)
    : m_images(std::make_unique<Images>()), m_points(std::move(points)), m_bins(options.bins)
{
  constexpr double margin = 10; // for the smoothing
  const double h = options.spacing_mm;
  const Lattice lattice = lattice_over(extent_ras(moving), h, anchor_ras(moving));
  m_images->fixed = volume_of(fixed, lattice_over(around(m_points, margin), h, anchor_ras(fixed)));
  m_images->moving = volume_of(moving, lattice);
  m_images->moving_field = field_of_view(moving, lattice);
}

MutualInformation::~MutualInformation() = default;

MutualInformation::Maximum MutualInformation::climb(const RigidMotion& start, double sigma_mm,
                                                    double precision_mm) const
{
  const Vec3 center = mean_of(m_points);
  const Transform::Pointer transform = transform_of(start, center);
  const auto metric = Metric::New();
  metric->SetNumberOfHistogramBins(static_cast<itk::SizeValueType>(m_bins));
  metric->SetUseMovingImageGradientFilter(false);
  metric->SetUseFixedImageGradientFilter(false);
  const Volume::Pointer fixed = smoothed(m_images->fixed, sigma_mm);
  const Volume::Pointer moving = smoothed(m_images->moving, sigma_mm);
  metric->SetFixedImage(fixed);
  metric->SetMovingImage(moving);
  metric->SetVirtualDomainFromImage(fixed);
  metric->SetMovingTransform(transform);
  metric->SetFixedSampledPointSet(point_set(m_points));
  metric->SetUseSampledPointSet(true);
  if (m_images->moving_field)
    metric->SetMovingImageMask(m_images->moving_field);
  try
  {
    metric->Initialize();
    const Descended found =
        minimise(Descent(*metric, *transform, radius_of_gyration(m_points, center)), precision_mm);
    return {motion_of(*transform), -found.value, found.iterations, found.converged};
  }
  catch (const itk::ExceptionObject&)
  {
    throw Error("the registration of the post-operative CT",
                "the two CTs lost each other while mutual information was sought",
                "give a box or mask of bone that the operation left alone, seen in both CTs",
                ErrorKind::Numerical);
  }
}

} // namespace f2b
