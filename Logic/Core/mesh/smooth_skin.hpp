#pragma once

#include "Core/element/smooth_prism.hpp"
#include "Core/mesh/mixed_mesh.hpp"

#include <utility>

/// Which slopes make the skin of a mesh smooth (paper eq. 5-6 on curved skin), and where can they
/// not?
namespace f2b
{

/// Tangents of one node of the face, at rest.
struct SkinTangents
{
  int node = -1;
  Vec3 normal; ///< unit, outwards
  /// Across the normal and each other, as long as the node's mean skin edge [mm]; the rest values
  /// of the node's two slope vectors.
  std::array<Vec3, 2> tangent;
};

/// Weights of the control vectors that a point of the face hangs on: sum_i weight[i] x[control[i]].
struct SurfaceWeights
{
  std::array<int, 9> control;
  Eigen::Matrix<double, 9, 1> weight;
};

/// Position [mm] and unit outward normal of the smooth face.
struct SurfacePoint
{
  Vec3 point;
  Vec3 normal;
};

/// Control vectors of a mesh with smooth skin: first the positions of all nodes, then two slope
/// vectors per node with tangents. At rest an edge's slope at its end is the edge's projection on
/// the tangent plane there.
///
/// Where a prism with curved edges would fold, its three edges become straight, in both prisms of
/// each: the slope functions of such an edge act on the difference of its ends. The prism is then
/// the linear one, its neighbours fit it, and affine fields stay exact.
class SmoothSkin
{
public:
  /// A prism folds if its Jacobian falls below this share of the straight-sided prism's mean.
  static constexpr double least_jacobian = 0.1;

  /// Throws if a prism is inside out even with straight edges. The mesh outlives the skin.
  explicit SmoothSkin(const MixedMesh& mesh);

  const MixedMesh& mesh() const { return m_mesh; }
  int control_count() const
  {
    return m_mesh.node_count() + 2 * static_cast<int>(m_tangents.size());
  }
  /// Nodes with slopes; slopes of entry i are controls node_count + 2 i and node_count + 2 i + 1.
  /// A node of which at least two edges are not straight and span the tangent plane has slopes.
  const std::vector<SkinTangents>& tangents() const { return m_tangents; }
  /// First of a node's two slope controls, or -1: the node has none.
  int slope_control(int node) const { return m_slope_control[static_cast<std::size_t>(node)]; }
  /// Rest values of all control vectors [mm].
  std::vector<Vec3> rest() const;

  /// Controls of a prism in the order of `SmoothPrism`. A corner without slopes has its node in
  /// their places; the element's functions are zero there.
  std::array<int, 12> controls(int prism) const;
  FaceMap face_map(int prism) const;
  /// The prism's element at rest; its controls are as above.
  SmoothPrism element(int prism) const;
  bool is_straight(int prism, int edge_opposite) const;

  /// Prisms that folded, ascending: all their edges are straight.
  const std::vector<int>& folded_prisms() const { return m_folded; }
  /// Straight edges as (lower node, higher node), ascending.
  const std::vector<std::pair<int, int>>& straight_edges() const { return m_straight; }

  /// \param L  area coordinates on corners 0-2, edges and corners included
  SurfaceWeights surface_weights(int prism, const Vec3& L) const;
  /// \param x  all control vectors [mm]
  SurfacePoint surface_point(int prism, const Vec3& L, const std::vector<Vec3>& x) const;

private:
  class Builder;
  Vec3 rest_of(int control) const;

  const MixedMesh& m_mesh;
  std::vector<SkinTangents> m_tangents;
  std::vector<int> m_slope_control; ///< per node
  std::vector<FaceSlopes> m_slopes; ///< per prism
  std::vector<int> m_folded;
  std::vector<std::pair<int, int>> m_straight;
};

/// The tangents of all nodes of the face at rest.
///
/// The normal is Max's (1999) mean of the facets', each weighted by its sine over the lengths of
/// its two edges: exact where a node and its neighbours lie on a sphere (weights by angle leave the
/// same creases within 2 %, on a sphere and on a head). Rim nodes have the mean of the facets that
/// exist.
std::vector<SkinTangents> skin_tangents(const MixedMesh& mesh);

} // namespace f2b
