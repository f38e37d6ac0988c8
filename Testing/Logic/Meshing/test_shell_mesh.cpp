#include "Meshing/shell_mesh.hpp"

#include "Core/error.hpp"
#include "Core/mesh/boundary_facets.hpp"
#include "analytic_head.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

using namespace f2b;
using namespace f2b::testing;

namespace
{

ShellMeshOptions coarse_options()
{
  ShellMeshOptions options;
  options.region = face_region();
  options.density = 0.4;
  return options;
}

/// The head and its shell, each made once and only where a test asks for it.
class ShellMeshTest : public ::testing::Test
{
protected:
  static const AnalyticHead& head()
  {
    static const AnalyticHead result = analytic_head(1.5);
    return result;
  }
  static const ShellMesh& shell()
  {
    static const ShellMesh result = build_shell_mesh(head().fields(), coarse_options());
    return result;
  }
  static const MixedMesh& mesh() { return shell().mesh; }
  static const ShellMeshReport& report() { return shell().report; }
};

} // namespace

TEST_F(ShellMeshTest, EveryPrismStandsOnExactlyOneTetrahedron)
{
  EXPECT_GT(report().prisms, 1000);
  EXPECT_EQ(unmatched_inner_faces(mesh()), 0);
  EXPECT_EQ(mesh().node_boundary.size(), mesh().X.size());
  EXPECT_EQ(mesh().node_fragment.size(), mesh().X.size());
}

TEST_F(ShellMeshTest, ElementsAreWellShaped)
{
  EXPECT_EQ(report().quality.inverted_elements, 0);
  EXPECT_GE(report().quality.min_dihedral_deg, 8.0);
  EXPECT_GE(report().quality.min_scaled_jacobian, 0.1);
  EXPECT_GT(report().quality.min_quadrature_jacobian, 0.0);
  EXPECT_EQ(report().bad_prisms, 0);
}

TEST_F(ShellMeshTest, SkinIsOneSheetWithoutHoles)
{
  EXPECT_EQ(report().holes, 0);
  const BoundaryFacets facets = boundary_facets(mesh());
  for (const int component : sheet_components(facets.skin))
    ASSERT_EQ(component, 0);
  EXPECT_TRUE(non_manifold_nodes(facets.skin).empty());
  const RegionBox box = face_region();
  for (const auto& loop : boundary_loops(facets.skin))
    for (const int node : loop)
    {
      const Vec3& p = mesh().X[node];
      const double depth = std::min((p - box.lo).minCoeff(), (box.hi - p).minCoeff());
      EXPECT_LT(depth, 8.0) << p.transpose();
    }
}

TEST_F(ShellMeshTest, TetrahedraAreOneFaceConnectedSet)
{
  for (const int component : tet_components(mesh().tets))
    ASSERT_EQ(component, 0);
}

TEST_F(ShellMeshTest, VolumeIsTheLabels)
{
  EXPECT_NEAR(report().mesh_volume / report().label_volume, 1.0, 0.02);
}

TEST_F(ShellMeshTest, SkinIsWhereTheFieldsSkinIs)
{
  EXPECT_LT(report().fidelity.mesh_to_ct.p95, 0.5);
  EXPECT_LT(report().fidelity.ct_to_mesh.p95, 0.5);
  EXPECT_GT(report().fidelity.ct_to_mesh.samples, 1000u);
}

TEST_F(ShellMeshTest, TopsLieOnTheSkinAndInnerNodesOnBone)
{
  int tops = 0;
  for (int node = 0; node < mesh().node_count(); ++node)
    if (mesh().node_boundary[node] == Boundary::Skin)
    {
      ++tops;
      EXPECT_LT(std::abs(head().skin.value(mesh().X[node])), 1.2);
    }
    else if (mesh().node_boundary[node] == Boundary::FixedBone)
    {
      // On closed bone, or on the floor that keeps 3 mm below the skin where bone is nearer.
      const double bone = head().closed_bone.value(mesh().X[node]);
      const double floor = head().skin.value(mesh().X[node]) + 3.0;
      EXPECT_LT(std::abs(std::max(bone, floor)), 0.5 * head().skin.spacing)
          << mesh().X[node].transpose();
    }
  EXPECT_GT(tops, 500);
  EXPECT_LT(report().tops_off_skin, tops / 50);
}

TEST_F(ShellMeshTest, InnerNodesOverACavityAreFreeAndElsewhereOnBone)
{
  int free_over_cavity = 0;
  for (int node = 0; node < mesh().node_count(); ++node)
  {
    const double to_cavity = (mesh().X[node] - cavity_centre()).norm();
    if (mesh().node_boundary[node] == Boundary::Free)
    {
      EXPECT_LT(to_cavity, 20.0);
      ++free_over_cavity;
    }
  }
  EXPECT_GT(free_over_cavity, 5);
}

