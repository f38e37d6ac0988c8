#pragma once

#include "Core/assembly/discretization.hpp"
#include "Core/assembly/element_group.hpp"
#include "Core/assembly/gather.hpp"
#include "Core/element/smooth_prism.hpp"
#include "Core/material/material_set.hpp"

#include <tuple>

/// Which elements does a discretized mesh consist of?
namespace f2b
{

/// All elements of a discretization, in groups of one kind and tissue.
///
/// With averaged dilatation every prism has a mean dilatation of its own, and tetrahedra form
/// patches where their law is nearly incompressible; elsewhere they do not lock and stay plain.
class ElementGroups
{
public:
  /// Bulk over shear modulus from which tetrahedra form patches: Poisson's ratio 0.41.
  static constexpr double patched_from = 5;

  ElementGroups(const Discretization& tissue, const MaterialSet& materials);

  /// Calls visit(group) for every group, in a fixed order.
  template <class Visit>
  void for_each(const Visit& visit) const
  {
    std::apply([&](const auto&... kind) { (for_each_of(kind, visit), ...); }, m_kinds);
  }
  /// The same for prisms: one group at most, in the order of the mesh.
  template <class Visit>
  void for_each_of_prisms(const Visit& visit) const
  {
    for_each_of(std::get<1>(m_kinds), visit);
    for_each_of(std::get<2>(m_kinds), visit);
  }

  std::size_t element_count() const { return m_elements; }
  std::size_t slot_count() const { return m_slots; }
  std::size_t block_count() const { return m_blocks; }
  std::size_t patch_slot_count() const { return m_patch_slots; }

  std::vector<Clique> element_cliques() const;
  std::vector<Clique> patch_cliques() const;

private:
  template <class Groups, class Visit>
  static void for_each_of(Groups& groups, const Visit& visit)
  {
    for (auto& group : groups)
      visit(group);
  }
  void add_tets(const Discretization& tissue, const MaterialSet& materials, Tissue kind);
  void add_prisms(const Discretization& tissue);
  void add_smooth_prisms(const Discretization& tissue);
  void number();

  std::tuple<std::vector<ElementGroup<Tet4>>, std::vector<ElementGroup<Prism6>>,
             std::vector<ElementGroup<SmoothPrism>>>
      m_kinds;
  std::size_t m_elements = 0, m_slots = 0, m_blocks = 0, m_patch_slots = 0;
};

/// Calls visit(tissue, F, place, volume) for every quadrature point, one after the other: its
/// deformation gradient at x, the centre of its element at rest [mm], and its volume at rest [mm^3].
template <class Visit>
void visit_points(const ElementGroups& groups, const std::vector<Vec3>& rest,
                  const std::vector<Vec3>& x, const Visit& visit)
{
  groups.for_each(
      [&](const auto& group)
      {
        for (long e = 0; e < group.size(); ++e)
        {
          const auto& element = group.element(e);
          const auto positions = group.positions(x, e);
          const Vec3 center = group.center(rest, e);
          for (std::size_t q = 0; q < element.volumes.size(); ++q)
            visit(group.tissue, Mat3(positions * element.gradients[q]), center, element.volumes[q]);
        }
      });
}

} // namespace f2b
