#include "Imaging/synthetic_ct.hpp"

#include "Core/error.hpp"
#include "Imaging/scanner_artefacts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include <omp.h>

namespace f2b
{
namespace
{

constexpr double block_edge = 8; ///< mm
// The scanner's blur as a multiple of the sample; sharper at bone, so that thresholds which lie low
// on bone's edge do not bridge the joints and the tooth rows.
constexpr double soft_blur = 2.6, hard_blur = 1.8;
constexpr double skin_thickness = 2.4; ///< mm
constexpr double cortex_thickness = 2; ///< mm

void check(const SyntheticCtOptions& options)
{
  std::ostringstream text;
  for (int axis = 0; axis < 3; ++axis)
    if (!(options.spacing_mm[axis] >= 0.3 && options.spacing_mm[axis] <= 5))
    {
      text << "is " << options.spacing_mm[axis] << " mm along axis " << axis;
      throw Error("spacing_mm", text.str(), "choose 0.3 to 5 mm");
    }
  if (!((options.upper_ras - options.lower_ras).minCoeff() >= 10))
    throw Error("field of view", "is less than 10 mm wide", "move lower_ras and upper_ras apart");
  if (!(options.noise_sd_hu >= 0 && options.noise_sd_hu <= 500))
  {
    text << "is " << options.noise_sd_hu << " HU";
    throw Error("noise_sd_hu", text.str(), "choose 0 to 500 HU");
  }
}

/// What a block of voxels holds, decided once from its centre.
enum class Block
{
  Outside,
  Brain,
  Mixed
};

class Scanner
{
public:
  Scanner(const VirtualPatient& patient, const SyntheticCtOptions& options)
      : m_patient(patient), m_options(options), m_hu(options.hounsfield)
  {
    const Vec3 extent = options.upper_ras - options.lower_ras;
    for (int axis = 0; axis < 3; ++axis)
    {
      m_size[axis] = static_cast<int>(std::lround(extent[axis] / options.spacing_mm[axis])) + 1;
      // A voxel thicker than 1 mm is the mean of two samples.
      m_samples[axis] = options.spacing_mm[axis] > 1 ? 2 : 1;
      m_block[axis] =
          std::max(1, static_cast<int>(std::lround(block_edge / options.spacing_mm[axis])));
      m_sample_spacing[axis] = options.spacing_mm[axis] / m_samples[axis];
    }
    m_edge_width = std::cbrt(m_sample_spacing.prod());
    m_block_radius = 0.5 * m_block.cast<double>().cwiseProduct(options.spacing_mm).norm();
    if (options.streaks)
      m_streaks.emplace(patient, options.seed);
  }

  CtImage::Pointer image() const;

private:
  CtImage::Pointer empty_image() const;
  void scan_block(const Eigen::Vector3i& block, short* voxels) const;
  Block content(const Vec3& block_centre) const;
  double voxel(const Vec3& centre, Block content) const;
  double sample(const Vec3& p, Block content) const;
  double soft_tissue(const TissueDistances& distances) const;
  double hard_tissue(const TissueDistances& distances) const;
  /// Share of a sample that lies inside a surface at this signed distance.
  double inside(double distance, double blur = soft_blur) const
  {
    return std::clamp(0.5 - distance / (blur * m_edge_width), 0.0, 1.0);
  }
  static double blend(double from, double to, double share) { return from + share * (to - from); }

  /// Voxel (0, 0, 0) is the most right (+R), most anterior, lowest one: LPS runs against R and A.
  Vec3 centre(int i, int j, int k) const
  {
    const Vec3& h = m_options.spacing_mm;
    return {m_options.upper_ras.x() - i * h.x(), m_options.upper_ras.y() - j * h.y(),
            m_options.lower_ras.z() + k * h.z()};
  }

