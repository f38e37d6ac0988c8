#pragma once

#include "Core/sculpting/surface_links.hpp"
#include "Core/sculpting/surface_tree.hpp"

/// Where is the skin now? The reference skin with its displacement and mask, and what follows from
/// them: points, normals and the tree that finds places on it.
namespace f2b
{

/// What sculpting changes about a vertex.
struct SkinVertex
{
  Vec3 displacement = Vec3::Zero(); ///< from the reference skin [mm]
  double mask = 0;                  ///< 1: protected, moves exactly 0

  bool operator==(const SkinVertex& other) const
  {
    return displacement == other.displacement && mask == other.mask;
  }
};

class SculptedSkin
{
public:
  /// \param reference     [mm, RAS], at least one triangle
  /// \param displacement  one per vertex, or empty: at rest
  /// Throws Error on unequal counts or values that are not finite.
  SculptedSkin(TriangleMesh reference, std::vector<Vec3> displacement);
  SculptedSkin(const SculptedSkin&) = delete;
  SculptedSkin& operator=(const SculptedSkin&) = delete;

  std::size_t size() const { return m_rest.size(); }
  const std::vector<Vec3>& rest() const { return m_rest; }
  const std::vector<Vec3>& displacement() const { return m_displacement; }
  const std::vector<double>& mask() const { return m_mask; }
  const std::vector<Vec3>& points() const { return m_mesh.points; }
  const std::vector<Triangle>& triangles() const { return m_mesh.triangles; }
  const std::vector<Vec3>& normals() const { return m_normals; } ///< outward, unit
  const SurfaceLinks& links() const { return m_links; }
  const SurfaceTree& tree() const { return m_tree; }

  SkinVertex vertex(int v) const
  {
    return {m_displacement[static_cast<std::size_t>(v)], m_mask[static_cast<std::size_t>(v)]};
  }
  /// Takes effect on points at once, on normals and tree with `settle`.
  void set(int v, const SkinVertex& state);
  /// \param moved  the vertices that were set since the last call
  void settle(const std::vector<int>& moved);

  /// The displacement at a place of the surface [mm].
  Vec3 displacement_at(const SurfacePlace& place) const;

private:
  void compute_triangle_normal(std::size_t t);
  void compute_normal(int v);

  TriangleMesh m_mesh;
  std::vector<Vec3> m_rest, m_displacement, m_normals;
  std::vector<Vec3> m_triangle_normals; ///< as long as twice the triangle's area
  std::vector<double> m_mask;
  SurfaceLinks m_links;
  SurfaceTree m_tree;
};

} // namespace f2b
