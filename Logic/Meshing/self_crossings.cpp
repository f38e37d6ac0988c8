#include "Meshing/self_crossings.hpp"

#include "Meshing/cgal_surface.hpp"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_set>

namespace f2b
{
namespace
{

namespace PMP = CGAL::Polygon_mesh_processing;

/// Cells of a coarse lattice in which points have moved.
class MovedPlaces
{
public:
  explicit MovedPlaces(double cell_mm) : m_cell_mm(cell_mm) {}

  void add(const Vec3& p)
  {
    const Eigen::Vector3i c = cell(p);
    for (int k = -1; k <= 1; ++k)
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i)
          m_cells.insert(key(c + Eigen::Vector3i(i, j, k)));
  }
  bool near(const Vec3& p) const { return m_cells.count(key(cell(p))) > 0; }

private:
  Eigen::Vector3i cell(const Vec3& p) const
  {
    return (p / m_cell_mm).array().floor().matrix().cast<int>();
  }
  static std::int64_t key(const Eigen::Vector3i& c)
  {
    return ((std::int64_t(c.x()) * 2097152) + c.y()) * 2097152 + c.z();
  }
  double m_cell_mm;
  std::unordered_set<std::int64_t> m_cells;
};

double longest_edge(const TriangleMesh& mesh)
{
  double longest = 0;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t c = 0; c < 3; ++c)
      longest = std::max(longest, (mesh.points[static_cast<std::size_t>(t[c])] -
                                   mesh.points[static_cast<std::size_t>(t[(c + 1) % 3])])
                                      .norm());
  return longest;
}

/// The crossing triangles among some of a mesh.
std::vector<int> crossing_among(const TriangleMesh& mesh, const std::vector<int>& some)
{
  TriangleMesh part;
  part.points = mesh.points;
  for (const int t : some)
    part.triangles.push_back(mesh.triangles[static_cast<std::size_t>(t)]);
  std::vector<int> crossing;
  for (const int t : crossing_triangles(part))
    crossing.push_back(some[static_cast<std::size_t>(t)]);
  return crossing;
}

} // namespace

std::vector<int> crossing_triangles(const TriangleMesh& mesh)
{
  std::size_t refused = 0;
  std::vector<int> number;
  const CgalSurface surface = to_cgal(mesh, refused, &number);
  std::vector<std::pair<CgalSurface::Face_index, CgalSurface::Face_index>> pairs;
  PMP::self_intersections(surface, std::back_inserter(pairs));
  std::vector<int> crossing;
  for (const auto& [a, b] : pairs)
    for (const auto face : {a, b})
      crossing.push_back(number[face]);
  std::sort(crossing.begin(), crossing.end());
  crossing.erase(std::unique(crossing.begin(), crossing.end()), crossing.end());
  return crossing;
}

std::size_t yield_crossings(TriangleMesh& mesh, const std::vector<Vec3>& rest)
{
  std::vector<int> all(mesh.triangles.size());
  for (std::size_t t = 0; t < all.size(); ++t)
    all[t] = static_cast<int>(t);
  std::vector<char> back(mesh.points.size(), 0);
  std::vector<int> crossing = crossing_triangles(mesh);
  constexpr int most_rounds = 30; // each moves at least one point back for good
  for (int round = 0; !crossing.empty() && round < most_rounds; ++round)
  {
    std::vector<char> wanted(mesh.points.size(), 0);
    for (const int t : crossing)
      for (const int corner : mesh.triangles[static_cast<std::size_t>(t)])
        wanted[static_cast<std::size_t>(corner)] = 1;
    // from the second round on the neighbours too: the point that is in the way may be one of them
    for (int ring = 0; ring < round; ++ring)
    {
      const std::vector<char> inner = wanted;
      for (const Triangle& t : mesh.triangles)
        if (inner[static_cast<std::size_t>(t[0])] || inner[static_cast<std::size_t>(t[1])] ||
            inner[static_cast<std::size_t>(t[2])])
          for (const int corner : t)
            wanted[static_cast<std::size_t>(corner)] = 1;
    }
    MovedPlaces moved(std::max(longest_edge(mesh), 1e-3));
    bool any = false;
    for (std::size_t p = 0; p < wanted.size(); ++p)
      if (wanted[p] && !back[p])
      {
        back[p] = 1;
        moved.add(mesh.points[p]);
        moved.add(rest[p]);
        mesh.points[p] = rest[p];
        any = true;
      }
    std::vector<int> to_check;
    for (const int t : all)
      for (const int corner : mesh.triangles[static_cast<std::size_t>(t)])
        if (moved.near(mesh.points[static_cast<std::size_t>(corner)]))
        {
          to_check.push_back(t);
          break;
        }
    if (!any)
      break; // `rest` itself crosses there
    crossing = crossing_among(mesh, to_check);
  }
  return static_cast<std::size_t>(std::count(back.begin(), back.end(), 1));
}

} // namespace f2b
