#include "Meshing/surface_shells.hpp"

#include <numeric>

namespace f2b
{
namespace
{

double corner_volume(const TriangleMesh& mesh, const Triangle& t)
{
  // about a point of the mesh: a far origin costs digits
  const Vec3& o = mesh.points[0];
  const Vec3 a = mesh.points[static_cast<std::size_t>(t[0])] - o,
             b = mesh.points[static_cast<std::size_t>(t[1])] - o,
             c = mesh.points[static_cast<std::size_t>(t[2])] - o;
  return a.dot(b.cross(c)) / 6;
}

} // namespace

SurfaceShells surface_shells(const TriangleMesh& mesh)
{
  std::vector<int> parent(mesh.points.size());
  std::iota(parent.begin(), parent.end(), 0);
  auto root = [&](int p)
  {
    while (parent[static_cast<std::size_t>(p)] != p)
    {
      int& up = parent[static_cast<std::size_t>(p)];
      p = up = parent[static_cast<std::size_t>(up)];
    }
    return p;
  };
  for (const Triangle& t : mesh.triangles)
    for (const int corner : {t[1], t[2]})
      parent[static_cast<std::size_t>(root(corner))] = root(t[0]);
  SurfaceShells shells;
  shells.of.reserve(mesh.triangles.size());
  std::vector<int> number(mesh.points.size(), -1);
  for (const Triangle& t : mesh.triangles)
  {
    int& n = number[static_cast<std::size_t>(root(t[0]))];
    if (n < 0)
    {
      n = static_cast<int>(shells.volume.size());
      shells.volume.push_back(0);
    }
    shells.of.push_back(n);
    shells.volume[static_cast<std::size_t>(n)] += corner_volume(mesh, t);
  }
  return shells;
}

TriangleMesh submesh(const TriangleMesh& mesh, const std::vector<char>& wanted)
{
  TriangleMesh part;
  std::vector<int> number(mesh.points.size(), -1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (!wanted[t])
      continue;
    Triangle corners = mesh.triangles[t];
    for (int& corner : corners)
    {
      int& n = number[static_cast<std::size_t>(corner)];
      if (n < 0)
      {
        n = static_cast<int>(part.points.size());
        part.points.push_back(mesh.points[static_cast<std::size_t>(corner)]);
      }
      corner = n;
    }
    part.triangles.push_back(corners);
  }
  return part;
}

void append(TriangleMesh& mesh, const TriangleMesh& more)
{
  const int first = static_cast<int>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), more.points.begin(), more.points.end());
  for (const Triangle& t : more.triangles)
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

double signed_volume(const TriangleMesh& mesh)
{
  double sum = 0;
  for (const Triangle& t : mesh.triangles)
    sum += corner_volume(mesh, t);
  return sum;
}

} // namespace f2b
