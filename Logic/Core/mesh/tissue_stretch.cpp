#include "Core/mesh/tissue_stretch.hpp"

#include <Eigen/SVD>

#include <algorithm>

namespace f2b
{
namespace
{

Mat3 edges(const std::vector<Vec3>& points, const std::array<int, 4>& tet)
{
  Mat3 m;
  for (int c = 0; c < 3; ++c)
    m.col(c) = points[static_cast<std::size_t>(tet[static_cast<std::size_t>(c) + 1])] -
               points[static_cast<std::size_t>(tet[0])];
  return m;
}

} // namespace

TissueStretch tissue_stretch(const MixedMesh& mesh, const std::vector<Vec3>& x)
{
  std::vector<std::pair<double, double>> stretch_and_volume;
  TissueStretch result;
  double total = 0;
  for (const auto& tet : mesh.tets)
  {
    const Mat3 rest = edges(mesh.X, tet);
    const double stretch =
        Eigen::JacobiSVD<Mat3>(edges(x, tet) * rest.inverse()).singularValues()[0];
    stretch_and_volume.emplace_back(stretch, rest.determinant());
    total += rest.determinant();
    if (stretch > result.max)
    {
      result.max = stretch;
      result.where = mesh.X[static_cast<std::size_t>(tet[0])] + rest.rowwise().sum() / 4;
    }
  }
  std::sort(stretch_and_volume.begin(), stretch_and_volume.end());
  double below = 0;
  for (const auto& [stretch, volume] : stretch_and_volume)
  {
    below += volume;
    if (below >= 0.99 * total)
    {
      result.p99 = stretch;
      break;
    }
  }
  return result;
}

} // namespace f2b
