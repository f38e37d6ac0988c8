#include "Core/mesh/boundary_facets.hpp"

#include <gtest/gtest.h>

using namespace f2b;

namespace
{

double area_vector_sum(const MixedMesh& mesh, const BoundaryFacets& facets)
{
  Vec3 sum = Vec3::Zero();
  const auto add = [&](int a, int b, int c)
  { sum += 0.5 * (mesh.X[b] - mesh.X[a]).cross(mesh.X[c] - mesh.X[a]); };
  for (const auto* triangles : {&facets.skin, &facets.inner})
    for (const Triangle& n : *triangles)
      add(n[0], n[1], n[2]);
  for (const auto& n : facets.sides)
  {
    add(n[0], n[1], n[2]);
    add(n[0], n[2], n[3]);
  }
  return sum.norm();
}

/// Two prisms side by side, each on a tetrahedron.
MixedMesh two_prisms()
{
  MixedMesh mesh;
  for (const double z : {1.0, 0.0})
    for (const auto& xy : {std::array<double, 2>{0, 0}, {1, 0}, {1, 1}, {0, 1}})
      mesh.X.push_back(Vec3(xy[0], xy[1], z));
  mesh.X.push_back(Vec3(0.5, 0.5, -1.0));
  mesh.prisms = {{0, 1, 2, 4, 5, 6}, {0, 2, 3, 4, 6, 7}};
  mesh.tets = {{4, 6, 5, 8}, {4, 7, 6, 8}};
  return mesh;
}

} // namespace

TEST(BoundaryFacetsTest, BoundaryOfAMixedMeshIsClosed)
{
  const MixedMesh mesh = two_prisms();
  const BoundaryFacets facets = boundary_facets(mesh);
  EXPECT_EQ(facets.skin.size(), 2u);
  EXPECT_EQ(facets.sides.size(), 4u);
  EXPECT_EQ(facets.inner.size(), 4u);
  EXPECT_NEAR(area_vector_sum(mesh, facets), 0.0, 1e-12);
}

TEST(BoundaryFacetsTest, FacetsLookOutwards)
{
  const MixedMesh mesh = two_prisms();
  const Vec3 inside(0.5, 0.5, 0.2);
  for (const Triangle& n : boundary_facets(mesh).inner)
  {
    const Vec3 normal = (mesh.X[n[1]] - mesh.X[n[0]]).cross(mesh.X[n[2]] - mesh.X[n[0]]);
    EXPECT_GT(normal.dot(mesh.X[n[0]] - inside), 0.0);
  }
}

TEST(BoundaryFacetsTest, SheetWithAHoleHasTwoLoops)
{
  std::vector<Triangle> ring;
  for (int i = 0; i < 6; ++i)
  {
    const int j = (i + 1) % 6;
    ring.push_back({i, j, 6 + i});
    ring.push_back({j, 6 + j, 6 + i});
  }
  const auto loops = boundary_loops(ring);
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_EQ(loops[0].size(), 6u);
  EXPECT_EQ(loops[1].size(), 6u);
  EXPECT_TRUE(non_manifold_nodes(ring).empty());
  EXPECT_EQ(sheet_components(ring).back(), 0);
}

TEST(BoundaryFacetsTest, TrianglesThatTouchInANodeAreTwoSheetsAndNotManifold)
{
  const std::vector<Triangle> bow_tie = {{0, 1, 2}, {2, 3, 4}};
  EXPECT_EQ(sheet_components(bow_tie), (std::vector<int>{0, 1}));
  EXPECT_EQ(non_manifold_nodes(bow_tie), std::vector<int>{2});
}

TEST(BoundaryFacetsTest, EdgeOfThreeTrianglesIsNotManifold)
{
  EXPECT_EQ(non_manifold_nodes({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}), (std::vector<int>{0, 1}));
}

TEST(BoundaryFacetsTest, TetrahedraThatShareAnEdgeOnlyAreTwoComponents)
{
  EXPECT_EQ(tet_components({{0, 1, 2, 3}, {0, 1, 4, 5}, {1, 2, 3, 6}}),
            (std::vector<int>{0, 1, 0}));
}
