#include "Core/assembly/element_loops.hpp"

#include "Core/element/mean_dilatation.hpp"
#include "Core/element/smooth_prism.hpp"
#include "Core/material/positive_tangent.hpp"

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

/// The change of volume that the elements of a domain share.
template <class L, class Element>
struct Domain
{
  Domain(const ElementGroup<Element>& group, const std::vector<Vec3>& x, long index)
      : begin(group.domain_begin(index)), end(group.domain_begin(index + 1))
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

/// Calls visit(e, law of its points) for every element of the group, in parallel.
template <class L, class Element, class Visit>
void for_each_element(const ElementGroup<Element>& group, const L& law, const std::vector<Vec3>& x,
                      const Visit& visit)
{
  if (!group.averaged)
  {
#pragma omp parallel for schedule(static)
    for (long e = 0; e < group.size(); ++e)
      visit(e, law);
    return;
  }
#pragma omp parallel for schedule(static)
  for (long d = 0; d < group.domain_count(); ++d)
  {
    const Domain<L, Element> domain(group, x, d);
    const AveragedPoint<L> point{law, AveragedPoint<L>::volume_slope(law, domain.dilatation)};
    for (long e = domain.begin; e < domain.end; ++e)
      visit(e, point);
  }
}

/// Adds the energies of averaged dilatations to those of the domains' first elements.
template <class L, class Element>
void add_volume_energies(const ElementGroup<Element>& group, const L& law,
                         const std::vector<Vec3>& x, double* parts)
{
  if (!group.averaged)
    return;
#pragma omp parallel for schedule(static)
  for (long d = 0; d < group.domain_count(); ++d)
  {
    const Domain<L, Element> domain(group, x, d);
    parts[domain.begin] += domain.volume * AveragedPoint<L>::volume_energy(law, domain.dilatation);
  }
}

/// Adds c g g^T to the lower half of an element's stiffness.
template <class Positions>
void add_rank_one(const Positions& g, double c, double* stiffness)
{
  constexpr int n = Positions::ColsAtCompileTime;
  for (int b = 0; b < n; ++b)
    for (int a = b; a < n; ++a)
      Eigen::Map<Mat3>(stiffness + 9 * block_index(n, a, b)) += c * g.col(a) * g.col(b).transpose();
}

template <class L, class Element>
void set_patch_stiffness(const ElementGroup<Element>& group, const std::vector<Vec3>& x,
                         const Domain<L, Element>& domain, long index, double c,
                         PatchStiffness& patches)
{
  const auto d = static_cast<std::size_t>(index);
  const auto first = static_cast<std::size_t>(group.first_patch_slot);
  for (int s = group.patch_slot_start[d]; s < group.patch_slot_start[d + 1]; ++s)
    patches.slope[first + static_cast<std::size_t>(s)].setZero();
  for (long e = domain.begin; e < domain.end; ++e)
  {
    const auto g = dilated_volume_slope<L>(group.element(e), group.positions(x, e));
    for (int i = 0; i < group.corners; ++i)
    {
      const int slot = group.patch_slots[static_cast<std::size_t>(e)][static_cast<std::size_t>(i)];
      patches.slope[first + static_cast<std::size_t>(slot)] += g.col(i);
    }
  }
  for (int s = group.patch_slot_start[d]; s < group.patch_slot_start[d + 1]; ++s)
    patches.scaled[first + static_cast<std::size_t>(s)] =
        c * patches.slope[first + static_cast<std::size_t>(s)];
}

/// The rank-one stiffness of averaged dilatations.
template <class L, class Element>
void add_volume_stiffness(const ElementGroup<Element>& group, const L& law, Tangent tangent,
                          const std::vector<Vec3>& x, std::vector<double>& blocks,
                          PatchStiffness& patches)
{
  if (!group.averaged)
    return;
#pragma omp parallel for schedule(static)
  for (long d = 0; d < group.domain_count(); ++d)
  {
    const Domain<L, Element> domain(group, x, d);
    double c = AveragedPoint<L>::volume_curvature(law, domain.dilatation) / domain.volume;
    if (tangent == Tangent::Positive)
      c = std::max(c, 0.0);
    if (group.in_patches())
      set_patch_stiffness(group, x, domain, d, c, patches);
    else
      add_rank_one(dilated_volume_slope<L>(group.element(d), group.positions(x, d)), c,
                   &blocks[9 * group.block(d)]);
  }
}

} // namespace

template <class Element>
void ElementLoops<Element>::energies(const Group& group, const Law& law, const std::vector<Vec3>& x,
                                     double* parts)
{
  auto with_law = [&](const auto& l)
  {
    for_each_element(group, l, x,
                     [&](long e, const auto& point) {
                       parts[e] = element_energy(group.element(e), group.positions(x, e), point);
                     });
    add_volume_energies(group, l, x, parts);
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
    for_each_element(group, l, x,
                     [&](long e, const auto& point)
                     {
                       matrix_at<Positions>(slots, 3 * group.slot(e)) =
                           element_forces(group.element(e), group.positions(x, e), point);
                     });
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
    for_each_element(group, l, x,
                     [&](long e, const auto& point)
                     {
                       using Point = std::decay_t<decltype(point)>;
                       double* K = &blocks[9 * group.block(e)];
                       const Positions p = group.positions(x, e);
                       matrix_at<Positions>(slots, 3 * group.slot(e)) =
                           tangent == Tangent::Exact
                               ? element_forces(group.element(e), p, point, K)
                               : element_forces(group.element(e), p, PositiveTangent<Point>{point},
                                                K);
                     });
    add_volume_stiffness(group, l, tangent, x, blocks, patches);
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