  const VirtualPatient& m_patient;
  const SyntheticCtOptions& m_options;
  const TissueHounsfield m_hu;
  Eigen::Vector3i m_size, m_samples;
  Eigen::Vector3i m_block; ///< voxels of a block along each axis
  Vec3 m_sample_spacing;
  double m_edge_width, m_block_radius;
  std::optional<MetalStreaks> m_streaks;
};

Block Scanner::content(const Vec3& block_centre) const
{
  // The estimates of the shapes can grow a little faster than the distance: a margin of a fifth.
  const double reach = 1.2 * m_block_radius + 2;
  const TissueDistances d = m_patient.distances(block_centre);
  if (d.skin > reach)
    return Block::Outside;
  return d.brain < -reach && d.bone > reach ? Block::Brain : Block::Mixed;
}

double Scanner::soft_tissue(const TissueDistances& d) const
{
  double hu = blend(m_hu.fat, m_hu.muscle, inside(d.muscle));
  hu = blend(hu, m_hu.brain, inside(d.brain));
  return blend(m_hu.skin, hu, inside(d.skin + skin_thickness));
}

double Scanner::hard_tissue(const TissueDistances& d) const
{
  const double core = inside(d.bone + cortex_thickness);
  const double hu = blend(m_hu.cortical_bone, m_hu.trabecular_bone, core);
  return blend(hu, m_hu.tooth, inside(d.teeth, hard_blur));
}

double Scanner::sample(const Vec3& p, Block content) const
{
  if (content == Block::Brain)
    return m_hu.brain;
  const double around =
      m_options.head_rest ? head_rest_hounsfield(p, m_hu.air, m_edge_width) : m_hu.air;
  if (content == Block::Outside)
    return around;
  const TissueDistances d = m_patient.distances(p);
  double hu = blend(soft_tissue(d), hard_tissue(d), inside(d.bone, hard_blur));
  hu = blend(hu, m_hu.air, inside(d.air));
  return blend(around, hu, inside(d.skin));
}

double Scanner::voxel(const Vec3& middle, Block content) const
{
  double sum = 0;
  const Vec3 first = middle - 0.5 * (m_options.spacing_mm - m_sample_spacing);
  for (int k = 0; k < m_samples.z(); ++k)
    for (int j = 0; j < m_samples.y(); ++j)
      for (int i = 0; i < m_samples.x(); ++i)
        sum += sample(first + Vec3(i, j, k).cwiseProduct(m_sample_spacing), content);
  return sum / m_samples.prod();
}

void Scanner::scan_block(const Eigen::Vector3i& block, short* voxels) const
{
  const Eigen::Vector3i first = m_block.cwiseProduct(block);
  const Eigen::Vector3i last = (first + m_block).cwiseMin(m_size);
  const Vec3 half = 0.5 * (m_block.cast<double>() - Vec3::Ones());
  const Vec3 middle = centre(first.x(), first.y(), first.z()) +
                      half.cwiseProduct(m_options.spacing_mm).cwiseProduct(Vec3(-1, -1, 1));
  const Block inhabitants = content(middle);
  for (int k = first.z(); k < last.z(); ++k)
    for (int j = first.y(); j < last.y(); ++j)
      for (int i = first.x(); i < last.x(); ++i)
      {
        const std::size_t index = (static_cast<std::size_t>(k) * m_size.y() + j) * m_size.x() + i;
        const Vec3 p = centre(i, j, k);
        double hu = voxel(p, inhabitants);
        if (m_streaks)
          hu = m_streaks->apply(p, hu);
        hu += m_options.noise_sd_hu * standard_noise(m_options.seed, index);
        voxels[index] = static_cast<short>(std::lround(std::clamp(hu, -1024.0, 3071.0)));
      }
}

CtImage::Pointer Scanner::empty_image() const
{
  auto image = CtImage::New();
  CtImage::SizeType size;
  CtImage::SpacingType spacing;
  CtImage::PointType origin;
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    size[axis] = static_cast<itk::SizeValueType>(m_size[axis]);
    spacing[axis] = m_options.spacing_mm[axis];
    origin[axis] = (axis < 2 ? -1 : 1) * centre(0, 0, 0)[axis];
  }
  image->SetRegions(CtImage::RegionType(size));
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  image->Allocate();
  return image;
}

CtImage::Pointer Scanner::image() const
{
  CtImage::Pointer image = empty_image();
  short* voxels = image->GetBufferPointer();
  const Eigen::Vector3i blocks =
      (m_size + m_block - Eigen::Vector3i::Ones()).cwiseQuotient(m_block);
  const int threads = m_options.threads > 0 ? m_options.threads : omp_get_max_threads();
#pragma omp parallel for schedule(dynamic, 16) num_threads(threads)
  for (int b = 0; b < blocks.prod(); ++b)
    scan_block({b % blocks.x(), b / blocks.x() % blocks.y(), b / (blocks.x() * blocks.y())},
               voxels);
  return image;
}

} // namespace

CtImage::Pointer synthesize_ct(const VirtualPatient& patient, const SyntheticCtOptions& options)
{
  check(options);
  return Scanner(patient, options).image();
}

} // namespace f2b
