#pragma once

#include "Meshing/tetrahedral_domain.hpp"

/// May a node of a tetrahedral mesh be moved, judging by the tetrahedra around it? mm, RAS.
namespace f2b
{

class TetStars
{
public:
  explicit TetStars(TetrahedralMesh& mesh);

  /// Least dihedral angle of the tetrahedra at a node [degrees]; negative when one is inverted.
  double least_angle_deg(int node) const;
  /// Moves the node unless an angle falls below the bound and below what it was.
  bool move(int node, const Vec3& position, double least_deg);

  const Vec3& position(int node) const { return m_mesh.X[node]; }

private:
  TetrahedralMesh& m_mesh;
  std::vector<int> m_first; ///< the tetrahedra of node n are m_around[m_first[n] .. m_first[n + 1])
  std::vector<int> m_around;
};

/// Gives every face-connected set of tetrahedra at a node a node of its own, so that parts do not
/// touch in a single node or edge. Returns how many nodes were added.
int split_pinched_nodes(TetrahedralMesh& mesh);

/// Keeps the largest face-connected set of tetrahedra; returns how many were dropped.
int keep_largest_component(TetrahedralMesh& mesh);

} // namespace f2b