TEST_F(ShellMeshTest, TissueFollowsHounsfieldUnits)
{
  ASSERT_EQ(mesh().tet_tissue.size(), mesh().tets.size());
  for (std::size_t t = 0; t < mesh().tets.size(); ++t)
  {
    double highest = -100.0, lowest = 0.0, to_bone = 100.0;
    for (const int node : mesh().tets[t])
    {
      highest = std::max(highest, head().skin.value(mesh().X[node]));
      lowest = std::min(lowest, head().skin.value(mesh().X[node]));
      to_bone = std::min(to_bone, head().bone.value(mesh().X[node]));
    }
    if (to_bone < head().hu.spacing)
      continue;        // partial volume
    if (lowest > -4.0) // the fat below the skin is 5 mm thick
    {
      EXPECT_EQ(mesh().tet_tissue[t], Tissue::Fat);
    }
    if (highest < -6.5)
    {
      EXPECT_EQ(mesh().tet_tissue[t], Tissue::Muscle);
    }
  }
}

TEST_F(ShellMeshTest, SameInputGivesTheSameMeshBitForBit)
{
  const ShellMesh again = build_shell_mesh(head().fields(), coarse_options());
  ASSERT_EQ(again.mesh.X.size(), mesh().X.size());
  EXPECT_TRUE(again.mesh.X == mesh().X);
  EXPECT_TRUE(again.mesh.tets == mesh().tets);
  EXPECT_TRUE(again.mesh.prisms == mesh().prisms);
  EXPECT_TRUE(again.mesh.node_boundary == mesh().node_boundary);
}

TEST_F(ShellMeshTest, DensityRaisesTheCounts)
{
  ShellMeshOptions options = coarse_options();
  options.density = 0.8;
  const ShellMesh denser = build_shell_mesh(head().fields(), options);
  EXPECT_GT(denser.report.tets, 1.4 * report().tets);
  EXPECT_GE(denser.report.quality.min_scaled_jacobian, 0.1);
}

TEST_F(ShellMeshTest, ThicknessMaySlowlyChangeFromPlaceToPlace)
{
  // 1 mm on the right, 3 mm on the left
  ScalarGrid thickness{head().skin.origin, head().skin.spacing, head().skin.size, {}};
  for (int k = 0; k < thickness.size.z(); ++k)
    for (int j = 0; j < thickness.size.y(); ++j)
      for (int i = 0; i < thickness.size.x(); ++i)
        thickness.values.push_back(
            static_cast<float>(2 - std::tanh(thickness.position(i, j, k).x() / 10)));
  ShellFields fields = head().fields();
  const ShellMesh shell = build_shell_mesh(
      {fields.skin, fields.closed_bone, fields.bone, fields.hu, &thickness}, coarse_options());
  EXPECT_EQ(shell.report.quality.inverted_elements, 0);
  EXPECT_GE(shell.report.quality.min_dihedral_deg, 8.0);
  EXPECT_EQ(shell.report.holes, 0);
  EXPECT_LT(shell.report.fidelity.ct_to_mesh.p95, 0.5);
  std::vector<double> right, left;
  for (const std::array<int, 6>& prism : shell.mesh.prisms)
    for (int c = 0; c < 3; ++c)
    {
      const Vec3 &bottom = shell.mesh.X[prism[c]], &top = shell.mesh.X[prism[c + 3]];
      if (std::abs(bottom.x()) > 20)
        (bottom.x() > 0 ? right : left).push_back((top - bottom).norm());
    }
  for (std::vector<double>* side : {&right, &left})
    std::sort(side->begin(), side->end());
  EXPECT_NEAR(right[right.size() / 2], 1, 0.1);
  EXPECT_NEAR(left[left.size() / 2], 3, 0.2);
}

TEST_F(ShellMeshTest, RegionOutsideTheCtIsRefused)
{
  ShellMeshOptions options = coarse_options();
  options.region = {Vec3(500, 500, 500), Vec3(600, 600, 600)};
  EXPECT_THROW(build_shell_mesh(head().fields(), options), Error);
}

TEST_F(ShellMeshTest, RegionInAirIsRefused)
{
  ShellMeshOptions options = coarse_options();
  options.region = {Vec3(-85, 100, 50), Vec3(-60, 120, 70)};
  EXPECT_THROW(build_shell_mesh(head().fields(), options), Error);
}

TEST_F(ShellMeshTest, RegionBelowTheSkinIsRefused)
{
  ShellMeshOptions options = coarse_options();
  options.region = {Vec3(-15, 65, -25), Vec3(15, 84, 5)};
  EXPECT_THROW(build_shell_mesh(head().fields(), options), Error);
}

TEST_F(ShellMeshTest, FieldsOnDifferentLatticesAreRefused)
{
  AnalyticHead other = head();
  other.hu.origin.x() += 1.0;
  EXPECT_THROW(build_shell_mesh(other.fields(), coarse_options()), Error);
}
