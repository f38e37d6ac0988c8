#include "Core/geometry/bone_overlap.hpp"
#include "Core/geometry/osteotomy.hpp"
#include "Core/mesh/tissue_stretch.hpp"
#include "Logic/Core/slab_mesh.hpp"

#include <gtest/gtest.h>

namespace f2b
{
namespace
{

/// A bar of bone along S, cut in two at S = 0: the upper half moves.
struct CutBar
{
  CutBar()
  {
    bone.origin = Vec3(-20, -20, -30);
    bone.size = Eigen::Vector3i(41, 41, 61);
    bone.values.resize(bone.count());
    labels = {bone.origin, bone.spacing, bone.size,
              std::vector<unsigned char>(bone.count(), BonePartition::no_bone)};
    for (int k = 0; k < 61; ++k)
      for (int j = 0; j < 41; ++j)
        for (int i = 0; i < 41; ++i)
        {
          const Vec3 p = bone.position(i, j, k);
          const double inside =
              std::max({std::abs(p.x()) - 10.5, std::abs(p.y()) - 10.5, std::abs(p.z()) - 20.5});
          bone.values[bone.index(i, j, k)] = float(inside);
          if (inside < 0)
            labels.values[bone.index(i, j, k)] =
                p.z() > 0 ? BonePartition::first_fragment : BonePartition::uncut;
        }
  }
  BoneOverlap moved_by(const Vec3& t) const
  {
    RigidMotion motion;
    motion.translation = t;
    return overlap_with_uncut_bone(bone, labels, BonePartition::first_fragment, motion);
  }
  ScalarGrid bone;
  LabelGrid labels;
};

TEST(BoneOverlap, IsNoneAtRestAndAwayFromTheOtherBone)
{
  const CutBar bar;
  EXPECT_EQ(bar.moved_by({0, 0, 0}).volume_mm3, 0);
  EXPECT_EQ(bar.moved_by({3, 0, 5}).volume_mm3, 0);
}

TEST(BoneOverlap, IsAsDeepAsTheFragmentWasPushedIn)
{
  const CutBar bar;
  const BoneOverlap overlap = bar.moved_by({0, 0, -3});
  EXPECT_NEAR(overlap.depth_mm, 3, 1.01);
  EXPECT_NEAR(overlap.volume_mm3, 21 * 21 * 3, 0.02 * 21 * 21 * 3);
}

TEST(TissueStretch, AnAffineStretchIsFoundEverywhere)
{
  const MixedMesh mesh = testing::make_slab({});
  std::vector<Vec3> x = mesh.X;
  for (Vec3& p : x)
    p.x() *= 1.25;
  const TissueStretch stretch = tissue_stretch(mesh, x);
  EXPECT_NEAR(stretch.max, 1.25, 1e-12);
  EXPECT_NEAR(stretch.p99, 1.25, 1e-12);
}

} // namespace
} // namespace f2b
