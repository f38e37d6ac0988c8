#pragma once

#include "Core/assembly/skin_springs.hpp"
#include "Core/element/quadrature_element.hpp"
#include "Core/material/material_set.hpp"
#include "Core/solve/cholesky.hpp"

/// What are the energy, the forces and the tangent stiffness of the whole mesh?
namespace f2b
{

/// Assembles a discretized mesh with its materials, and optionally the pull of skin springs.
///
/// Sums are made in an order that does not depend on the number of threads, so results are the
/// same bit for bit. The discretization and the materials outlive the model.
class ElasticModel
{
public:
  /// \param prescribed  one flag per control vector: it is given, the others are unknown
  ElasticModel(const Discretization& tissue, const MaterialSet& materials,
               std::vector<char> prescribed);

  /// Adds springs of stiffness K_e [N/mm^3] to energy, forces and stiffness.
  void set_springs(std::vector<SkinSpring> springs, double stiffness);

  long unknown_count() const { return 3 * static_cast<long>(m_unknown_nodes.size()); }
  /// Unknown control vectors; unknown 3 i + a is component a of control `unknown_controls()[i]`.
  const std::vector<int>& unknown_controls() const { return m_unknown_nodes; }
  bool is_prescribed(int control) const
  {
    return m_unknown_of_node[static_cast<std::size_t>(control)] < 0;
  }

  /// Total energy at positions x [N mm]; infinite if an element is inverted at a quadrature point.
  double energy(const std::vector<Vec3>& x) const;
  /// Out-of-balance force dE/dx of the unknowns [N].
  Eigen::VectorXd forces(const std::vector<Vec3>& x) const;
  /// Forces as above; also refreshes `stiffness()` and the element stiffnesses kept for `coupling`.
  Eigen::VectorXd linearize(const std::vector<Vec3>& x);
  /// The tangent of the unknowns at the last `linearize`.
  const SymmetricMatrix& stiffness() const { return m_stiffness; }
  /// Forces on the unknowns from a small motion of prescribed controls, by the last linearisation [N].
  /// \param motion  one change per control vector [mm]; those of unknowns are not used
  Eigen::VectorXd coupling(const std::vector<Vec3>& motion) const;

private:
  void build_pattern();
  void gather_stiffness();
  Eigen::VectorXd gather_forces(const std::vector<double>& corner_forces) const;

  const MixedMesh& m_mesh;
  const MaterialSet& m_materials;
  std::vector<Tet4> m_tets;
  std::vector<Prism6> m_prisms;
  std::vector<SkinSpring> m_springs;
  double m_spring_stiffness = 0;

  std::vector<int> m_unknown_nodes;
  std::vector<int> m_unknown_of_node; ///< -1: prescribed

  // Corner slots: 4 per tet, then 6 per prism (top corners carry the springs too).
  std::vector<long> m_node_slot_start; ///< per unknown node, into m_node_slots
  std::vector<long> m_node_slots;
  // Element stiffness blocks: tets 12 x 12, then prisms 18 x 18, column-major.
  std::vector<double> m_blocks;
  std::vector<long> m_pair_start;  ///< per node pair of the pattern, into m_pair_blocks
  std::vector<long> m_pair_blocks; ///< offset of the first entry of a 3 x 3 block; low bit: prism
  std::vector<int> m_pair_row, m_pair_column;
  std::vector<long> m_pair_value; ///< offset of the pair's first column in m_stiffness.value
  SymmetricMatrix m_stiffness;
};

} // namespace f2b
