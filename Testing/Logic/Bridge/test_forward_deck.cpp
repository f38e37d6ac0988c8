#include "Logic/Core/slab_mesh.hpp"
#include "expect_error.hpp"
#include "temporary_folder.hpp"

#include <Bridge/calculix_file.hpp>
#include <Bridge/febio_file.hpp>
#include <Core/mesh/split_prisms.hpp>

#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <sstream>

namespace f2b
{
namespace
{

using test::expect_error;
using test::TemporaryFolder;
using Kind = VolumetricLaw::Kind;

constexpr double skin_bulk = 2, fat_bulk = 3, muscle_bulk = 4;

MaterialSet one_law_each(Kind kind)
{
  MaterialSet set;
  set.name = "one of each";
  set.laws = {Yeoh{{0.05, 0.06, 0.07}, {kind, skin_bulk}},
              MooneyRivlin{{0.02, 0.01}, {kind, fat_bulk}},
              NeoHookean{{0.03}, {kind, muscle_bulk}}};
  return set;
}

RigidMotion some_motion()
{
  RigidMotion motion;
  motion.translation = {1, -2, 3};
  motion.rotation = rotation_from({0.1, -0.05, 0.02});
  motion.reference_point = {1, 2, 3};
  return motion;
}

/// The slab as a problem, and its two forms.
struct Problem
{
  explicit Problem(bool split = false, Kind kind = Kind::Quadratic) : materials(one_law_each(kind))
  {
    const MixedMesh slab = make();
    mesh = split ? split_prisms(slab) : slab;
  }
  static MixedMesh make()
  {
    MixedMesh slab = testing::make_slab({8, 2, 80, 12, 1.5, 3, 0.4});
    slab.fragments = {"mid-face <1>"};
    return slab;
  }
  ForwardProblem problem() const { return {mesh, materials, {some_motion()}}; }

