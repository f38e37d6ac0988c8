#include "Core/error.hpp"
#include "Core/mesh/boundary_facets.hpp"
#include "Core/mesh/split_prisms.hpp"
#include "Logic/Core/slab_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>

namespace f2b
{
namespace
{

using namespace testing;

const SlabOptions flat = {5, 2, 50, 10, 1.5, 0, 0.5};
const SlabOptions curved = {5, 2, 50, 10, 1.5, 6, 0.5};

/// The slab with its nodes numbered at random: the rule of the diagonals must not lean on an order.
MixedMesh shuffled(const SlabOptions& options, unsigned seed)
{
  MixedMesh mesh = make_slab(options), result = mesh;
  std::vector<int> name(mesh.X.size());
  std::iota(name.begin(), name.end(), 0);
  std::shuffle(name.begin(), name.end(), std::mt19937(seed));
  for (std::size_t n = 0; n < name.size(); ++n)
    result.X[std::size_t(name[n])] = mesh.X[n];
  for (auto& tet : result.tets)
    for (int& node : tet)
      node = name[std::size_t(node)];
  for (auto& prism : result.prisms)
    for (int& node : prism)
      node = name[std::size_t(node)];
  return result;
}

double volume_of(const MixedMesh& mesh, const Tet& tet)
{
  auto X = [&](std::size_t i) { return mesh.X[std::size_t(tet[i])]; };
  return tet_volume6(X(0), X(1), X(2), X(3)) / 6;
}

/// Of a prism whose lateral quads are cut along given diagonals, by the divergence theorem: the sum
/// of its eight outward triangles' cones.
double polyhedron_volume(const MixedMesh& mesh, const std::vector<Triangle>& outward)
{
  double volume = 0;
  for (const Triangle& t : outward)
    volume +=
        mesh.X[std::size_t(t[0])].dot(mesh.X[std::size_t(t[1])].cross(mesh.X[std::size_t(t[2])])) /
        6;
  return volume;
}

class Split : public ::testing::TestWithParam<std::pair<SlabOptions, unsigned>>
{
protected:
  const MixedMesh mesh = shuffled(GetParam().first, GetParam().second);
  const MixedMesh split = split_prisms(mesh);
};

TEST_P(Split, KeepsNodesAndTheFirstTetrahedra)
{
  EXPECT_EQ(split.X, mesh.X);
  EXPECT_EQ(split.node_boundary, mesh.node_boundary);
  EXPECT_TRUE(split.prisms.empty());
  ASSERT_EQ(split.tets.size(), mesh.tets.size() + 3 * mesh.prisms.size());
  ASSERT_EQ(split.tet_tissue.size(), split.tets.size());
  for (std::size_t t = 0; t < split.tets.size(); ++t)
  {
    if (t < mesh.tets.size())
    {
      EXPECT_EQ(split.tets[t], mesh.tets[t]);
    }
    EXPECT_EQ(split.tet_tissue[t], t < mesh.tets.size() ? mesh.tet_tissue[t] : Tissue::Skin);
  }
}

TEST_P(Split, FacesMeetInPairsAndTheSkinStaysTheSkin)
{
  std::map<Triangle, int> count;
  for (const TetFace& face : sorted_tet_faces(split.tets))
    ++count[face.key];
  std::set<Triangle> outside;
  for (const auto& [key, times] : count)
  {
    EXPECT_LE(times, 2);
    if (times == 1)
      outside.insert(key);
  }
  const BoundaryFacets before = boundary_facets(mesh);
  auto sorted = [](Triangle t)
  {
    std::sort(t.begin(), t.end());
    return t;
  };
  for (const Triangle& top : before.skin)
    EXPECT_EQ(outside.count(sorted(top)), 1u);
  for (const Triangle& inner : before.inner)
    EXPECT_EQ(outside.count(sorted(inner)), 1u);
  // beyond those only the rim, two triangles a quad: no crack has opened between two prisms
  EXPECT_EQ(outside.size(), before.skin.size() + before.inner.size() + 2 * before.sides.size());
}

TEST_P(Split, EveryQuadIsCutFromItsSmallestNode)
{
  std::set<std::pair<int, int>> edges;
  for (std::size_t t = mesh.tets.size(); t < split.tets.size(); ++t)
    for (const int a : split.tets[t])
      for (const int b : split.tets[t])
        edges.insert({a, b});
  for (const auto& prism : mesh.prisms)
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t j = (i + 1) % 3;
      const int one = std::min(prism[i], prism[j + 3]), other = std::min(prism[j], prism[i + 3]);
      EXPECT_EQ(edges.count({prism[i], prism[j + 3]}), one < other);
      EXPECT_EQ(edges.count({prism[j], prism[i + 3]}), other < one);
    }
}

TEST_P(Split, VolumeIsThatOfThePolyhedron)
{
  const std::vector<Triangle> boundary = tet_boundary(split.tets);
  double total = 0;
  for (const Tet& tet : split.tets)
  {
    EXPECT_GT(volume_of(split, tet), 0);
    total += volume_of(split, tet);
  }
  EXPECT_NEAR(total, polyhedron_volume(split, boundary), 1e-9 * total);
  if (GetParam().first.dome_mm == 0)
  {
    EXPECT_NEAR(total, 50 * 50 * 11.5, 1e-9 * total);
  }
}

INSTANTIATE_TEST_SUITE_P(Slabs, Split,
                         ::testing::Values(std::pair{flat, 1u}, std::pair{flat, 2u},
                                           std::pair{curved, 3u}, std::pair{curved, 4u}));

TEST(SplitPrism, AllOrdersOfTheNodesGiveThreePositiveTetrahedra)
{
  MixedMesh mesh;
  mesh.X = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  std::array<int, 6> order = {0, 1, 2, 3, 4, 5};
  int orders = 0;
  do
  {
    MixedMesh renamed = mesh;
    for (std::size_t i = 0; i < 6; ++i)
      renamed.X[std::size_t(order[i])] = mesh.X[i];
    double total = 0;
    for (const Tet& tet : split_prism(order, cut_by_node_number(order)))
    {
      EXPECT_NEAR(volume_of(renamed, tet), 1.0 / 6, 1e-15);
      total += volume_of(renamed, tet);
    }
    EXPECT_NEAR(total, 0.5, 1e-15);
    ++orders;
  } while (std::next_permutation(order.begin(), order.end()));
  EXPECT_EQ(orders, 720);
}

TEST(SplitPrism, AllSixCutsFillAPrism)
{
  MixedMesh mesh;
  mesh.X = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (unsigned pattern = 1; pattern < 7; ++pattern)
    for (const Tet& tet : split_prism({0, 1, 2, 3, 4, 5},
                                      {(pattern & 1) != 0, (pattern & 2) != 0, (pattern & 4) != 0}))
      EXPECT_NEAR(volume_of(mesh, tet), 1.0 / 6, 1e-15) << pattern;
}

TEST(SplitPrism, QuadsThatTheNodeNumbersCutBadlyAreCutOtherwiseOnBothSides)
{
  int bad = 0;
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    MixedMesh mesh = shuffled(flat, seed);
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> shift(-4.6, 4.6);
    for (std::size_t n = 0; n < mesh.X.size(); ++n)
      if (mesh.X[n].z() > 11 && generator() % 6 == 0)
        mesh.X[n] += Vec3(shift(generator), shift(generator), 0.1 * shift(generator));
    for (const auto& prism : mesh.prisms)
      for (const Tet& tet : split_prism(prism, cut_by_node_number(prism)))
        bad += volume_of(mesh, tet) <= 0;
    const MixedMesh split = split_prisms(mesh);
    for (const Tet& tet : split.tets)
      EXPECT_GT(volume_of(split, tet), 0);
    std::map<Triangle, int> count;
    for (const TetFace& face : sorted_tet_faces(split.tets))
      ++count[face.key];
    std::size_t outside = 0;
    for (const auto& [key, times] : count)
      outside += times == 1;
    const BoundaryFacets before = boundary_facets(mesh);
    EXPECT_EQ(outside, before.skin.size() + before.inner.size() + 2 * before.sides.size());
  }
  EXPECT_GT(bad, 0) << "nothing had to be mended";
}

TEST(SplitPrism, AWarpedPrismIsRefusedWithItsPlace)
{
  MixedMesh mesh;
  mesh.X = {{0, 0, 1}, {1, 0, 1}, {0, 1, -1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.prisms = {{0, 1, 2, 3, 4, 5}};
  EXPECT_THROW(split_prisms(mesh), Error);
}

} // namespace
} // namespace f2b
