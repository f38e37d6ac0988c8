#include "Meshing/tetrahedral_domain.hpp"

#include "Core/mesh/mesh_quality.hpp"
#include "Meshing/tet_star.hpp"

#include <cmath>
#include <gtest/gtest.h>

using namespace f2b;

namespace
{

TetrahedralDomain spherical_shell()
{
  TetrahedralDomain domain;
  domain.lo = Vec3::Constant(-25.0);
  domain.hi = Vec3::Constant(25.0);
  domain.level = [](const Vec3& p) { return std::abs(p.norm() - 16.0) - 4.0; };
  domain.facet_size = [](const Vec3&) { return 3.0; };
  domain.facet_distance = [](const Vec3&) { return 0.3; };
  domain.cell_size = [](const Vec3&) { return 3.5; };
  return domain;
}

} // namespace

TEST(TetrahedralDomainTest, ShellAroundAHoleIsFilledWithGoodTetrahedra)
{
  const TetrahedralMesh tetrahedra = mesh_domain(spherical_shell());
  MixedMesh mesh;
  mesh.X = tetrahedra.X;
  mesh.tets = tetrahedra.tets;
  const MeshQuality quality = measure_quality(mesh);
  EXPECT_EQ(quality.inverted_elements, 0);
  EXPECT_GE(quality.min_dihedral_deg, 10.0);
  const double volume = 4.0 / 3.0 * std::acos(-1.0) * (std::pow(20.0, 3) - std::pow(12.0, 3));
  EXPECT_NEAR(quality.volume() / volume, 1.0, 0.02);
}

TEST(TetrahedralDomainTest, EmptyRegionGivesAnEmptyMesh)
{
  TetrahedralDomain domain = spherical_shell();
  domain.level = [](const Vec3&) { return 1.0; };
  EXPECT_TRUE(mesh_domain(domain).tets.empty());
}

TEST(TetrahedralDomainTest, SplittingGivesTouchingPartsTheirOwnNodes)
{
  TetrahedralMesh mesh;
  mesh.X = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  mesh.tets = {{0, 1, 2, 3}, {0, 5, 4, 6}};
  EXPECT_EQ(split_pinched_nodes(mesh), 1);
  EXPECT_EQ(mesh.X.size(), 8u);
  EXPECT_TRUE(mesh.X[7] == mesh.X[0]);
  EXPECT_TRUE(non_manifold_nodes(tet_boundary(mesh.tets)).empty());
}

TEST(TetrahedralDomainTest, OnlyTheLargestPartIsKept)
{
  TetrahedralMesh mesh;
  mesh.X = {{9, 9, 9}, {9, 9, 8}, {8, 9, 9}, {9, 8, 9}, {0, 0, 0},
            {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  mesh.tets = {{0, 1, 2, 3}, {4, 5, 6, 7}, {5, 8, 6, 7}};
  EXPECT_EQ(keep_largest_component(mesh), 1);
  EXPECT_EQ(mesh.tets.size(), 2u);
  EXPECT_EQ(mesh.X.size(), 5u);
}