  MixedMesh mesh;
  MaterialSet materials;
};

/// Blocks of a deck by the card that opens them, each line split at its commas.
using Row = std::vector<std::string>;
std::multimap<std::string, std::vector<Row>> cards(const std::string& deck)
{
  std::multimap<std::string, std::vector<Row>> result;
  std::vector<Row>* rows = nullptr;
  std::istringstream lines(deck);
  for (std::string line; std::getline(lines, line);)
  {
    if (line.rfind("**", 0) == 0)
      continue;
    EXPECT_LE(line.size(), 132u) << line; // what ccx reads of a line
    if (line[0] == '*')
    {
      rows = &result.insert({line, {}})->second;
      continue;
    }
    Row row;
    std::istringstream words(line);
    for (std::string word; std::getline(words, word, ',');)
    {
      word.erase(0, word.find_first_not_of(' '));
      EXPECT_LE(word.size(), 20u) << line; // what ccx reads of a word
      if (!word.empty())
        row.push_back(word);
    }
    rows->push_back(row);
  }
  return result;
}

std::vector<Row> card(const std::string& deck, const std::string& name)
{
  const auto all = cards(deck);
  EXPECT_EQ(all.count(name), 1u) << name;
  const auto found = all.find(name);
  return found == all.end() ? std::vector<Row>{} : found->second;
}

std::vector<int> members(const std::string& deck, const std::string& set)
{
  std::vector<int> nodes;
  for (const Row& row : card(deck, "*NSET, NSET=" + set))
    for (const std::string& word : row)
      nodes.push_back(std::stoi(word) - 1);
  return nodes;
}

std::vector<int> nodes_on(const MixedMesh& mesh, Boundary part)
{
  std::vector<int> nodes;
  for (int n = 0; n < mesh.node_count(); ++n)
    if (mesh.node_boundary[std::size_t(n)] == part)
      nodes.push_back(n);
  return nodes;
}

TEST(CalculixDeck, HoldsEveryNodeAndElementWithPositiveVolume)
{
  for (const bool split : {false, true})
  {
    const Problem p(split);
    const std::string deck = calculix_deck(p.problem(), {});
    const std::vector<Row> nodes = card(deck, "*NODE, NSET=ALL_NODES");
    ASSERT_EQ(nodes.size(), p.mesh.X.size());
    std::vector<Vec3> X;
    for (std::size_t n = 0; n < nodes.size(); ++n)
    {
      EXPECT_EQ(nodes[n][0], std::to_string(n + 1));
      X.emplace_back(std::stod(nodes[n][1]), std::stod(nodes[n][2]), std::stod(nodes[n][3]));
      EXPECT_LT((X.back() - p.mesh.X[n]).norm(), 1e-10);
    }
    std::set<int> numbers;
    std::size_t tets = 0, wedges = 0;
    for (const auto& [name, rows] : cards(deck))
    {
      if (name.rfind("*ELEMENT", 0) != 0)
        continue;
      const bool wedge = name.find("TYPE=C3D6") != std::string::npos;
      (wedge ? wedges : tets) += rows.size();
      for (const Row& row : rows)
      {
        ASSERT_EQ(row.size(), wedge ? 7u : 5u);
        numbers.insert(std::stoi(row[0]));
        auto x = [&](std::size_t c) { return X[std::size_t(std::stoi(row[c])) - 1]; };
        EXPECT_GT(tet_volume6(x(1), x(2), x(3), x(4)), 0); // a wedge's 4 stands over its 1
      }
    }
    EXPECT_EQ(wedges, p.mesh.prisms.size());
    EXPECT_EQ(tets, p.mesh.tets.size());
    EXPECT_EQ(numbers.size(), tets + wedges);
    EXPECT_EQ(*numbers.rbegin(), int(tets + wedges));
  }
}

TEST(CalculixDeck, NamesTheBoundaryAndMovesTheFragmentAsTheMotionDoes)
{
  const Problem p;
  const std::string deck = calculix_deck(p.problem(), {"A slab.", 4});
  EXPECT_EQ(members(deck, "FIXED_BONE"), nodes_on(p.mesh, Boundary::FixedBone));
  EXPECT_EQ(members(deck, "CROP"), nodes_on(p.mesh, Boundary::Crop));
  EXPECT_EQ(members(deck, "SKIN"), nodes_on(p.mesh, Boundary::Skin));
  EXPECT_EQ(members(deck, "FREE"), nodes_on(p.mesh, Boundary::Free));
  const std::vector<int> moved = members(deck, "FRAGMENT_1_MID_FACE__1_");
  EXPECT_EQ(moved, nodes_on(p.mesh, Boundary::Fragment));
  const auto all = cards(deck);
  const auto boundary = all.equal_range("*BOUNDARY");
  ASSERT_EQ(std::distance(boundary.first, boundary.second), 2);
  const std::vector<Row>&fixed = boundary.first->second, &given = std::next(boundary.first)->second;
  EXPECT_EQ(fixed, (std::vector<Row>{{"FIXED_BONE", "1", "3"}, {"CROP", "1", "3"}}));
  ASSERT_EQ(given.size(), 3 * moved.size());
  for (std::size_t i = 0; i < given.size(); ++i)
  {
    const auto node = std::size_t(moved[i / 3]);
    const auto axis = Eigen::Index(i % 3);
    EXPECT_EQ(given[i][0], std::to_string(node + 1));
    EXPECT_EQ(given[i][1], std::to_string(axis + 1));
    EXPECT_NEAR(std::stod(given[i][3]),
                (some_motion().apply(p.mesh.X[node]) - p.mesh.X[node])[axis], 1e-11);
  }
  EXPECT_EQ(card(deck, "*STATIC, DIRECT")[0][0], "2.500000000000e-01");
}

TEST(CalculixDeck, GivesEveryLawWithTwoOverKAndNoFurtherVolumetricTerm)
{
  const Problem p;
  const std::string deck = calculix_deck(p.problem(), {});
  auto numbers = [&](const char* name)
  {
    std::vector<double> values;
    const Row row = card(deck, name).at(0);
    for (const std::string& word : row)
      values.push_back(std::stod(word));
    return values;
  };
  EXPECT_EQ(numbers("*HYPERELASTIC, YEOH"),
            (std::vector<double>{0.05, 0.06, 0.07, 2 / skin_bulk, 1e20, 1e20}));
  EXPECT_NEAR(numbers("*HYPERELASTIC, MOONEY-RIVLIN").at(2), 2 / fat_bulk, 1e-12);
  EXPECT_EQ(numbers("*HYPERELASTIC, NEO HOOKE"), (std::vector<double>{0.03, 2 / muscle_bulk}));
  EXPECT_NE(deck.find("no counterpart"), std::string::npos);
  EXPECT_NE(deck.find("right 1, anterior -2, superior 3 mm"), std::string::npos);
}

TEST(CalculixDeck, RefusesByNameAVolumetricLawThatCcxHasNot)
{
  for (const auto& [kind, name] : {std::pair{Kind::Barrier, "barrier"}, {Kind::Logarithmic, "log"}})
  {
    const Problem p(false, kind);
    expect_error([&] { (void)calculix_deck(p.problem(), {}); },
                 {"one of each", name, "CalculiX has quadratic", "\"volumetric_law\""});
  }
  Problem linear;
  linear.materials.laws[0] = LinearElastic{0.1, 1};
  expect_error([&] { (void)calculix_deck(linear.problem(), {}); }, {"linear-elastic"});
  expect_error([&] { (void)febio_deck(linear.problem(), {}); }, {"linear-elastic"});
}

std::vector<vtkXMLDataElement*> all_below(vtkXMLDataElement* root, const char* name)
{
  std::vector<vtkXMLDataElement*> found;
  std::function<void(vtkXMLDataElement*)> look = [&](vtkXMLDataElement* element)
  {
    for (int i = 0; i < element->GetNumberOfNestedElements(); ++i)
    {
      if (std::string(element->GetNestedElement(i)->GetName()) == name)
        found.push_back(element->GetNestedElement(i));
      look(element->GetNestedElement(i));
    }
  };
  look(root);
  return found;
}

std::string text_of(vtkXMLDataElement* element)
{
  return element && element->GetCharacterData() ? element->GetCharacterData() : "";
}

std::vector<double> numbers_in(const std::string& text)
{
  std::vector<double> numbers;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');)
    numbers.push_back(std::stod(word));
  return numbers;
}

/// An FEBio file as any reader of XML sees it.
struct FebioFile
{
  explicit FebioFile(const std::string& deck)
      : root(vtkSmartPointer<vtkXMLDataElement>::Take(
            vtkXMLUtilities::ReadElementFromString(deck.c_str())))
  {
  }
  vtkXMLDataElement* named(const char* tag, const std::string& name) const
  {
    for (vtkXMLDataElement* element : all_below(root, tag))
      if (element->GetAttribute("name") && element->GetAttribute("name") == name)
        return element;
    ADD_FAILURE() << "no " << tag << " " << name;
    return nullptr;
  }
  vtkSmartPointer<vtkXMLDataElement> root;
};

TEST(FebioDeck, HoldsNodesElementsAndSets)
{
  for (const bool split : {false, true})
  {
    const Problem p(split);
    const FebioFile file(febio_deck(p.problem(), {}));
    ASSERT_NE(file.root, nullptr);
    EXPECT_STREQ(file.root->GetAttribute("version"), "4.0");
    vtkXMLDataElement* nodes = file.named("Nodes", "ALL_NODES");
    ASSERT_EQ(std::size_t(nodes->GetNumberOfNestedElements()), p.mesh.X.size());
    for (std::size_t n = 0; n < p.mesh.X.size(); ++n)
    {
      const auto x = numbers_in(text_of(nodes->GetNestedElement(int(n))));
      EXPECT_LT((Vec3(x.at(0), x.at(1), x.at(2)) - p.mesh.X[n]).norm(), 1e-13);
    }
    std::size_t tets = 0, wedges = 0;
    for (vtkXMLDataElement* block : all_below(file.root, "Elements"))
    {
      const bool wedge = std::string(block->GetAttribute("type")) == "penta6";
      (wedge ? wedges : tets) += std::size_t(block->GetNumberOfNestedElements());
      const auto first = numbers_in(text_of(block->GetNestedElement(0)));
      EXPECT_EQ(first.size(), wedge ? 6u : 4u);
      // every block is a domain with a material of its own
      EXPECT_STREQ(file.named("SolidDomain", block->GetAttribute("name"))->GetAttribute("type"),
                   "elastic-solid");
      file.named("material", block->GetAttribute("name"));
    }
    EXPECT_EQ(wedges, p.mesh.prisms.size());
    EXPECT_EQ(tets, p.mesh.tets.size());
    EXPECT_EQ(numbers_in(text_of(file.named("NodeSet", "CROP"))).size(),
              nodes_on(p.mesh, Boundary::Crop).size());
  }
}

TEST(FebioDeck, MovesTheFragmentAndHoldsTheRest)
{
  const Problem p;
  const FebioFile file(febio_deck(p.problem(), {}));
  const std::string set = "FRAGMENT_1_MID_FACE__1_";
  const std::vector<int> nodes = nodes_on(p.mesh, Boundary::Fragment);
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::string name = set + "_" + "xyz"[axis];
    vtkXMLDataElement* data = file.named("NodeData", name);
    ASSERT_EQ(std::size_t(data->GetNumberOfNestedElements()), nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      const Vec3& X = p.mesh.X[std::size_t(nodes[i])];
      EXPECT_NEAR(std::stod(text_of(data->GetNestedElement(int(i)))),
                  (some_motion().apply(X) - X)[axis], 1e-13);
    }
    EXPECT_EQ(text_of(file.named("bc", name)->FindNestedElementWithName("value")), name);
  }
  EXPECT_STREQ(file.named("bc", "FIXED_BONE")->GetAttribute("type"), "zero displacement");
  EXPECT_STREQ(file.named("bc", "CROP")->GetAttribute("type"), "zero displacement");
  EXPECT_EQ(all_below(file.root, "bc").size(), 5u);
}

TEST(FebioDeck, HasAllThreeVolumetricLaws)
{
  for (const auto& [kind, model] : {std::pair{Kind::Quadratic, "Abaqus"},
                                    {Kind::Logarithmic, "default"},
                                    {Kind::Barrier, "NIKE3D"}})
  {
    const Problem p(false, kind);
    const FebioFile file(febio_deck(p.problem(), {}));
    vtkXMLDataElement* skin = file.named("material", "SKIN_PRISMS");
    auto value = [](vtkXMLDataElement* material, const char* name)
    { return text_of(material->FindNestedElementWithName(name)); };
    EXPECT_STREQ(skin->GetAttribute("type"), "Yeoh");
    EXPECT_EQ(value(skin, "pressure_model"), model);
    EXPECT_DOUBLE_EQ(std::stod(value(skin, "k")), skin_bulk);
    EXPECT_DOUBLE_EQ(std::stod(value(skin, "c1")), 0.05);
    EXPECT_DOUBLE_EQ(std::stod(value(skin, "c2")), 2 * 0.06);
    EXPECT_DOUBLE_EQ(std::stod(value(skin, "c3")), 3 * 0.07);
    EXPECT_STREQ(file.named("material", "FAT_TETS")->GetAttribute("type"), "Mooney-Rivlin");
    EXPECT_DOUBLE_EQ(std::stod(value(file.named("material", "FAT_TETS"), "c2")), 0.01);
    EXPECT_DOUBLE_EQ(std::stod(value(file.named("material", "MUSCLE_TETS"), "c2")), 0);
  }
}

} // namespace
} // namespace f2b
