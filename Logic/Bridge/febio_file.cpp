#include "Bridge/febio_file.hpp"

#include "Core/error.hpp"

namespace f2b
{
namespace
{

std::string number(double value)
{
  return scientific(value, 15);
}

std::string tag(const char* name, const std::string& value)
{
  return std::string("<") + name + ">" + value + "</" + name + ">";
}

/// A remark without what ends an XML comment, or text that XML would read as a tag.
std::string as_text(std::string text)
{
  for (std::size_t at = 0; (at = text.find_first_of("<>&-", at)) != std::string::npos; ++at)
    if (text[at] != '-' || text.compare(at, 2, "--") == 0)
      text[at] = ' ';
  return text;
}

std::string bulk(const VolumetricLaw& law)
{
  static constexpr const char* models[] = {"Abaqus", "default", "NIKE3D"};
  static_assert(static_cast<int>(VolumetricLaw::Kind::Quadratic) == 0 &&
                static_cast<int>(VolumetricLaw::Kind::Logarithmic) == 1 &&
                static_cast<int>(VolumetricLaw::Kind::Barrier) == 2);
  return tag("k", number(law.bulk_modulus)) +
         tag("pressure_model", models[static_cast<std::size_t>(law.kind)]);
}

/// `type` and the parameters of a law.
struct MaterialElement
{
  const MaterialSet& materials;

