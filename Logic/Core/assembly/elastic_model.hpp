#pragma once

#include "Core/assembly/element_groups.hpp"
#include "Core/assembly/skin_springs.hpp"

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
               const std::vector<char>& prescribed);

  /// Adds the virtual external force to energy, forces and stiffness.
  /// \param springs  one per prism at most
  void set_springs(std::vector<SkinSpring> springs, const VirtualForceLaw& law);

  long unknown_count() const { return 3 * static_cast<long>(m_unknown_controls.size()); }
  /// Unknown control vectors, ascending; unknown 3 i + a is component a of control
  /// `unknown_controls()[i]`.
  const std::vector<int>& unknown_controls() const { return m_unknown_controls; }
  std::size_t control_count() const { return m_unknown_of_control.size(); }
  bool is_prescribed(int control) const
  {
    return m_unknown_of_control[static_cast<std::size_t>(control)] < 0;
  }

  /// Total energy at control vectors x [N mm]; infinite where a law has no answer, such as an
  /// element that is inverted at any quadrature point, averaged dilatation or not.
  double energy(const std::vector<Vec3>& x) const;
  /// Out-of-balance force dE/dx of the unknowns [N].
  Eigen::VectorXd forces(const std::vector<Vec3>& x) const;
  /// Forces as above; also refreshes `stiffness()` and what `coupling` needs.
  Eigen::VectorXd linearize(const std::vector<Vec3>& x, Tangent tangent = Tangent::Exact);
  /// The tangent of the unknowns at the last `linearize`.
  const SymmetricMatrix& stiffness() const { return m_stiffness; }
  /// Forces on the unknowns from a small motion of prescribed controls, by the last
  /// linearisation [N].
  /// \param motion  one change per control vector [mm]; those of unknowns are not used
  Eigen::VectorXd coupling(const std::vector<Vec3>& motion) const;

  /// det F at every quadrature point that must not invert, that is with a hyperelastic law; always
  /// in the same order.
  std::vector<double> dilatations(const std::vector<Vec3>& x) const;
  /// Smallest det F at any quadrature point, whatever the law: positive if no element is inverted.
  double smallest_dilatation(const std::vector<Vec3>& x) const;
  const ElementGroups& groups() const { return m_groups; }

private:
  void number_unknowns(const std::vector<char>& prescribed);
  template <class Visit>
  void for_each_spring(const Visit& visit) const;
  void add_spring_forces(const std::vector<Vec3>& x, std::vector<double>& slots) const;
  void add_spring_stiffness(const std::vector<Vec3>& x, Tangent tangent);
  bool moves(int control, const std::vector<Vec3>& motion) const;
  void add_element_coupling(const int* controls, int count, const double* blocks,
                            const std::vector<Vec3>& motion, Eigen::VectorXd& forces) const;
  void add_patch_coupling(const std::vector<Vec3>& motion, Eigen::VectorXd& forces) const;
  double spring_energy(const std::vector<Vec3>& x) const;

  const MaterialSet& m_materials;
  const std::vector<Vec3>& m_rest; ///< control vectors
  ElementGroups m_groups;
  std::vector<SkinSpring> m_springs;
  VirtualForceLaw m_spring_law;

  std::vector<int> m_unknown_controls;
  std::vector<int> m_unknown_of_control; ///< -1: prescribed
  Gather m_gather;
  std::vector<double> m_blocks; ///< element stiffnesses at the last `linearize`
  PatchStiffness m_patches;     ///< the same of patches
  SymmetricMatrix m_stiffness;
};

} // namespace f2b
