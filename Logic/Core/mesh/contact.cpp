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
  const Eigen::Vector3i base(static_cast<int>(std::lround(p.x())),
                             static_cast<int>(std::lround(p.y())),
                             static_cast<int>(std::lround(p.z())));
  for (int k = std::max(0, base.z() - reach); k <= std::min(labels.size.z() - 1, base.z() + reach);
       ++k)
    for (int j = std::max(0, base.y() - reach);
         j <= std::min(labels.size.y() - 1, base.y() + reach); ++j)
      for (int i = std::max(0, base.x() - reach);
           i <= std::min(labels.size.x() - 1, base.x() + reach); ++i)
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

/// What a prescribed node moves with: -1 bone that stays (and the crop walls), else a fragment.
/// Nodes that are not prescribed move with nothing.
constexpr int nothing = -2;
int body_of(const MixedMesh& mesh, std::size_t node)
{
  switch (mesh.node_boundary[node])
  {
  case Boundary::Fragment:
    return mesh.node_fragment[node];
  case Boundary::FixedBone:
  case Boundary::Crop:
    return -1;
  default:
    return nothing;
  }
}

/// Marks the contact nodes of elements that hang on two bodies.
template <std::size_t N>
void mark_torn(const MixedMesh& mesh, const std::vector<std::array<int, N>>& elements,
               std::vector<char>& torn)
{
  for (const auto& corners : elements)
  {
    int first = nothing;
    bool two = false;
    for (const int corner : corners)
    {
      const int body = body_of(mesh, static_cast<std::size_t>(corner));
      two = two || (body != nothing && first != nothing && body != first);
      first = body != nothing ? body : first;
    }
    if (two)
      for (const int corner : corners)
        torn[static_cast<std::size_t>(corner)] = 1;
  }
}

/// Frees contact nodes where one element hangs on two bodies that move apart: with all its corners
/// prescribed it would be inverted whatever the tissue around it does. Returns how many.
int release_torn_elements(MixedMesh& mesh)
{
  std::vector<char> torn(mesh.X.size(), 0);
  mark_torn(mesh, mesh.tets, torn);
  mark_torn(mesh, mesh.prisms, torn);
  int released = 0;
  for (std::size_t n = 0; n < torn.size(); ++n)
    if (torn[n] && (mesh.node_boundary[n] == Boundary::FixedBone ||
                    mesh.node_boundary[n] == Boundary::Fragment))
    {
      mesh.node_boundary[n] = Boundary::Free;
      mesh.node_fragment[n] = -1;
      ++released;
    }
  return released;
}

void count_contacts(const MixedMesh& mesh, ContactReport& report)
{
  for (std::size_t n = 0; n < mesh.X.size(); ++n)
    if (mesh.node_boundary[n] == Boundary::Fragment)
      ++report.fragments[static_cast<std::size_t>(mesh.node_fragment[n])];
    else if (mesh.node_boundary[n] == Boundary::FixedBone)
      ++report.fixed;
}

} // namespace

ContactReport assign_contacts(MixedMesh& mesh, const BonePartition& partition,
                              double release_margin_mm)
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
    }
  }
  report.released_between = release_torn_elements(mesh);
  count_contacts(mesh, report);
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
