#include "Bridge/forward_deck.hpp"

#include <cctype>
#include <cstdio>

namespace f2b
{
namespace
{

std::string set_name(const MixedMesh& mesh, int fragment)
{
  std::string name = "FRAGMENT_" + std::to_string(fragment + 1) + "_";
  for (const unsigned char c : mesh.fragments[static_cast<std::size_t>(fragment)])
    name += std::isalnum(c) ? static_cast<char>(std::toupper(c)) : '_';
  return name;
}

std::string movement_remark(const MixedMesh& mesh, std::size_t fragment, const RigidMotion& motion)
{
  constexpr double degrees = 180 / 3.14159265358979323846;
  const EulerAngles angles = euler_angles(motion.rotation);
  const Vec3& t = motion.translation;
  const Vec3& c = motion.reference_point;
  char text[400];
  std::snprintf(text, sizeof text,
                "%s is fragment '%s': right %.6g, anterior %.6g, superior %.6g mm; pitch %.6g, "
                "roll %.6g, yaw %.6g degrees about RAS (%.6g, %.6g, %.6g)",
                set_name(mesh, static_cast<int>(fragment)).c_str(),
                mesh.fragments[fragment].c_str(), t.x(), t.y(), t.z(), angles.pitch * degrees,
                angles.roll * degrees, angles.yaw * degrees, c.x(), c.y(), c.z());
  return text;
}

} // namespace

std::vector<ElementBlock> element_blocks(const MixedMesh& mesh)
{
  std::vector<ElementBlock> blocks;
  ElementBlock wedges{Tissue::Skin, 6, 1, {}};
  for (const auto& p : mesh.prisms)
    wedges.elements.push_back({p[3], p[4], p[5], p[0], p[1], p[2]});
  blocks.push_back(wedges);
  for (const Tissue tissue : {Tissue::Skin, Tissue::Fat, Tissue::Muscle})
  {
    const ElementBlock& before = blocks.back();
    ElementBlock tets{tissue, 4, before.first + static_cast<int>(before.elements.size()), {}};
    for (std::size_t t = 0; t < mesh.tets.size(); ++t)
      if (mesh.tet_tissue[t] == tissue)
        tets.elements.push_back(
            {mesh.tets[t][0], mesh.tets[t][1], mesh.tets[t][2], mesh.tets[t][3], -1, -1});
    blocks.push_back(std::move(tets));
  }
  std::vector<ElementBlock> filled;
  for (ElementBlock& block : blocks)
    if (!block.elements.empty())
      filled.push_back(std::move(block));
  return filled;
}

std::vector<NodeSet> boundary_sets(const MixedMesh& mesh)
{
  std::vector<NodeSet> sets = {{"FIXED_BONE", true, -1, {}},
                               {"CROP", true, -1, {}},
                               {"SKIN", false, -1, {}},
                               {"FREE", false, -1, {}}};
  for (std::size_t f = 0; f < mesh.fragments.size(); ++f)
    sets.push_back({set_name(mesh, static_cast<int>(f)), true, static_cast<int>(f), {}});
  auto set_of = [&](int n) -> NodeSet*
  {
    const auto node = static_cast<std::size_t>(n);
    switch (mesh.node_boundary[node])
    {
    case Boundary::FixedBone:
      return &sets[0];
    case Boundary::Crop:
      return &sets[1];
    case Boundary::Skin:
      return &sets[2];
    case Boundary::Free:
      return &sets[3];
    case Boundary::Fragment:
      return &sets[4 + static_cast<std::size_t>(mesh.node_fragment[node])];
    case Boundary::Interior:
      break;
    }
    return nullptr;
  };
  for (int n = 0; n < mesh.node_count(); ++n)
    if (NodeSet* set = set_of(n))
      set->nodes.push_back(n);
  std::vector<NodeSet> filled;
  for (NodeSet& set : sets)
    if (!set.nodes.empty())
      filled.push_back(std::move(set));
  return filled;
}

const char* tissue_name(Tissue tissue)
{
  static constexpr const char* names[tissue_count] = {"SKIN", "FAT", "MUSCLE"};
  return names[static_cast<std::size_t>(tissue)];
}

std::vector<std::string> deck_remarks(const ForwardProblem& problem, const std::string& title)
{
  const MixedMesh& mesh = problem.mesh;
  std::vector<std::string> remarks = {
      title, "FaceToBone, research software, not a medical device.",
      "Units mm, N, MPa; frame RAS (right, anterior, superior). Materials '" +
          problem.materials.name + "'.",
      "Nodes " + std::to_string(mesh.X.size()) + ", prisms " + std::to_string(mesh.prisms.size()) +
          ", tetrahedra " + std::to_string(mesh.tets.size()) + "."};
  if (mesh.prisms.empty())
    remarks.push_back("Plain linear tetrahedra; the skin's prisms are split into three each.");
  else
    remarks.push_back("The skin is linear prisms: the smooth prism of the model nfm-em has no "
                      "counterpart in this engine.");
  for (std::size_t f = 0; f < problem.motions.size(); ++f)
    remarks.push_back(movement_remark(mesh, f, problem.motions[f]));
  return remarks;
}

std::string scientific(double value, int digits)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.*e", digits, value);
  return text;
}

} // namespace f2b
