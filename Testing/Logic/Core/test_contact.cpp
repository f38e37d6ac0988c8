#include "Logic/Core/box_bone.hpp"
#include "expect_error.hpp"

#include <Core/mesh/contact.hpp>

namespace f2b
{
namespace
{

using test::expect_error;
using testing::box_bone;
using testing::cut_at;

/// A row of nodes over the block's anterior side, every 2 mm along R.
MixedMesh row_of_nodes()
{
  MixedMesh mesh;
  for (double r = -28; r <= 28; r += 2)
  {
    mesh.X.push_back({r, 20.3, 0.2});
    mesh.node_boundary.push_back(Boundary::FixedBone);
  }
  return mesh;
}

BonePartition partition_at(double r)
{
  const ScalarGrid bone = box_bone();
  return cut_bone(bone, bone, {cut_at(r, 20)});
}

TEST(Contact, NodesHangOnTheirBoneAndAreFreeAlongTheCut)
{
  MixedMesh mesh = row_of_nodes();
  const ContactReport report = assign_contacts(mesh, partition_at(5), 5);
  ASSERT_EQ(mesh.fragments, std::vector<std::string>{"end"});
  for (std::size_t n = 0; n < mesh.X.size(); ++n)
  {
    const double from_cut = mesh.X[n].x() - 5;
    if (std::abs(from_cut) > 4.5 && std::abs(from_cut) < 5.5)
      continue; // at the margin itself the lattice decides
    const Boundary expected = std::abs(from_cut) < 5 ? Boundary::Free
                              : from_cut > 0         ? Boundary::Fragment
                                                     : Boundary::FixedBone;
    EXPECT_EQ(mesh.node_boundary[n], expected) << mesh.X[n].x();
    EXPECT_EQ(mesh.node_fragment[n], expected == Boundary::Fragment ? 0 : -1) << mesh.X[n].x();
  }
  EXPECT_EQ(report.fixed + report.fragments.at(0) + report.released, mesh.node_count());
}

TEST(Contact, WithoutMarginEveryNodeHangsOnBone)
{
  MixedMesh mesh = row_of_nodes();
  const ContactReport report = assign_contacts(mesh, partition_at(5), 0);
  EXPECT_EQ(report.released, 0);
  EXPECT_EQ(report.fragments.at(0), 12); // 6, 8, ..., 28
  EXPECT_EQ(report.fixed, 17);
}

TEST(Contact, OtherBoundaryPartsStay)
{
  MixedMesh mesh = row_of_nodes();
  const Boundary others[] = {Boundary::Interior, Boundary::Skin, Boundary::Free, Boundary::Crop};
  for (const Boundary other : others)
  {
    mesh.X.push_back({20, 20.3, 0});
    mesh.node_boundary.push_back(other);
  }
  assign_contacts(mesh, partition_at(5), 5);
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_EQ(mesh.node_boundary[mesh.X.size() - 4 + i], others[i]);
    EXPECT_EQ(mesh.node_fragment[mesh.X.size() - 4 + i], -1);
  }
}

TEST(Contact, FragmentWithoutTissueIsRefused)
{
  MixedMesh mesh = row_of_nodes();
  expect_error([&] { assign_contacts(mesh, partition_at(5), 22); },
               {"'end'", "3 are needed", "release margin"});
}

TEST(Contact, NearestBoneIsUncutWhereThereIsNone)
{
  const BonePartition partition = partition_at(5);
  EXPECT_EQ(nearest_bone(partition.labels, {20, 22, 0}), BonePartition::first_fragment);
  EXPECT_EQ(nearest_bone(partition.labels, {-20, 22, 0}), BonePartition::uncut);
  EXPECT_EQ(nearest_bone(partition.labels, {20, 29, 0}), BonePartition::uncut);
  EXPECT_EQ(nearest_bone(partition.labels, {500, 0, 0}), BonePartition::uncut);
}

TEST(Contact, AreaCentroidWeighsFacesByArea)
{
  // a large and a small triangle
  const TriangleMesh mesh{{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {10, 0, 0}, {13, 0, 0}, {10, 3, 0}},
                          {{0, 1, 2}, {3, 4, 5}}};
  EXPECT_NEAR(
      (area_centroid(mesh) - Vec3((18 * 2 + 4.5 * 11) / 22.5, (18 * 2 + 4.5 * 1) / 22.5, 0)).norm(),
      0, 1e-12);
}

} // namespace
} // namespace f2b