  std::string operator()(const LinearElastic&) const
  {
    throw Error("materials '" + materials.name + "'",
                "a tissue is linear-elastic, which FEBio in large rotations is not",
                "give the tissue a hyperelastic law");
  }
  std::string operator()(const NeoHookean& law) const
  {
    return mooney(law.isochoric.c10, 0, law.volumetric);
  }
  std::string operator()(const MooneyRivlin& law) const
  {
    return mooney(law.isochoric.c10, law.isochoric.c01, law.volumetric);
  }
  std::string operator()(const Yeoh& law) const
  {
    return "type=\"Yeoh\">" + tag("c1", number(law.isochoric.c1)) +
           tag("c2", number(2 * law.isochoric.c2)) + tag("c3", number(3 * law.isochoric.c3)) +
           bulk(law.volumetric);
  }

private:
  static std::string mooney(double c10, double c01, const VolumetricLaw& volumetric)
  {
    return "type=\"Mooney-Rivlin\">" + tag("c1", number(c10)) + tag("c2", number(c01)) +
           bulk(volumetric);
  }
};

std::string block_name(const ElementBlock& block)
{
  return std::string(tissue_name(block.tissue)) + (block.corners == 6 ? "_PRISMS" : "_TETS");
}

void add_control(const DeckOptions& options, std::string& deck)
{
  deck += "<Module type=\"solid\"/>\n<Control>\n" + tag("analysis", "STATIC") +
          tag("time_steps", std::to_string(options.increments)) +
          tag("step_size", number(1.0 / options.increments)) + "\n<solver type=\"solid\">" +
          tag("dtol", "1e-6") + tag("rtol", "1e-6") + tag("max_refs", "50") +
          "<qn_method type=\"BFGS\">" + tag("max_ups", "0") +
          "</qn_method></solver>\n</Control>\n"
          "<Globals><Constants><T>0</T><P>0</P><R>0</R><Fc>0</Fc></Constants></Globals>\n";
}

void add_materials(const MaterialSet& materials, const std::vector<ElementBlock>& blocks,
                   std::string& deck)
{
  deck += "<Material>\n";
  int id = 0;
  for (const ElementBlock& block : blocks)
    deck += "<material id=\"" + std::to_string(++id) + "\" name=\"" + block_name(block) + "\" " +
            std::visit(MaterialElement{materials}, materials.of(block.tissue)) + "</material>\n";
  deck += "</Material>\n";
}

void add_elements(const ElementBlock& block, std::string& deck)
{
  deck += std::string("<Elements type=\"") + (block.corners == 6 ? "penta6" : "tet4") +
          "\" name=\"" + block_name(block) + "\">\n";
  for (std::size_t e = 0; e < block.elements.size(); ++e)
  {
    deck += "<elem id=\"" + std::to_string(block.first + static_cast<int>(e)) + "\">";
    for (int c = 0; c < block.corners; ++c)
      deck += (c ? "," : "") + std::to_string(block.elements[e][static_cast<std::size_t>(c)] + 1);
    deck += "</elem>\n";
  }
  deck += "</Elements>\n";
}

void add_mesh(const MixedMesh& mesh, const std::vector<ElementBlock>& blocks,
              const std::vector<NodeSet>& sets, std::string& deck)
{
  deck += "<Mesh>\n<Nodes name=\"ALL_NODES\">\n";
  for (std::size_t n = 0; n < mesh.X.size(); ++n)
    deck += "<node id=\"" + std::to_string(n + 1) + "\">" + number(mesh.X[n].x()) + "," +
            number(mesh.X[n].y()) + "," + number(mesh.X[n].z()) + "</node>\n";
  deck += "</Nodes>\n";
  for (const ElementBlock& block : blocks)
    add_elements(block, deck);
  for (const NodeSet& set : sets)
  {
    deck += "<NodeSet name=\"" + set.name + "\">";
    for (std::size_t i = 0; i < set.nodes.size(); ++i)
      deck += (i ? "," : "") + std::to_string(set.nodes[i] + 1);
    deck += "</NodeSet>\n";
  }
  deck += "</Mesh>\n<MeshDomains>\n";
  // the type is named: FEBio would give uncoupled wedges a three-field element of its own
  for (const ElementBlock& block : blocks)
    deck += "<SolidDomain name=\"" + block_name(block) + "\" mat=\"" + block_name(block) +
            "\" type=\"elastic-solid\"/>\n";
  deck += "</MeshDomains>\n";
}

void add_movement(const ForwardProblem& problem, const NodeSet& set, std::string& deck)
{
  const std::vector<Vec3> u = fragment_displacements(problem);
  for (int a = 0; a < 3; ++a)
  {
    deck += "<NodeData name=\"" + set.name + "_" + "xyz"[a] + "\" node_set=\"" + set.name +
            "\" data_type=\"scalar\">\n";
    for (std::size_t i = 0; i < set.nodes.size(); ++i)
    {
      const auto n = static_cast<std::size_t>(set.nodes[i]);
      deck += "<node lid=\"" + std::to_string(i + 1) + "\">" + number(u[n][a]) + "</node>\n";
    }
    deck += "</NodeData>\n";
  }
}

void add_boundary(const NodeSet& set, std::string& deck)
{
  if (set.fragment < 0)
  {
    deck += "<bc name=\"" + set.name + "\" type=\"zero displacement\" node_set=\"" + set.name +
            "\"><x_dof>1</x_dof><y_dof>1</y_dof><z_dof>1</z_dof></bc>\n";
    return;
  }
  for (const char axis : {'x', 'y', 'z'})
  {
    const std::string name = set.name + "_" + axis;
    deck += "<bc name=\"" + name + "\" type=\"prescribed displacement\" node_set=\"" + set.name +
            "\">" + tag("dof", std::string(1, axis)) + "<value lc=\"1\" type=\"map\">" + name +
            "</value>" + tag("relative", "0") + "</bc>\n";
  }
}

} // namespace

std::string febio_deck(const ForwardProblem& problem, const DeckOptions& options)
{
  const std::vector<ElementBlock> blocks = element_blocks(problem.mesh);
  const std::vector<NodeSet> sets = boundary_sets(problem.mesh);
  std::string deck = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<febio_spec version=\"4.0\">\n";
  for (const std::string& remark : deck_remarks(problem, options.title))
    deck += "<!-- " + as_text(remark) + " -->\n";
  add_control(options, deck);
  add_materials(problem.materials, blocks, deck);
  add_mesh(problem.mesh, blocks, sets, deck);
  deck += "<MeshData>\n";
  for (const NodeSet& set : sets)
    if (set.fragment >= 0)
      add_movement(problem, set, deck);
  deck += "</MeshData>\n<Boundary>\n";
  for (const NodeSet& set : sets)
    if (set.held)
      add_boundary(set, deck);
  deck += "</Boundary>\n<LoadData>\n<load_controller id=\"1\" name=\"movement\" "
          "type=\"loadcurve\"><interpolate>LINEAR</interpolate><points><pt>0,0</pt><pt>1,1</pt>"
          "</points></load_controller>\n</LoadData>\n<Output>\n<plotfile type=\"febio\">"
          "<var type=\"displacement\"/></plotfile>\n<logfile><node_data data=\"ux;uy;uz\" "
          "name=\"displacement\"/></logfile>\n</Output>\n</febio_spec>\n";
  return deck;
}

} // namespace f2b
