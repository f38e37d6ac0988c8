#include "Core/mesh/contact.hpp"

#include "Core/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace f2b
{

unsigned char nearest_bone(const LabelGrid& labels, const Vec3& point_ras)
{
  constexpr int reach = 4;
  const Vec3 p = (point_ras - labels.origin) / labels.spacing;
  double nearest = std::numeric_limits<double>::infinity();
  unsigned char found = BonePartition::uncut;
  const Eigen::Vector3i base(static_cast<int>(std::lround(p.x())), static_cast<int>(std::lround(p.y())),
                             static_cast<int>(std::lround(p.z())));
  for (int k = std::max(0, base.z() - reach); k <= std::min(labels.size.z() - 1, base.z() + reach); ++k)
    for (int j = std::max(0, base.y() - reach); j <= std::min(labels.size.y() - 1, base.y() + reach); ++j)
      for (int i = std::max(0, base.x() - reach); i <= std::min(labels.size.x() - 1, base.x() + reach);
           ++i)
      {
        const unsigned char label = labels.values[labels.index(i, j, k)];
        const double distance = (Vec3(i, j, k) - p).squaredNorm();
        if (label != BonePartition::no_bone && distance < nearest)
        {
          nearest = distance;
          found = label;
        }
      }
  return found;
}

namespace
{

bool near_a_cut(const Vec3& point, const BonePartition& partition, double margin_mm)
{
  for (const auto& points : partition.cut_points)
    for (const Vec3& cut : points)
      if ((cut - point).squaredNorm() < margin_mm * margin_mm)
        return true;
  return false;
}

} // namespace

ContactReport assign_contacts(MixedMesh& mesh, const BonePartition& partition, double release_margin_mm)
{
  ContactReport report;
  report.fragments.assign(partition.osteotomies.size(), 0);
  mesh.fragments.clear();
  for (const Osteotomy& osteotomy : partition.osteotomies)
    mesh.fragments.push_back(osteotomy.fragment);
  mesh.node_fragment.assign(mesh.X.size(), -1);
  for (std::size_t n = 0; n < mesh.X.size(); ++n)
  {
    if (mesh.node_boundary[n] != Boundary::FixedBone)
      continue;
    const unsigned char label = nearest_bone(partition.labels, mesh.X[n]);
    if (near_a_cut(mesh.X[n], partition, release_margin_mm))
    {
      mesh.node_boundary[n] = Boundary::Free;
      ++report.released;
    }
    else if (label >= BonePartition::first_fragment)
    {
      mesh.node_boundary[n] = Boundary::Fragment;
      mesh.node_fragment[n] = label - BonePartition::first_fragment;
      ++report.fragments[label - BonePartition::first_fragment];
    }
    else
      ++report.fixed;
  }
  for (std::size_t f = 0; f < report.fragments.size(); ++f)
    if (report.fragments[f] < 3)
      throw Error("fragment '" + mesh.fragments[f] + "'",
                  "soft tissue hangs on it at " + std::to_string(report.fragments[f]) +
                      " mesh nodes, 3 are needed",
                  "widen the region of interest over it, use a smaller release margin "
                  "(mesh.release_margin_mm) or a denser mesh (mesh.density)");
  return report;
}

Vec3 area_centroid(const TriangleMesh& mesh)
{
  Vec3 sum = Vec3::Zero();
  double area = 0;
  for (const Triangle& t : mesh.triangles)
  {
    const Vec3& a = mesh.points[static_cast<std::size_t>(t[0])];
    const Vec3& b = mesh.points[static_cast<std::size_t>(t[1])];
    const Vec3& c = mesh.points[static_cast<std::size_t>(t[2])];
    const double doubled = (b - a).cross(c - a).norm();
    sum += doubled * (a + b + c) / 3;
    area += doubled;
  }
  return area > 0 ? Vec3(sum / area) : sum;
}

} // namespace f2b
