#pragma once

#include "Core/material/material_set.hpp"
#include "Core/mesh/mixed_mesh.hpp"

/// What force does linear elasticity put on each vertex, said without an assembled matrix?
namespace f2b
{

/// The tensors of the mass-tensor model: one per vertex and one per edge, so that the force of
/// displacements u is f_i = K_ii u_i + sum_j K_ij u_j over the edges of i, with
///
///   K_ij = sum over tetrahedra of V (lambda g_i g_j^T + mu g_j g_i^T + mu (g_i . g_j) 1),
///
/// g_i the gradient of vertex i's linear shape function and V the volume. Lame's constants are
/// those of each tissue's law at rest. Reference: S. Cotin, H. Delingette, N. Ayache, "A hybrid
/// elastic model for real-time cutting, deformations, and force feedback for surgery training and
/// simulation", The Visual Computer 16 (2000) 437, section 3.
class MassTensors
{
public:
  /// \param mesh  tetrahedra only (see split_prisms)
  MassTensors(const MixedMesh& mesh, const MaterialSet& materials);

  std::size_t vertex_count() const { return m_vertex.size(); }
  const Mat3& of_vertex(std::size_t i) const { return m_vertex[i]; } ///< [N/mm]
  /// Forces that displacements cost, dE/du [N]; the same bit for bit for every number of threads.
  /// \param u, f  one per vertex [mm, N]
  void forces(const std::vector<Vec3>& u, std::vector<Vec3>& f) const;

private:
  std::vector<Mat3> m_vertex;
  // Edges from each vertex; every edge stands at both its ends, K_ji = K_ij^T, so that a vertex
  // sums what is its own.
  std::vector<std::size_t> m_first_edge; ///< per vertex, and one past the last
  std::vector<int> m_neighbour;
  std::vector<Mat3> m_edge;
};

} // namespace f2b
