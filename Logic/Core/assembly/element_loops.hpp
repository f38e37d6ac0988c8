#pragma once

#include "Core/assembly/element_group.hpp"
#include "Core/material/law.hpp"

/// What do all elements of a group contribute?
namespace f2b
{

/// Which stiffness does a linearisation give?
enum class Tangent
{
  Exact,    ///< d2E/dx2
  Positive, ///< from point tangents made positive semi-definite: never indefinite
};

/// The rank-one stiffness of patches: c g g^T, by slots of control vectors.
struct PatchStiffness
{
  std::vector<Vec3> slope;  ///< g = d(patch volume)/dx [mm^2]
  std::vector<Vec3> scaled; ///< c g, c = U''/(volume at rest) [N/mm^3]
};

/// All of these run in parallel and write every result to a place of its own. The law is looked up
/// once a call; the loops are compiled for each law and kind of element.
template <class Element>
struct ElementLoops
{
  using Group = ElementGroup<Element>;

  /// \param[out] parts  one energy per element [N mm]
  static void energies(const Group& group, const Law& law, const std::vector<Vec3>& x,
                       double* parts);
  /// \param[out] slots  3 numbers per slot of all groups [N]
  static void forces(const Group& group, const Law& law, const std::vector<Vec3>& x,
                     std::vector<double>& slots);
  /// \param[out] slots    as above
  /// \param[out] blocks   9 numbers per block of all groups [N/mm]
  /// \param[out] patches  of all groups
  static void stiffness(const Group& group, const Law& law, Tangent tangent,
                        const std::vector<Vec3>& x, std::vector<double>& slots,
                        std::vector<double>& blocks, PatchStiffness& patches);
  /// det F at the group's quadrature points, element by element.
  static void determinants(const Group& group, const std::vector<Vec3>& x, double* values);
  /// Smallest det F at the group's quadrature points.
  static double smallest_determinant(const Group& group, const std::vector<Vec3>& x);
};

} // namespace f2b
