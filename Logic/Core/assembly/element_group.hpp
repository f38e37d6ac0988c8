#pragma once

#include "Core/element/quadrature_element.hpp"
#include "Core/mesh/mixed_mesh.hpp"

#include <algorithm>

/// Which elements are computed in one loop?
namespace f2b
{

/// Elements of one kind and one tissue, and where their results go.
///
/// Forces: one slot per control vector of an element, element by element. Stiffness: the blocks of
/// `block_index`, element by element. With averaged dilatation the elements form domains that share
/// one: a prism by itself, tetrahedra in patches, which are ranges of elements. A patch's rank-one
/// stiffness couples all its control vectors; it is kept as one vector per control vector in
/// patch slots.
template <class ElementKind>
struct ElementGroup
{
  using Element = ElementKind;
  static constexpr int corners = Element::corners;
  using Controls = std::array<int, corners>;

  Tissue tissue = Tissue::Skin;
  std::vector<Element> elements;
  std::vector<Controls> controls; ///< one per element
  long first_element = 0;         ///< of this group among all groups; so are the next three
  long first_slot = 0;
  long first_block = 0;
  long first_patch_slot = 0;

  bool averaged = false;
  std::vector<int> patch_start;      ///< of patches, into `elements`; empty for prisms
  std::vector<int> patch_control;    ///< per patch slot
  std::vector<int> patch_slot_start; ///< of patches, into `patch_control`
  std::vector<Controls> patch_slots; ///< per element, into `patch_control`

  long size() const { return static_cast<long>(elements.size()); }
  std::size_t slot(long e) const { return static_cast<std::size_t>(first_slot + e * corners); }
  std::size_t block(long e) const
  {
    return static_cast<std::size_t>(first_block + e * block_count(corners));
  }
  const Element& element(long e) const { return elements[static_cast<std::size_t>(e)]; }
  const Controls& controls_of(long e) const { return controls[static_cast<std::size_t>(e)]; }
  typename Element::Positions positions(const std::vector<Vec3>& x, long e) const
  {
    typename Element::Positions p;
    for (int i = 0; i < corners; ++i)
      p.col(i) = x[static_cast<std::size_t>(controls_of(e)[static_cast<std::size_t>(i)])];
    return p;
  }
  /// Mean position of an element's nodes; the slopes of a smooth prism are in its middle.
  Vec3 center(const std::vector<Vec3>& x, long e) const
  {
    const auto p = positions(x, e);
    if constexpr (corners == 4)
      return p.rowwise().mean();
    return (p.template leftCols<3>() + p.template rightCols<3>()).rowwise().sum() / 6;
  }

  long patch_count() const
  {
    return patch_start.empty() ? 0 : static_cast<long>(patch_start.size()) - 1;
  }
  /// First element of a patch; that of the next patch is its end.
  long patch_begin(long patch) const { return patch_start[static_cast<std::size_t>(patch)]; }
  /// First slot of a patch among the group's.
  std::size_t patch_slot_begin(long patch) const
  {
    return static_cast<std::size_t>(patch_slot_start[static_cast<std::size_t>(patch)]);
  }
  std::size_t patch_slot(long e, std::size_t corner) const
  {
    return static_cast<std::size_t>(patch_slots[static_cast<std::size_t>(e)][corner]);
  }
};

/// Gives every patch one slot per control vector that its elements use.
template <class Element>
void number_patch_slots(ElementGroup<Element>& group)
{
  group.patch_slots.resize(group.elements.size());
  group.patch_slot_start.assign(1, 0);
  for (long d = 0; d < group.patch_count(); ++d)
  {
    const auto begin = static_cast<std::ptrdiff_t>(group.patch_control.size());
    for (long e = group.patch_begin(d); e < group.patch_begin(d + 1); ++e)
      for (std::size_t i = 0; i < group.corners; ++i)
      {
        auto& all = group.patch_control;
        const int control = group.controls_of(e)[i];
        const auto found = std::find(all.begin() + begin, all.end(), control);
        group.patch_slots[static_cast<std::size_t>(e)][i] = static_cast<int>(found - all.begin());
        if (found == all.end())
          all.push_back(control);
      }
    group.patch_slot_start.push_back(static_cast<int>(group.patch_control.size()));
  }
}

} // namespace f2b
