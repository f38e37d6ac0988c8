#include "Core/assembly/element_loops.hpp"

#include "Core/element/positive_blocks.hpp"
#include "Core/element/prism_levels.hpp"
#include "Core/element/smooth_prism.hpp"

#include <limits>

namespace f2b
{
namespace
{

/// A matrix that lies in a vector of numbers.
template <class Matrix>
Eigen::Map<Matrix> matrix_at(std::vector<double>& numbers, std::size_t offset)
{
  return Eigen::Map<Matrix>(numbers.data() + offset);
}

/// The change of volume that the tetrahedra of a patch share.
template <class L>
struct Patch
{
  Patch(const ElementGroup<Tet4>& group, const std::vector<Vec3>& x, long index)
      : begin(group.patch_begin(index)), end(group.patch_begin(index + 1))
  {
    double now = 0;
    for (long e = begin; e < end; ++e)
    {
      volume += rest_volume(group.element(e));
      now += dilated_volume<L>(group.element(e), group.positions(x, e));
    }
    dilatation = now / volume;
  }
  long begin, end;   ///< elements
  double volume = 0; ///< at rest [mm^3]
  double dilatation = 1;
};

/// Calls visit(e, law of its points) for every tetrahedron of the patches, in parallel.
template <Asked, class L, class Visit>
void for_each_averaged(const ElementGroup<Tet4>& group, const L& law, const std::vector<Vec3>& x,
                       const Visit& visit)
{
#pragma omp parallel for schedule(static)
  for (long p = 0; p < group.patch_count(); ++p)
  {
    const Patch<L> patch(group, x, p);
    const AveragedPoint<L> point{law, DilatationSplit<L>::volume_slope(law, patch.dilatation)};
    for (long e = patch.begin; e < patch.end; ++e)
      visit(e, point);
  }
}

/// The same for every prism of the group.
template <Asked asked, class L, class Prism, class Visit>
void for_each_averaged(const ElementGroup<Prism>& group, const L& law, const std::vector<Vec3>& x,
                       const Visit& visit)
{
#pragma omp parallel for schedule(static)
  for (long e = 0; e < group.size(); ++e)
  {
    const typename Prism::Positions positions = group.positions(x, e);
    visit(e, PrismLevels<L, Prism, asked>(group.element(e), positions, law));
  }
}

/// Calls visit(e, law of its points) for every element of the group, in parallel.
template <Asked asked, class L, class Element, class Visit>
void for_each_element(const ElementGroup<Element>& group, const L& law, const std::vector<Vec3>& x,
                      const Visit& visit)
{
  if (group.averaged)
    return for_each_averaged<asked>(group, law, x, visit);
#pragma omp parallel for schedule(static)
  for (long e = 0; e < group.size(); ++e)
    visit(e, law);
}

/// What the point laws of an element leave out of its energy: nothing but for prisms' own means.
template <class PointLaw>
double energy_beyond_points(const PointLaw&)
{
  return 0;
}
template <class L, class Prism>
double energy_beyond_points(const PrismLevels<L, Prism, Asked::Energy>& levels)
{
  return levels.volume_energy();
}

/// Stiffness of an element, with its forces as the result.
template <class Element, class PointLaw>
typename Element::Positions
full_stiffness(const Element& element, const typename Element::Positions& x, const PointLaw& point,
               Tangent tangent, double* stiffness)
{
  return element_forces(element, x, point, stiffness, tangent == Tangent::Positive);
}
template <class Element, class L>
typename Element::Positions full_stiffness(const Element& element,
                                           const typename Element::Positions& x,
                                           const PrismLevels<L, Element, Asked::Stiffness>& levels,
                                           Tangent tangent, double* stiffness)
{
  const typename Element::Positions forces = element_forces(element, x, levels, stiffness);
  levels.add_stiffness(stiffness);
  if (tangent == Tangent::Positive)
    make_positive(stiffness, Element::corners);
  return forces;
}

/// Adds the patches' energies to those of their first tetrahedra.
template <class L>
void add_patch_energies(const ElementGroup<Tet4>& group, const L& law, const std::vector<Vec3>& x,
                        double* parts)
{
#pragma omp parallel for schedule(static)
  for (long p = 0; p < group.patch_count(); ++p)
  {
    const Patch<L> patch(group, x, p);
    parts[patch.begin] += patch.volume * DilatationSplit<L>::volume_energy(law, patch.dilatation);
  }
}

/// The rank-one stiffness of the patches.
template <class L>
void compute_patch_stiffness(const ElementGroup<Tet4>& group, const L& law, Tangent tangent,
                             const std::vector<Vec3>& x, PatchStiffness& patches)
{
  const auto first = static_cast<std::size_t>(group.first_patch_slot);
#pragma omp parallel for schedule(static)
  for (long p = 0; p < group.patch_count(); ++p)
  {
    const Patch<L> patch(group, x, p);
    double c = DilatationSplit<L>::volume_curvature(law, patch.dilatation) / patch.volume;
    if (tangent == Tangent::Positive)
      c = std::max(c, 0.0);
    const std::size_t begin = first + group.patch_slot_begin(p);
    const std::size_t end = first + group.patch_slot_begin(p + 1);
    for (std::size_t slot = begin; slot < end; ++slot)
      patches.slope[slot].setZero();
    for (long e = patch.begin; e < patch.end; ++e)
    {
      const auto g = dilated_volume_slope<L>(group.element(e), group.positions(x, e));
      for (std::size_t i = 0; i < 4; ++i)
        patches.slope[first + group.patch_slot(e, i)] += g.col(static_cast<Eigen::Index>(i));
    }
    for (std::size_t slot = begin; slot < end; ++slot)
      patches.scaled[slot] = c * patches.slope[slot];
  }
}

} // namespace

template <class Element>
void ElementLoops<Element>::energies(const Group& group, const Law& law, const std::vector<Vec3>& x,
                                     double* parts)
{
  auto with_law = [&](const auto& l)
  {
    auto set_energy = [&](long e, const auto& point)
    {
      parts[e] = energy_beyond_points(point) +
                 element_energy(group.element(e), group.positions(x, e), point);
    };
    for_each_element<Asked::Energy>(group, l, x, set_energy);
    if constexpr (std::is_same_v<Element, Tet4>)
      add_patch_energies(group, l, x, parts);
  };
  std::visit(with_law, law);
}

template <class Element>
void ElementLoops<Element>::forces(const Group& group, const Law& law, const std::vector<Vec3>& x,
                                   std::vector<double>& slots)
{
  using Positions = typename Element::Positions;
  auto with_law = [&](const auto& l)
  {
    auto set_forces = [&](long e, const auto& point)
    {
      matrix_at<Positions>(slots, 3 * group.slot(e)) =
          element_forces(group.element(e), group.positions(x, e), point);
    };
    for_each_element<Asked::Forces>(group, l, x, set_forces);
  };
  std::visit(with_law, law);
}

template <class Element>
void ElementLoops<Element>::stiffness(const Group& group, const Law& law, Tangent tangent,
                                      const std::vector<Vec3>& x, std::vector<double>& slots,
                                      std::vector<double>& blocks, PatchStiffness& patches)
{
  using Positions = typename Element::Positions;
  auto with_law = [&](const auto& l)
  {
    auto set_stiffness = [&](long e, const auto& point)
    {
      matrix_at<Positions>(slots, 3 * group.slot(e)) =
          full_stiffness(group.element(e), group.positions(x, e), point, tangent,
                         &blocks[9 * group.block(e)]);
    };
    for_each_element<Asked::Stiffness>(group, l, x, set_stiffness);
    if constexpr (std::is_same_v<Element, Tet4>)
      compute_patch_stiffness(group, l, tangent, x, patches);
  };
  std::visit(with_law, law);
}

template <class Element>
void ElementLoops<Element>::determinants(const Group& group, const std::vector<Vec3>& x,
                                         double* values)
{
#pragma omp parallel for schedule(static)
  for (long e = 0; e < group.size(); ++e)
  {
    const auto positions = group.positions(x, e);
    for (std::size_t q = 0; q < Element::points; ++q)
    {
      const Mat3 F = positions * group.element(e).gradients[q];
      values[e * Element::points + static_cast<long>(q)] = F.determinant();
    }
  }
}

template <class Element>
double ElementLoops<Element>::smallest_determinant(const Group& group, const std::vector<Vec3>& x)
{
  double smallest = std::numeric_limits<double>::infinity();
#pragma omp parallel for schedule(static) reduction(min : smallest)
  for (long e = 0; e < group.size(); ++e)
    for (const auto& gradients : group.element(e).gradients)
    {
      const Mat3 F = group.positions(x, e) * gradients;
      smallest = std::min(smallest, F.determinant());
    }
  return smallest;
}

template struct ElementLoops<Tet4>;
template struct ElementLoops<Prism6>;
template struct ElementLoops<SmoothPrism>;

} // namespace f2b
