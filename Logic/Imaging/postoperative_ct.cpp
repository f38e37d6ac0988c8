#include "Imaging/postoperative_ct.hpp"

#include "Core/error.hpp"
#include "Core/mesh/contact.hpp"
#include "Core/mesh/mixed_mesh.hpp"
#include "Imaging/lattice.hpp"
#include "Imaging/resample_ct.hpp"
#include "Imaging/scanner_artefacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace f2b
{
namespace
{

using Vec3f = Eigen::Vector3f;

/// Voxels of the new CT; edges may differ by axis.
struct Voxels
{
  Vec3 origin, spacing;
  Eigen::Vector3i size;

  std::size_t count() const { return static_cast<std::size_t>(size.x()) * size.y() * size.z(); }
  std::size_t index(int i, int j, int k) const
  {
    return (static_cast<std::size_t>(k) * size.y() + j) * size.x() + i;
  }
  Vec3 position(int i, int j, int k) const { return origin + spacing.cwiseProduct(Vec3(i, j, k)); }
};

/// What decides a voxel's value.
enum class Origin : unsigned char
{
  Unmoved,   ///< its own place
  Bone,      ///< a part of the bone, or a cavity in it
  Tissue,    ///< an element of the mesh
  Beside,    ///< the displacement of the tissue beside it: the edge of the skin is carried along
  LeftBehind ///< nothing: what was there went away
};

bool in_box(const ScalarGrid& grid, const Vec3& p)
{
  const Vec3 last = grid.position(grid.size.x() - 1, grid.size.y() - 1, grid.size.z() - 1);
  return (p.array() >= grid.origin.array()).all() && (p.array() <= last.array()).all();
}

class SecondScan
{
public:
  SecondScan(const OperatedPatient& patient, const PostoperativeCtOptions& options);
  CtImage::Pointer image();

private:
  template <class Visit>
  void for_each_voxel_of(const std::array<Vec3, 4>& corners, Visit visit) const;
  template <class Visit>
  void for_each_neighbor(std::size_t voxel, Visit visit) const;
  Vec3 rest_frame(std::size_t voxel) const;
  void fill_mesh();
  void place_bone();
  bool bone_or_cavity_at(const Vec3& y, Vec3& source) const;
  bool was_fragment(const Vec3& y) const;
  void carry_edge();
  void find_left_behind();
  void let_air_in();
  double hounsfield(const Vec3& source) const;
  double value(std::size_t voxel) const;

  const OperatedPatient& m_patient;
  const PostoperativeCtOptions& m_options;
  RigidMotion m_back; ///< of the reslice
  std::vector<RigidMotion> m_undone;
  std::vector<ScalarGrid> m_part; ///< level set of the bone that stays, then of each fragment
  Voxels m_voxels;
  std::vector<Origin> m_origin;
  std::vector<Vec3f> m_shift;      ///< from the voxel in the rest frame to its source
  std::vector<char> m_was_tissue;  ///< the mesh at rest covers it
  std::vector<char> m_air_reaches; ///< of what was left behind
};

SecondScan::SecondScan(const OperatedPatient& patient, const PostoperativeCtOptions& options)
    : m_patient(patient), m_options(options), m_back(inverse(options.reslice))
{
  for (const RigidMotion& motion : patient.motions)
    m_undone.push_back(inverse(motion));
  for (std::size_t p = 0; p <= patient.motions.size(); ++p)
    m_part.push_back(part_field(patient.bone, patient.partition,
                                static_cast<unsigned char>(BonePartition::uncut + p)));
  Vec3 lower = Vec3::Constant(1e300), upper = -lower;
  for (int corner = 0; corner < 8; ++corner)
  {
    const Eigen::Vector3i last = patient.hu.size - Eigen::Vector3i::Ones();
    const Vec3 p = options.reslice.apply(patient.hu.position(
        corner & 1 ? last.x() : 0, corner & 2 ? last.y() : 0, corner & 4 ? last.z() : 0));
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  m_voxels.origin = lower;
  m_voxels.spacing = options.spacing_mm;
  m_voxels.size = (upper - lower).cwiseQuotient(options.spacing_mm).array().ceil().cast<int>() + 1;
  m_origin.assign(m_voxels.count(), Origin::Unmoved);
  m_shift.assign(m_voxels.count(), Vec3f::Zero());
  m_was_tissue.assign(m_voxels.count(), 0);
  m_air_reaches.assign(m_voxels.count(), 0);
}

/// The voxels whose centres lie in a tetrahedron, with the centre's area coordinates.
template <class Visit>
void SecondScan::for_each_voxel_of(const std::array<Vec3, 4>& c, Visit visit) const
{
  Mat3 edges;
  edges << c[1] - c[0], c[2] - c[0], c[3] - c[0];
  if (!(std::abs(edges.determinant()) > 1e-9))
    return;
  const Mat3 to_weights = edges.inverse();
  Eigen::Vector3i first, last;
  for (int a = 0; a < 3; ++a)
  {
    const auto [low, high] = std::minmax({c[0][a], c[1][a], c[2][a], c[3][a]});
    const double h = m_voxels.spacing[a], from = m_voxels.origin[a];
    first[a] = std::max(0, static_cast<int>(std::ceil((low - from) / h - 1e-6)));
    last[a] =
        std::min(m_voxels.size[a] - 1, static_cast<int>(std::floor((high - from) / h + 1e-6)));
  }
  for (int k = first.z(); k <= last.z(); ++k)
    for (int j = first.y(); j <= last.y(); ++j)
      for (int i = first.x(); i <= last.x(); ++i)
      {
        const Vec3 w = to_weights * (m_voxels.position(i, j, k) - c[0]);
        if (w.minCoeff() >= -1e-9 && w.sum() <= 1 + 1e-9)
          visit(m_voxels.index(i, j, k), w);
      }
}

template <class Visit>
void SecondScan::for_each_neighbor(std::size_t voxel, Visit visit) const
{
  const auto nx = static_cast<std::size_t>(m_voxels.size.x()),
             ny = static_cast<std::size_t>(m_voxels.size.y()),
             nz = static_cast<std::size_t>(m_voxels.size.z());
  const std::size_t i = voxel % nx, j = voxel / nx % ny, k = voxel / (nx * ny);
  if (i > 0)
    visit(voxel - 1);
  if (i + 1 < nx)
    visit(voxel + 1);
  if (j > 0)
    visit(voxel - nx);
  if (j + 1 < ny)
    visit(voxel + nx);
  if (k > 0)
    visit(voxel - nx * ny);
  if (k + 1 < nz)
    visit(voxel + nx * ny);
}

/// Where a voxel lies for the patient before he was moved into the second scanner.
Vec3 SecondScan::rest_frame(std::size_t voxel) const
{
  const auto nx = static_cast<std::size_t>(m_voxels.size.x()),
             ny = static_cast<std::size_t>(m_voxels.size.y());
  return m_back.apply(m_voxels.position(static_cast<int>(voxel % nx),
                                        static_cast<int>(voxel / nx % ny),
                                        static_cast<int>(voxel / (nx * ny))));
}

void SecondScan::fill_mesh()
{
  auto corners = [&](const std::array<int, 4>& tet, const std::vector<Vec3>& at)
  {
    std::array<Vec3, 4> c;
    for (std::size_t n = 0; n < 4; ++n)
      c[n] = m_options.reslice.apply(at[static_cast<std::size_t>(tet[n])]);
    return c;
  };
  for (const std::array<int, 4>& tet : m_patient.tets)
  {
    std::array<Vec3, 4> u; // back to rest
    for (std::size_t n = 0; n < 4; ++n)
      u[n] = m_patient.X[static_cast<std::size_t>(tet[n])] -
             m_patient.x[static_cast<std::size_t>(tet[n])];
    for_each_voxel_of(corners(tet, m_patient.X),
                      [&](std::size_t voxel, const Vec3&) { m_was_tissue[voxel] = 1; });
    for_each_voxel_of(
        corners(tet, m_patient.x),
        [&](std::size_t voxel, const Vec3& w)
        {
          m_origin[voxel] = Origin::Tissue;
          m_shift[voxel] =
              ((1 - w.sum()) * u[0] + w[0] * u[1] + w[1] * u[2] + w[2] * u[3]).cast<float>();
        });
  }
}

/// Where the bone, or the cavity of a bone, that is now at y came from.
bool SecondScan::bone_or_cavity_at(const Vec3& y, Vec3& source) const
{
  // so wide that the edge of the bone, blurred over a voxel, moves as one
  const double halo = 1.2 * m_patient.bone.spacing;
  const LabelGrid& labels = m_patient.partition.labels;
  auto hard = [&](std::size_t part, const Vec3& X)
  {
    return in_box(m_patient.bone, X) && m_part[part].value(X) < halo &&
           nearest_bone(labels, X) == BonePartition::uncut + part;
  };
  for (std::size_t f = 0; f < m_undone.size(); ++f)
    if (hard(f + 1, source = m_undone[f].apply(y)))
      return true;
  if (hard(0, source = y))
    return true;
  for (std::size_t f = 0; f < m_undone.size(); ++f)
    if (source = m_undone[f].apply(y); in_box(m_patient.bone, source) &&
                                       labels.nearest(source) == BonePartition::first_fragment + f)
      return true;
  return false;
}

void SecondScan::place_bone()
{
#pragma omp parallel for schedule(dynamic)
  for (int k = 0; k < m_voxels.size.z(); ++k)
    for (std::size_t voxel = m_voxels.index(0, 0, k); voxel < m_voxels.index(0, 0, k + 1); ++voxel)
    {
      const Vec3 y = rest_frame(voxel);
      Vec3 source;
      if (!bone_or_cavity_at(y, source))
        continue;
      m_origin[voxel] = Origin::Bone;
      m_shift[voxel] = (source - y).cast<float>();
    }
}

/// The edge of the skin is blurred over some voxels that no element covers; they go along.
void SecondScan::carry_edge()
{
  const int layers = static_cast<int>(std::ceil(3 / m_options.spacing_mm.minCoeff()));
  std::vector<std::size_t> front;
  for (std::size_t voxel = 0; voxel < m_origin.size(); ++voxel)
    if (m_origin[voxel] == Origin::Tissue)
      front.push_back(voxel);
  for (int layer = 0; layer < layers; ++layer)
  {
    std::vector<std::size_t> next;
    for (const std::size_t voxel : front)
      for_each_neighbor(voxel,
                        [&](std::size_t n)
                        {
                          if (m_origin[n] == Origin::Unmoved)
                            next.push_back(n);
                        });
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    std::vector<Vec3f> shifts;
    for (const std::size_t voxel : next)
    {
      Vec3f sum = Vec3f::Zero();
      float count = 0;
      for_each_neighbor(voxel,
                        [&](std::size_t n)
                        {
                          if (m_origin[n] != Origin::Tissue && m_origin[n] != Origin::Beside)
                            return;
                          sum += m_shift[n];
                          ++count;
                        });
      shifts.push_back(sum / count);
    }
    for (std::size_t n = 0; n < next.size(); ++n)
    {
      m_origin[next[n]] = Origin::Beside;
      m_shift[next[n]] = shifts[n];
    }
    front = std::move(next);
  }
}

bool SecondScan::was_fragment(const Vec3& y) const
{
  if (!in_box(m_patient.bone, y))
    return false;
  const LabelGrid& labels = m_patient.partition.labels;
  return labels.nearest(y) >= BonePartition::first_fragment ||
         (m_patient.bone.value(y) < 1.5 * m_patient.bone.spacing &&
          nearest_bone(labels, y) >= BonePartition::first_fragment);
}

/// Unmoved voxels whose content went away: tissue with the edge of the skin on it, and fragments.
void SecondScan::find_left_behind()
{
  const int layers = static_cast<int>(std::ceil(2 / m_options.spacing_mm.minCoeff()));
  std::vector<std::size_t> front;
  for (std::size_t voxel = 0; voxel < m_origin.size(); ++voxel)
  {
    if (m_was_tissue[voxel])
      front.push_back(voxel);
    if (m_origin[voxel] == Origin::Unmoved &&
        (m_was_tissue[voxel] || was_fragment(rest_frame(voxel))))
      m_origin[voxel] = Origin::LeftBehind;
  }
  for (int layer = 0; layer < layers; ++layer)
  {
    std::vector<std::size_t> next;
    for (const std::size_t voxel : front)
      for_each_neighbor(voxel,
                        [&](std::size_t n)
                        {
                          if (m_was_tissue[n])
                            return;
                          m_was_tissue[n] = 1;
                          next.push_back(n);
                          if (m_origin[n] == Origin::Unmoved)
                            m_origin[n] = Origin::LeftBehind;
                        });
    front = std::move(next);
  }
}

void SecondScan::let_air_in()
{
  constexpr double air_below_hu = -500;
  std::vector<std::size_t> front;
  for (std::size_t voxel = 0; voxel < m_origin.size(); ++voxel)
  {
    if (m_origin[voxel] != Origin::LeftBehind)
      continue;
    bool open = false;
    for_each_neighbor(
        voxel, [&](std::size_t n)
        { open = open || (m_origin[n] != Origin::LeftBehind && value(n) < air_below_hu); });
    if (open)
      front.push_back(voxel);
  }
  for (const std::size_t voxel : front)
    m_air_reaches[voxel] = 1;
  while (!front.empty())
  {
    const std::size_t voxel = front.back();
    front.pop_back();
    for_each_neighbor(voxel,
                      [&](std::size_t n)
                      {
                        if (m_origin[n] != Origin::LeftBehind || m_air_reaches[n])
                          return;
                        m_air_reaches[n] = 1;
                        front.push_back(n);
                      });
  }
}

double SecondScan::hounsfield(const Vec3& source) const
{
  return in_box(m_patient.hu, source) ? m_patient.hu.value(source) : air_hu;
}

double SecondScan::value(std::size_t voxel) const
{
  const Origin origin = m_origin[voxel];
  if (origin == Origin::LeftBehind)
    return m_air_reaches[voxel] ? air_hu : m_options.soft_tissue_hu;
  const Vec3 source = rest_frame(voxel) + m_shift[voxel].cast<double>();
  const bool soft = origin == Origin::Tissue || origin == Origin::Beside;
  // tissue that comes off the bone takes no bone along
  if (soft && in_box(m_patient.bone, source) &&
      m_patient.bone.value(source) < 0.5 * m_patient.bone.spacing)
    return m_options.soft_tissue_hu;
  return hounsfield(source);
}

CtImage::Pointer SecondScan::image()
{
  fill_mesh();
  place_bone();
  carry_edge();
  find_left_behind();
  let_air_in();

  auto image = CtImage::New();
  CtImage::SizeType size;
  CtImage::SpacingType spacing;
  CtImage::PointType origin;
  CtImage::DirectionType direction;
  direction.SetIdentity();
  const double lps[3] = {-1, -1, 1};
  for (unsigned a = 0; a < 3; ++a)
  {
    size[a] = static_cast<itk::SizeValueType>(m_voxels.size[a]);
    spacing[a] = m_voxels.spacing[a];
    origin[a] = lps[a] * m_voxels.origin[a];
    direction(a, a) = lps[a];
  }
  image->SetRegions(CtImage::RegionType(size));
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  image->SetDirection(direction);
  image->Allocate();
  short* hu = image->GetBufferPointer();
#pragma omp parallel for schedule(dynamic)
  for (int k = 0; k < m_voxels.size.z(); ++k)
    for (std::size_t v = m_voxels.index(0, 0, k); v < m_voxels.index(0, 0, k + 1); ++v)
    {
      const double noisy = value(v) + m_options.noise_sd_hu * standard_noise(m_options.seed, v);
      hu[v] = static_cast<short>(std::lround(std::clamp(noisy, -1024.0, 3071.0)));
    }
  return image;
}

void check(const OperatedPatient& patient, const PostoperativeCtOptions& options)
{
  for (int axis = 0; axis < 3; ++axis)
    if (!(options.spacing_mm[axis] >= 0.3 && options.spacing_mm[axis] <= 5))
      throw Error("spacing_mm", "it is " + std::to_string(options.spacing_mm[axis]) + " mm",
                  "choose 0.3 to 5 mm");
  if (!(options.noise_sd_hu >= 0 && options.noise_sd_hu <= 500))
    throw Error("noise_sd_hu", "it is " + std::to_string(options.noise_sd_hu) + " HU",
                "choose 0 to 500 HU");
  const unsigned char most = *std::max_element(patient.partition.labels.values.begin(),
                                               patient.partition.labels.values.end());
  if (most >= BonePartition::first_fragment + patient.motions.size())
    throw Error("movements",
                "there are " + std::to_string(patient.motions.size()) + ", but the bone has " +
                    std::to_string(most - BonePartition::uncut) + " fragments",
                "give one movement for each fragment");
}

} // namespace

CtImage::Pointer synthesize_postoperative_ct(const OperatedPatient& patient,
                                             const PostoperativeCtOptions& options)
{
  check(patient, options);
  return SecondScan(patient, options).image();
}

} // namespace f2b
