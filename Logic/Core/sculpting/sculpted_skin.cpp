#include "Core/sculpting/sculpted_skin.hpp"

#include "Core/error.hpp"

#include <utility>

namespace f2b
{
namespace
{

/// The reference moved by the displacement, both checked.
TriangleMesh displaced(TriangleMesh mesh, const std::vector<Vec3>& displacement)
{
  if (mesh.triangles.empty())
    throw Error("skin", "it has no triangles", "segment the CT first");
  if (!displacement.empty() && displacement.size() != mesh.points.size())
    throw Error("target displacement",
                "it has " + std::to_string(displacement.size()) + " vectors, the skin " +
                    std::to_string(mesh.points.size()) + " vertices",
                "make the target anew on this skin");
  for (std::size_t v = 0; v < displacement.size(); ++v)
  {
    if (!displacement[v].allFinite())
      throw Error("target displacement", "that of vertex " + std::to_string(v) + " is not finite",
                  "make the target anew on this skin");
    mesh.points[v] += displacement[v];
  }
  return mesh;
}

} // namespace

SculptedSkin::SculptedSkin(TriangleMesh reference, std::vector<Vec3> displacement)
    : m_mesh(displaced(reference, displacement)), m_rest(std::move(reference.points)),
      m_displacement(std::move(displacement)), m_normals(m_rest.size(), Vec3::Zero()),
      m_triangle_normals(m_mesh.triangles.size()), m_mask(m_rest.size(), 0.0),
      m_links(m_rest.size(), m_mesh.triangles), m_tree(m_mesh)
{
  m_displacement.resize(m_rest.size(), Vec3::Zero());
  for (std::size_t t = 0; t < m_triangle_normals.size(); ++t)
    compute_triangle_normal(t);
  for (std::size_t v = 0; v < size(); ++v)
    compute_normal(static_cast<int>(v));
}

void SculptedSkin::compute_triangle_normal(std::size_t t)
{
  const Triangle& c = m_mesh.triangles[t];
  const Vec3& a = points()[static_cast<std::size_t>(c[0])];
  m_triangle_normals[t] = (points()[static_cast<std::size_t>(c[1])] - a)
                              .cross(points()[static_cast<std::size_t>(c[2])] - a);
}

/// Mean of the triangles' normals, weighted by area.
void SculptedSkin::compute_normal(int v)
{
  Vec3 sum = Vec3::Zero();
  for (const int t : m_links.triangles_of(v))
    sum += m_triangle_normals[static_cast<std::size_t>(t)];
  const double length = sum.norm();
  m_normals[static_cast<std::size_t>(v)] = length > 0 ? Vec3(sum / length) : Vec3(Vec3::Zero());
}

void SculptedSkin::set(int v, const SkinVertex& state)
{
  const auto i = static_cast<std::size_t>(v);
  m_displacement[i] = state.displacement;
  m_mask[i] = state.mask;
  m_mesh.points[i] = m_rest[i] + state.displacement;
}

void SculptedSkin::settle(const std::vector<int>& moved)
{
  // marks, not sorting: a large brush moves half the face
  std::vector<char> is_changed(m_mesh.triangles.size(), 0), is_near(m_mesh.points.size(), 0);
  std::vector<int> triangles;
  for (const int v : moved)
    for (const int t : m_links.triangles_of(v))
      if (!std::exchange(is_changed[static_cast<std::size_t>(t)], 1))
      {
        triangles.push_back(t);
        compute_triangle_normal(static_cast<std::size_t>(t));
      }
  for (const int t : triangles)
    for (const int v : m_mesh.triangles[static_cast<std::size_t>(t)])
      if (!std::exchange(is_near[static_cast<std::size_t>(v)], 1))
        compute_normal(v);
  m_tree.update(triangles);
}

Vec3 SculptedSkin::displacement_at(const SurfacePlace& place) const
{
  const Triangle& t = m_mesh.triangles[static_cast<std::size_t>(place.triangle)];
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < 3; ++k)
    sum +=
        place.weights[k] * m_displacement[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])];
  return sum;
}

} // namespace f2b
