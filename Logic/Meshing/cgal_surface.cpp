#include "Meshing/cgal_surface.hpp"

namespace f2b
{

CgalSurface to_cgal(const TriangleMesh& mesh, std::size_t& refused, std::vector<int>* number)
{
  CgalSurface surface;
  const auto n = static_cast<CgalSurface::size_type>(mesh.points.size()),
             m = static_cast<CgalSurface::size_type>(mesh.triangles.size());
  surface.reserve(n, 3 * m / 2, m);
  for (const Vec3& p : mesh.points)
    surface.add_vertex(CgalPoint(p.x(), p.y(), p.z()));
  auto vertex = [](int corner)
  { return CgalSurface::Vertex_index(static_cast<CgalSurface::size_type>(corner)); };
  refused = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const Triangle& c = mesh.triangles[t];
    if (surface.add_face(vertex(c[0]), vertex(c[1]), vertex(c[2])) == CgalSurface::null_face())
      ++refused;
    else if (number)
      number->push_back(static_cast<int>(t));
  }
  return surface;
}

TriangleMesh from_cgal(const CgalSurface& surface)
{
  TriangleMesh mesh;
  std::vector<int> number(surface.num_vertices() + surface.number_of_removed_vertices(), -1);
  for (const auto v : surface.vertices())
  {
    number[v] = static_cast<int>(mesh.points.size());
    const CgalPoint& p = surface.point(v);
    mesh.points.push_back({p.x(), p.y(), p.z()});
  }
  for (const auto f : surface.faces())
  {
    Triangle corners{};
    std::size_t c = 0;
    for (const auto v : surface.vertices_around_face(surface.halfedge(f)))
      corners[c++] = number[v];
    mesh.triangles.push_back(corners);
  }
  return mesh;
}

} // namespace f2b
