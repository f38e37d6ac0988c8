#include "Imaging/resample_ct.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace f2b
{
namespace
{

const Vec3 lps_to_ras(-1.0, -1.0, 1.0);

/// Continuous voxel index = matrix * ras + shift.
struct RasToIndex
{
  Mat3 matrix;
  Vec3 shift;
};

RasToIndex ras_to_index(const CtImage& ct)
{
  Mat3 index_to_ras;
  Vec3 origin;
  for (int row = 0; row < 3; ++row)
  {
    origin[row] = lps_to_ras[row] * ct.GetOrigin()[row];
    for (int column = 0; column < 3; ++column)
      index_to_ras(row, column) =
          lps_to_ras[row] * ct.GetDirection()(row, column) * ct.GetSpacing()[column];
  }
  const Mat3 inverse = index_to_ras.inverse();
  return {inverse, -inverse * origin};
}

class Sampler
{
public:
  explicit Sampler(const CtImage& ct) : m_voxels(ct.GetBufferPointer())
  {
    for (int a = 0; a < 3; ++a)
      m_size[a] = static_cast<int>(ct.GetBufferedRegion().GetSize()[a]);
  }

  float value(const Vec3& index) const
  {
    std::ptrdiff_t base[3];
    double f[3];
    for (int a = 0; a < 3; ++a)
    {
      // A hundredth of a voxel of tolerance, for rounding at the walls.
      if (index[a] < -0.01 || index[a] > m_size[a] - 0.99)
        return air_hu;
      const double inside = std::clamp(index[a], 0.0, m_size[a] - 1.0);
      base[a] = std::min(static_cast<int>(inside), m_size[a] - 2);
      f[a] = inside - static_cast<double>(base[a]);
    }
    const std::ptrdiff_t dy = m_size[0], dz = dy * m_size[1];
    const short* v = m_voxels + base[0] + base[1] * dy + base[2] * dz;
    const double c00 = v[0] + f[0] * (v[1] - v[0]);
    const double c10 = v[dy] + f[0] * (v[dy + 1] - v[dy]);
    const double c01 = v[dz] + f[0] * (v[dz + 1] - v[dz]);
    const double c11 = v[dy + dz] + f[0] * (v[dy + dz + 1] - v[dy + dz]);
    const double c0 = c00 + f[1] * (c10 - c00), c1 = c01 + f[1] * (c11 - c01);
    return static_cast<float>(c0 + f[2] * (c1 - c0));
  }

private:
  const short* m_voxels;
  int m_size[3];
};

} // namespace

Box extent_ras(const CtImage& ct)
{
  const auto size = ct.GetBufferedRegion().GetSize();
  Box box;
  box.min = Vec3::Constant(1e300);
  box.max = -box.min;
  for (int corner = 0; corner < 8; ++corner)
  {
    CtImage::IndexType index;
    for (int a = 0; a < 3; ++a)
      index[a] = (corner >> a & 1) ? static_cast<itk::IndexValueType>(size[a]) - 1 : 0;
    CtImage::PointType lps;
    ct.TransformIndexToPhysicalPoint(index, lps);
    const Vec3 ras = lps_to_ras.cwiseProduct(Vec3(lps[0], lps[1], lps[2]));
    box.min = box.min.cwiseMin(ras);
    box.max = box.max.cwiseMax(ras);
  }
  return box;
}

Vec3 anchor_ras(const CtImage& ct)
{
  return lps_to_ras.cwiseProduct(Vec3(ct.GetOrigin()[0], ct.GetOrigin()[1], ct.GetOrigin()[2]));
}

ScalarGrid resample_ct(const CtImage& ct, const Lattice& lattice)
{
  const RasToIndex to_index = ras_to_index(ct);
  const Sampler sampler(ct);
  ScalarGrid hu = grid_on(lattice, air_hu);
#pragma omp parallel for schedule(dynamic)
  for (int k = 0; k < lattice.size.z(); ++k)
    for (int j = 0; j < lattice.size.y(); ++j)
    {
      const Vec3 first = to_index.matrix * lattice.position(0, j, k) + to_index.shift;
      const Vec3 step = to_index.matrix.col(0) * lattice.spacing;
      float* row = &hu.values[hu.index(0, j, k)];
      for (int i = 0; i < lattice.size.x(); ++i)
        row[i] = sampler.value(first + i * step);
    }
  return hu;
}

} // namespace f2b
