#include "Bridge/calculix_file.hpp"

#include "Core/error.hpp"

namespace f2b
{
namespace
{

/// ccx reads 20 characters of a number.
std::string number(double value)
{
  return scientific(value, 12);
}

/// A D_i so large that its term is nothing; ccx takes 0 for "not given".
constexpr double no_further_term = 1e20;

const char* name_of(VolumetricLaw::Kind kind)
{
  switch (kind)
  {
  case VolumetricLaw::Kind::Quadratic:
    return "quadratic";
  case VolumetricLaw::Kind::Logarithmic:
    return "log";
  case VolumetricLaw::Kind::Barrier:
    break;
  }
  return "barrier";
}

double compressibility(const VolumetricLaw& law, const MaterialSet& materials)
{
  if (law.kind != VolumetricLaw::Kind::Quadratic)
    throw Error("materials '" + materials.name + "'",
                "the volumetric law is " + std::string(name_of(law.kind)) +
                    "; CalculiX has quadratic",
                "give a material file with \"volumetric_law\": \"quadratic\"");
  return 2 / law.bulk_modulus;
}

/// The lines of a law below *MATERIAL.
struct MaterialCard
{
  const MaterialSet& materials;

  std::string operator()(const LinearElastic&) const
  {
    throw Error("materials '" + materials.name + "'",
                "a tissue is linear-elastic, which CalculiX in large rotations is not",
                "give the tissue a hyperelastic law");
  }
  std::string operator()(const NeoHookean& law) const
  {
    return "*HYPERELASTIC, NEO HOOKE\n" + number(law.isochoric.c10) + ", " +
           number(compressibility(law.volumetric, materials)) + "\n";
  }
  std::string operator()(const MooneyRivlin& law) const
  {
    return "*HYPERELASTIC, MOONEY-RIVLIN\n" + number(law.isochoric.c10) + ", " +
           number(law.isochoric.c01) + ", " + number(compressibility(law.volumetric, materials)) +
           "\n";
  }
  std::string operator()(const Yeoh& law) const
  {
    return "*HYPERELASTIC, YEOH\n" + number(law.isochoric.c1) + ", " + number(law.isochoric.c2) +
           ", " + number(law.isochoric.c3) + ", " +
           number(compressibility(law.volumetric, materials)) + ", " + number(no_further_term) +
           ", " + number(no_further_term) + "\n";
  }
};

std::string block_name(const ElementBlock& block)
{
  return std::string(tissue_name(block.tissue)) + (block.corners == 6 ? "_PRISMS" : "_TETS");
}

void add_mesh(const MixedMesh& mesh, const std::vector<ElementBlock>& blocks, std::string& deck)
{
  deck += "*NODE, NSET=ALL_NODES\n";
  for (std::size_t n = 0; n < mesh.X.size(); ++n)
    deck += std::to_string(n + 1) + ", " + number(mesh.X[n].x()) + ", " + number(mesh.X[n].y()) +
            ", " + number(mesh.X[n].z()) + "\n";
  for (const ElementBlock& block : blocks)
  {
    deck += std::string("*ELEMENT, TYPE=") + (block.corners == 6 ? "C3D6" : "C3D4") +
            ", ELSET=" + block_name(block) + "\n";
    for (std::size_t e = 0; e < block.elements.size(); ++e)
    {
      deck += std::to_string(block.first + static_cast<int>(e));
      for (int c = 0; c < block.corners; ++c)
        deck += ", " + std::to_string(block.elements[e][static_cast<std::size_t>(c)] + 1);
      deck += "\n";
    }
  }
}

void add_set(const NodeSet& set, std::string& deck)
{
  deck += "*NSET, NSET=" + set.name + "\n";
  for (std::size_t i = 0; i < set.nodes.size(); ++i)
    deck +=
        std::to_string(set.nodes[i] + 1) + (i % 10 == 9 || i + 1 == set.nodes.size() ? "\n" : ", ");
}

void add_materials(const MaterialSet& materials, const std::vector<ElementBlock>& blocks,
                   std::string& deck)
{
  for (const ElementBlock& block : blocks)
    deck += "*MATERIAL, NAME=" + block_name(block) + "\n" +
            std::visit(MaterialCard{materials}, materials.of(block.tissue)) +
            "*SOLID SECTION, ELSET=" + block_name(block) + ", MATERIAL=" + block_name(block) + "\n";
}

void add_movement(const ForwardProblem& problem, const std::vector<NodeSet>& sets,
                  std::string& deck)
{
  const std::vector<Vec3> u = fragment_displacements(problem);
  for (const NodeSet& set : sets)
    if (set.fragment >= 0)
      for (const int node : set.nodes)
      {
        const auto n = static_cast<std::size_t>(node);
        for (int a = 0; a < 3; ++a)
          deck += std::to_string(node + 1) + ", " + std::to_string(a + 1) + ", " +
                  std::to_string(a + 1) + ", " + number(u[n][a]) + "\n";
      }
}

} // namespace

std::string calculix_deck(const ForwardProblem& problem, const DeckOptions& options)
{
  const std::vector<ElementBlock> blocks = element_blocks(problem.mesh);
  const std::vector<NodeSet> sets = boundary_sets(problem.mesh);
  std::string deck;
  for (const std::string& remark : deck_remarks(problem, options.title))
    deck += "** " + remark + "\n";
  add_mesh(problem.mesh, blocks, deck);
  for (const NodeSet& set : sets)
    add_set(set, deck);
  add_materials(problem.materials, blocks, deck);
  deck += "*BOUNDARY\n";
  for (const NodeSet& set : sets)
    if (set.held && set.fragment < 0)
      deck += set.name + ", 1, 3\n";
  const std::string count = std::to_string(options.increments);
  // converged when the largest residual is under 1e-6 of the mean nodal force (ccx: 0.5 %)
  deck += "*STEP, NLGEOM, INC=" + std::to_string(options.increments + 1) + "\n*STATIC, DIRECT\n" +
          number(1.0 / options.increments) +
          ", 1.\n*CONTROLS, PARAMETERS=FIELD\n1e-6, 1e-2\n*BOUNDARY\n";
  add_movement(problem, sets, deck);
  deck += "*NODE FILE, FREQUENCY=" + count +
          "\nU\n*NODE PRINT, NSET=ALL_NODES, FREQUENCY=" + count + "\nU\n*END STEP\n";
  return deck;
}

} // namespace f2b
