#include "Core/assembly/element_groups.hpp"

#include "Core/assembly/dilatation_patches.hpp"
#include "Core/assembly/spatial_order.hpp"

namespace f2b
{
namespace
{

/// The tetrahedra of a tissue, neighbours in space near one another: what their nodes gather then
/// lies together in memory.
std::vector<Tet> tets_of(const MixedMesh& mesh, Tissue kind)
{
  std::vector<Tet> tets;
  std::vector<Vec3> centers;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    if (mesh.tet_tissue[t] == kind)
    {
      tets.push_back(mesh.tets[t]);
      Vec3 sum = Vec3::Zero();
      for (const int node : mesh.tets[t])
        sum += mesh.X[static_cast<std::size_t>(node)];
      centers.push_back(sum / 4);
    }
  std::vector<Tet> sorted;
  sorted.reserve(tets.size());
  for (const int t : spatial_order(centers))
    sorted.push_back(tets[static_cast<std::size_t>(t)]);
  return sorted;
}

} // namespace

ElementGroups::ElementGroups(const Discretization& tissue, const MaterialSet& materials)
{
  for (int kind = 0; kind < tissue_count; ++kind)
    add_tets(tissue, materials, static_cast<Tissue>(kind));
  if (tissue.smooth_skin())
    add_smooth_prisms(tissue);
  else
    add_prisms(tissue);
  number();
}

void ElementGroups::add_tets(const Discretization& tissue, const MaterialSet& materials,
                             Tissue kind)
{
  const MixedMesh& mesh = tissue.mesh();
  const std::vector<Tet> tets = tets_of(mesh, kind);
  if (tets.empty())
    return;
  ElementGroup<Tet4> group;
  group.tissue = kind;
  const Law& law = materials.of(kind);
  group.averaged = tissue.scheme().dilatation == Dilatation::Averaged &&
                   bulk_modulus(law) > patched_from * shear_modulus(law);
  if (group.averaged)
  {
    DilatationPatches patches = make_dilatation_patches(tets, tissue.scheme().patch_tets);
    for (const int t : patches.tets)
      group.controls.push_back(tets[static_cast<std::size_t>(t)]);
    group.patch_start = std::move(patches.start);
  }
  else
    group.controls = tets;
  for (std::size_t e = 0; e < group.controls.size(); ++e)
    group.elements.push_back(make_tet4(group.positions(tissue.rest(), static_cast<long>(e))));
  if (group.averaged)
    number_patch_slots(group);
  std::get<0>(m_kinds).push_back(std::move(group));
}

void ElementGroups::add_prisms(const Discretization& tissue)
{
  const MixedMesh& mesh = tissue.mesh();
  if (mesh.prisms.empty())
    return;
  ElementGroup<Prism6> group;
  group.tissue = Tissue::Skin;
  group.averaged = tissue.scheme().dilatation == Dilatation::Averaged;
  group.controls = mesh.prisms;
  for (std::size_t e = 0; e < group.controls.size(); ++e)
    group.elements.push_back(make_prism6(group.positions(tissue.rest(), static_cast<long>(e))));
  std::get<1>(m_kinds).push_back(std::move(group));
}

void ElementGroups::add_smooth_prisms(const Discretization& tissue)
{
  const SmoothSkin& skin = *tissue.smooth_skin();
  const int count = static_cast<int>(tissue.mesh().prisms.size());
  if (count == 0)
    return;
  ElementGroup<SmoothPrism> group;
  group.tissue = Tissue::Skin;
  group.averaged = tissue.scheme().dilatation == Dilatation::Averaged;
  for (int prism = 0; prism < count; ++prism)
    group.controls.push_back(skin.controls(prism));
  group.elements.resize(group.controls.size());
#pragma omp parallel for schedule(static)
  for (int prism = 0; prism < count; ++prism)
    group.elements[static_cast<std::size_t>(prism)] = skin.element(prism);
  std::get<2>(m_kinds).push_back(std::move(group));
}

void ElementGroups::number()
{
  auto number_group = [this](auto& group)
  {
    group.first_element = static_cast<long>(m_elements);
    group.first_slot = static_cast<long>(m_slots);
    group.first_block = static_cast<long>(m_blocks);
    group.first_patch_slot = static_cast<long>(m_patch_slots);
    const auto n = group.elements.size();
    m_elements += n;
    m_slots += n * static_cast<std::size_t>(group.corners);
    m_blocks += n * static_cast<std::size_t>(f2b::block_count(group.corners));
    m_patch_slots += group.patch_control.size();
  };
  std::apply([&](auto&... kind) { (for_each_of(kind, number_group), ...); }, m_kinds);
}

std::vector<Clique> ElementGroups::element_cliques() const
{
  std::vector<Clique> cliques;
  cliques.reserve(m_elements);
  for_each(
      [&](const auto& group)
      {
        for (const auto& controls : group.controls)
          cliques.push_back({controls.data(), group.corners});
      });
  return cliques;
}

std::vector<Clique> ElementGroups::patch_cliques() const
{
  std::vector<Clique> cliques;
  for_each(
      [&](const auto& group)
      {
        for (std::size_t p = 0; p + 1 < group.patch_slot_start.size(); ++p)
        {
          const int begin = group.patch_slot_start[p], end = group.patch_slot_start[p + 1];
          cliques.push_back({group.patch_control.data() + begin, end - begin});
        }
      });
  return cliques;
}

} // namespace f2b
