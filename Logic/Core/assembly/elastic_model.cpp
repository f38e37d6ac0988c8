#include "Core/assembly/elastic_model.hpp"

#include <limits>
#include <numeric>

namespace f2b
{
namespace
{

/// How far the control vectors that a spring pulls are from rest.
SkinSpring::Controls pulled(const SkinSpring& spring, const int* controls,
                            const std::vector<Vec3>& rest, const std::vector<Vec3>& x)
{
  SkinSpring::Controls u = SkinSpring::Controls::Zero();
  for (int i = 0; i < spring.count; ++i)
  {
    const auto control = static_cast<std::size_t>(controls[i]);
    u.col(i) = x[control] - rest[control];
  }
  return u;
}

std::vector<char> used_controls(const ElementGroups& groups, std::size_t count)
{
  std::vector<char> used(count, 0);
  groups.for_each(
      [&](const auto& group)
      {
        for (const auto& controls : group.controls)
          for (const int control : controls)
            used[static_cast<std::size_t>(control)] = 1;
      });
  return used;
}

} // namespace

ElasticModel::ElasticModel(const Discretization& tissue, const MaterialSet& materials,
                           const std::vector<char>& prescribed)
    : m_materials(materials), m_rest(tissue.rest()), m_groups(tissue, materials)
{
  number_unknowns(prescribed);
  m_gather = Gather(m_groups.element_cliques(), m_groups.patch_cliques(), m_unknown_of_control,
                    static_cast<long>(m_unknown_controls.size()));
  m_stiffness = m_gather.empty_matrix();
  m_blocks.resize(9 * m_groups.block_count());
  m_patches.slope.resize(m_groups.patch_slot_count());
  m_patches.scaled.resize(m_groups.patch_slot_count());
}

/// A control vector that no element uses has no stiffness: it stays where it is.
void ElasticModel::number_unknowns(const std::vector<char>& prescribed)
{
  const std::vector<char> used = used_controls(m_groups, prescribed.size());
  m_unknown_of_control.assign(prescribed.size(), -1);
  for (std::size_t control = 0; control < prescribed.size(); ++control)
    if (!prescribed[control] && used[control])
    {
      m_unknown_of_control[control] = static_cast<int>(m_unknown_controls.size());
      m_unknown_controls.push_back(static_cast<int>(control));
    }
}

void ElasticModel::set_springs(std::vector<SkinSpring> springs, const VirtualForceLaw& law)
{
  m_springs = std::move(springs);
  m_spring_law = law;
}

/// Calls visit(index of a spring, the element group of its prism) in parallel: a prism has one
/// spring at most.
template <class Visit>
void ElasticModel::for_each_spring(const Visit& visit) const
{
  const auto count = static_cast<long>(m_springs.size());
  m_groups.for_each_of_prisms(
      [&](const auto& group)
      {
#pragma omp parallel for schedule(static)
        for (long s = 0; s < count; ++s)
          visit(static_cast<std::size_t>(s), group);
      });
}

double ElasticModel::energy(const std::vector<Vec3>& x) const
{
  std::vector<double> parts(m_groups.element_count());
  m_groups.for_each(
      [&](const auto& group)
      {
        using Group = std::decay_t<decltype(group)>;
        ElementLoops<typename Group::Element>::energies(group, m_materials.of(group.tissue), x,
                                                        parts.data() + group.first_element);
      });
  double total = spring_energy(x);
  for (const double part : parts)
    total += part;
  return total;
}

double ElasticModel::spring_energy(const std::vector<Vec3>& x) const
{
  std::vector<double> parts(m_springs.size(), 0.0);
  for_each_spring(
      [&](std::size_t s, const auto& group)
      {
        const SkinSpring& spring = m_springs[s];
        const int* controls = group.controls_of(spring.prism).data();
        parts[s] = spring.energy(m_spring_law, pulled(spring, controls, m_rest, x));
      });
  return std::accumulate(parts.begin(), parts.end(), 0.0);
}

void ElasticModel::add_spring_forces(const std::vector<Vec3>& x, std::vector<double>& slots) const
{
  for_each_spring(
      [&](std::size_t s, const auto& group)
      {
        const SkinSpring& spring = m_springs[s];
        const int* controls = group.controls_of(spring.prism).data();
        const auto f = spring.gradient(m_spring_law, pulled(spring, controls, m_rest, x));
        double* slot = &slots[3 * group.slot(spring.prism)];
        for (int i = 0; i < spring.count; ++i)
          Eigen::Map<Vec3>(slot + 3L * i) += f.col(i);
      });
}

void ElasticModel::add_spring_stiffness(const std::vector<Vec3>& x, Tangent tangent)
{
  for_each_spring(
      [&](std::size_t s, const auto& group)
      {
        const SkinSpring& spring = m_springs[s];
        const int* controls = group.controls_of(spring.prism).data();
        double* blocks = &m_blocks[9 * group.block(spring.prism)];
        spring.add_hessian(m_spring_law, pulled(spring, controls, m_rest, x), tangent,
                           [&](int a, int b)
                           { return blocks + 9L * block_index(group.corners, a, b); });
      });
}

Eigen::VectorXd ElasticModel::forces(const std::vector<Vec3>& x) const
{
  std::vector<double> slots(3 * m_groups.slot_count());
  m_groups.for_each(
      [&](const auto& group)
      {
        using Group = std::decay_t<decltype(group)>;
        ElementLoops<typename Group::Element>::forces(group, m_materials.of(group.tissue), x,
                                                      slots);
      });
  add_spring_forces(x, slots);
  return m_gather.forces(slots);
}

Eigen::VectorXd ElasticModel::linearize(const std::vector<Vec3>& x, Tangent tangent)
{
  std::vector<double> slots(3 * m_groups.slot_count());
  m_groups.for_each(
      [&](const auto& group)
      {
        using Group = std::decay_t<decltype(group)>;
        ElementLoops<typename Group::Element>::stiffness(group, m_materials.of(group.tissue),
                                                         tangent, x, slots, m_blocks, m_patches);
      });
  add_spring_forces(x, slots);
  add_spring_stiffness(x, tangent);
  m_gather.stiffness(m_blocks, m_patches, m_stiffness);
  return m_gather.forces(slots);
}

Eigen::VectorXd ElasticModel::coupling(const std::vector<Vec3>& motion) const
{
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(unknown_count());
  m_groups.for_each(
      [&](const auto& group)
      {
        for (long e = 0; e < group.size(); ++e)
          add_element_coupling(group.controls_of(e).data(), group.corners,
                               &m_blocks[9 * group.block(e)], motion, forces);
      });
  add_patch_coupling(motion, forces);
  return forces;
}

bool ElasticModel::moves(int control, const std::vector<Vec3>& motion) const
{
  return is_prescribed(control) && !motion[static_cast<std::size_t>(control)].isZero(0);
}

void ElasticModel::add_element_coupling(const int* controls, int count, const double* blocks,
                                        const std::vector<Vec3>& motion,
                                        Eigen::VectorXd& forces) const
{
  for (int b = 0; b < count; ++b)
  {
    if (!moves(controls[b], motion))
      continue;
    const Vec3& u = motion[static_cast<std::size_t>(controls[b])];
    for (int a = 0; a < count; ++a)
    {
      const int row = m_unknown_of_control[static_cast<std::size_t>(controls[a])];
      if (row < 0)
        continue;
      const Eigen::Map<const Mat3> K(
          blocks + 9 * (a >= b ? block_index(count, a, b) : block_index(count, b, a)));
      if (a >= b)
        forces.segment<3>(3L * row) += K * u;
      else
        forces.segment<3>(3L * row) += K.transpose() * u;
    }
  }
}

void ElasticModel::add_patch_coupling(const std::vector<Vec3>& motion,
                                      Eigen::VectorXd& forces) const
{
  std::size_t first = 0; // slot of a patch
  for (const Clique& patch : m_groups.patch_cliques())
  {
    double growth = 0; // of the patch's volume
    for (int i = 0; i < patch.count; ++i)
      if (moves(patch.controls[i], motion))
        growth += m_patches.slope[first + static_cast<std::size_t>(i)].dot(
            motion[static_cast<std::size_t>(patch.controls[i])]);
    if (growth != 0)
      for (int i = 0; i < patch.count; ++i)
        if (const int u = m_unknown_of_control[static_cast<std::size_t>(patch.controls[i])]; u >= 0)
          forces.segment<3>(3L * u) +=
              growth * m_patches.scaled[first + static_cast<std::size_t>(i)];
    first += static_cast<std::size_t>(patch.count);
  }
}

std::vector<double> ElasticModel::dilatations(const std::vector<Vec3>& x) const
{
  std::vector<double> values;
  m_groups.for_each(
      [&](const auto& group)
      {
        using Element = typename std::decay_t<decltype(group)>::Element;
        if (std::holds_alternative<LinearElastic>(m_materials.of(group.tissue)))
          return;
        const std::size_t first = values.size();
        values.resize(first + group.elements.size() * Element::points);
        ElementLoops<Element>::determinants(group, x, values.data() + first);
      });
  return values;
}

double ElasticModel::smallest_dilatation(const std::vector<Vec3>& x) const
{
  double smallest = std::numeric_limits<double>::infinity();
  m_groups.for_each(
      [&](const auto& group)
      {
        using Group = std::decay_t<decltype(group)>;
        smallest = std::min(smallest,
                            ElementLoops<typename Group::Element>::smallest_determinant(group, x));
      });
  return smallest;
}

} // namespace f2b
