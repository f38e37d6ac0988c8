#include "Core/mesh/tissue_stretch.hpp"
#include "Logic/Core/slab_mesh.hpp"

#include <gtest/gtest.h>

namespace f2b
{
namespace
{

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
