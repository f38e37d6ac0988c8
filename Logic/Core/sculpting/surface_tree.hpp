#pragma once

#include "Core/geometry/vectors.hpp"

#include <limits>
#include <optional>

/// Where does a ray meet a surface, and what is the nearest place of it, while the surface changes?
namespace f2b
{

/// A place on a triangulated surface.
struct SurfacePlace
{
  int triangle = -1;
  Vec3 weights = Vec3::Zero(); ///< barycentric coordinates in the triangle
  Vec3 point = Vec3::Zero();   ///< [mm]
  double distance = 0;         ///< from what was asked for: along the ray, or to the point [mm]
};

/// A tree of boxes around a surface's triangles. Moving vertices only widens or shrinks boxes, so a
/// dab of the brush costs as much as what it touches.
class SurfaceTree
{
public:
  /// \param mesh  outlives the tree; its triangles do not change, its points may
  explicit SurfaceTree(const TriangleMesh& mesh);

  /// The first place that a ray meets, from either side of the surface.
  /// \param direction  unit
  std::optional<SurfacePlace>
  first_hit(const Vec3& origin, const Vec3& direction,
            double reach_mm = std::numeric_limits<double>::infinity()) const;
  /// The nearest place; the surface has at least one triangle.
  SurfacePlace nearest(const Vec3& point) const;

  /// To be called after points of these triangles have moved.
  void update(const std::vector<int>& triangles);

private:
  struct Node
  {
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();
    int parent = -1;
    int left = -1, right = -1; ///< -1: a leaf
    int first = 0, last = 0;   ///< of m_order
  };

  int build(int first, int last, int parent, const std::vector<Vec3>& centres);
  bool fit_leaf(Node& node) const;
  bool fit_parent(Node& node) const;
  const Vec3& corner(int triangle, std::size_t k) const;
  void hit_leaf(const Node& node, const Vec3& origin, const Vec3& direction,
                std::optional<SurfacePlace>& best, double& reach) const;

  const TriangleMesh& m_mesh;
  std::vector<Node> m_nodes;
  std::vector<int> m_order;               ///< triangles, leaf by leaf
  std::vector<Triangle> m_leaf_triangles; ///< in that order
  std::vector<int> m_leaf_of;             ///< per triangle
};

} // namespace f2b
