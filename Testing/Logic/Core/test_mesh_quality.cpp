#include "Core/mesh/mesh_quality.hpp"

#include <cmath>
#include <gtest/gtest.h>

using namespace f2b;

namespace
{

/// An upright prism on an equilateral triangle of unit edges.
PrismCorners upright_prism(double height)
{
  const double h = std::sqrt(3.0) / 2.0;
  const std::array<Vec3, 3> base = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, h, 0)};
  const Vec3 up(0, 0, height);
  return {base[0] + up, base[1] + up, base[2] + up, base[0], base[1], base[2]};
}

/// One prism on one tetrahedron.
MixedMesh prism_on_tet()
{
  MixedMesh mesh;
  const PrismCorners x = upright_prism(0.5);
  mesh.X.assign(x.begin(), x.end());
  mesh.X.push_back(Vec3(0.5, 0.3, -0.8));
  mesh.prisms = {{0, 1, 2, 3, 4, 5}};
  mesh.tets = {{3, 5, 4, 6}};
  return mesh;
}

} // namespace

TEST(MeshQualityTest, RegularTetrahedronHasItsDihedralAngle)
{
  const Vec3 a(1, 1, 1), b(-1, -1, 1), c(-1, 1, -1), d(1, -1, -1);
  const double angle = std::acos(1.0 / 3.0) * 180.0 / std::acos(-1.0);
  EXPECT_NEAR(min_dihedral_deg(a, b, c, d), angle, 1e-10);
}

TEST(MeshQualityTest, CornerTetrahedronHasItsSmallestDihedralAngle)
{
  const double angle = std::acos(1.0 / std::sqrt(3.0)) * 180.0 / std::acos(-1.0);
  EXPECT_NEAR(min_dihedral_deg(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()), angle,
              1e-10);
}

TEST(MeshQualityTest, InvertedOrFlatTetrahedronIsNegative)
{
  EXPECT_LT(min_dihedral_deg(Vec3::Zero(), Vec3::UnitY(), Vec3::UnitX(), Vec3::UnitZ()), 0.0);
  EXPECT_LT(min_dihedral_deg(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3(1, 1, 0)), 0.0);
}

TEST(MeshQualityTest, UprightPrismIsIdealWhateverItsHeight)
{
  for (const double height : {0.01, 1.0, 30.0})
  {
    EXPECT_NEAR(min_scaled_jacobian(upright_prism(height)), std::sqrt(3.0) / 2.0, 1e-12);
    EXPECT_NEAR(prism_volume(upright_prism(height)), height * std::sqrt(3.0) / 4.0, 1e-12);
  }
}

TEST(MeshQualityTest, ShearedPrismKeepsItsVolumeAndLosesScaledJacobian)
{
  PrismCorners x = upright_prism(1.0);
  for (int i = 0; i < 3; ++i)
    x[i] += Vec3(1.0, 0.0, 0.0);
  EXPECT_NEAR(prism_volume(x), std::sqrt(3.0) / 4.0, 1e-12);
  EXPECT_NEAR(min_scaled_jacobian(x), std::sqrt(3.0) / 2.0 / std::sqrt(2.0), 1e-12);
}

TEST(MeshQualityTest, PrismThatTapersToATetrahedronHasATetrahedronsVolume)
{
  PrismCorners x = upright_prism(0.9);
  x[0] = x[1] = x[2];
  EXPECT_NEAR(prism_volume(x), 0.9 * std::sqrt(3.0) / 12.0, 1e-12);
  EXPECT_LE(min_scaled_jacobian(x), 0.0);
}

TEST(MeshQualityTest, PrismWithItsTopUnderItsBottomIsInverted)
{
  EXPECT_LT(min_scaled_jacobian(upright_prism(-1.0)), 0.0);
  for (const double jacobian : quadrature_jacobians(upright_prism(-1.0)))
    EXPECT_LT(jacobian, 0.0);
}

TEST(MeshQualityTest, FiguresOfAConformingMesh)
{
  const MeshQuality quality = measure_quality(prism_on_tet());
  EXPECT_EQ(quality.inverted_elements, 0);
  EXPECT_EQ(quality.unmatched_inner_faces, 0);
  EXPECT_EQ(quality.worst_tet, 0);
  EXPECT_NEAR(quality.volume(), std::sqrt(3.0) / 4.0 * (0.5 + 0.8 / 3.0), 1e-12);
}

TEST(MeshQualityTest, PrismWithoutTetrahedronBelowIsCounted)
{
  MixedMesh mesh = prism_on_tet();
  mesh.X.push_back(Vec3(0.5, 0.4, 0.1));
  mesh.tets[0] = {3, 5, 7, 6};
  EXPECT_EQ(unmatched_inner_faces(mesh), 1);
}

TEST(MeshQualityTest, InvertedElementsAreCounted)
{
  MixedMesh mesh = prism_on_tet();
  std::swap(mesh.tets[0][0], mesh.tets[0][1]);
  EXPECT_EQ(measure_quality(mesh).inverted_elements, 1);
}
