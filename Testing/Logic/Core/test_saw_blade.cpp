#include "Logic/Core/box_bone.hpp"
#include "expect_error.hpp"

#include <Core/geometry/saw_blade.hpp>

#include <cmath>
#include <map>

namespace f2b
{
namespace
{

using test::expect_error;
using testing::box_bone;
using testing::plane_at;

constexpr unsigned char first = BonePartition::first_fragment;

double volume_of(const TriangleMesh& mesh)
{
  double sum = 0;
  for (const Triangle& t : mesh.triangles)
    sum += mesh.points[static_cast<std::size_t>(t[0])].dot(
               mesh.points[static_cast<std::size_t>(t[1])].cross(
                   mesh.points[static_cast<std::size_t>(t[2])])) /
           6;
  return sum;
}

bool is_closed(const TriangleMesh& mesh)
{
  std::map<std::pair<int, int>, int> uses;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t c = 0; c < 3; ++c)
      ++uses[{t[c], t[(c + 1) % 3]}];
  for (const auto& [edge, count] : uses)
    if (count != 1 || uses.count({edge.second, edge.first}) == 0)
      return false;
  return true;
}

/// On top of the block, along A, sawn downwards.
SweptCurve straight_curve()
{
  return {"top", {{5, -28, 15}, {5, 0, 15}, {5, 28, 15}}, false, -Vec3::UnitZ(), 40, 5};
}

/// A circle of 10 mm on top of the block.
SweptCurve round_curve()
{
  SweptCurve curve = straight_curve();
  curve.closed = true;
  curve.points.clear();
  for (int i = 0; i < 64; ++i)
  {
    const double a = 2 * 3.14159265358979 * i / 64;
    curve.points.push_back({10 * std::cos(a), 10 * std::sin(a), 15});
  }
  return curve;
}

TEST(SawBlade, OfAPlaneIsABox)
{
  const TriangleMesh blade = blade_of(plane_at(5), 1.5);
  EXPECT_TRUE(is_closed(blade));
  EXPECT_NEAR(volume_of(blade), 56 * 44 * 1.5, 1e-9);
  EXPECT_NEAR(volume_of(blade_of(plane_at(5), 0)), 56 * 44 * thinnest_kerf_mm, 1e-9);
}

TEST(SawBlade, OfAStraightCurveIsTheSameBox)
{
  const TriangleMesh blade = blade_of(straight_curve(), 1);
  EXPECT_TRUE(is_closed(blade));
  EXPECT_NEAR(volume_of(blade), 56 * 45, 1e-9);
  for (const Vec3& p : blade.points)
    EXPECT_NEAR(std::abs(p.x() - 5), 0.5, 1e-12);
}

TEST(SawBlade, OfACornerKeepsItsWidth)
{
  SweptCurve curve = straight_curve();
  curve.points = {{-20, 0, 15}, {0, 0, 15}, {0, 20, 15}};
  EXPECT_NEAR(volume_of(blade_of(curve, 1)), 40 * 45, 1e-9) << "mitre: middle line times width";
}

TEST(SawBlade, OfAClosedCurveIsATube)
{
  const TriangleMesh blade = blade_of(round_curve(), 1);
  EXPECT_TRUE(is_closed(blade));
  EXPECT_NEAR(volume_of(blade), 2 * 3.14159265358979 * 10 * 45, 15);
}

TEST(SawBlade, CurvesThatCrossThemselvesAreRefused)
{
  SweptCurve loop = straight_curve();
  loop.points = {{0, 0, 15}, {10, 0, 15}, {10, 10, 15}, {5, 10, 15}, {5, -5, 15}};
  expect_error([&] { (void)blade_of(loop, 1); },
               {"'top'", "comes back to itself", "without loops"});
  SweptCurve spike = straight_curve();
  spike.points = {{0, 0, 15}, {10, 0, 15}, {1, 0.5, 15}};
  expect_error([&] { (void)blade_of(spike, 1); }, {"'top'", "turns back on itself at (10.0, 0.0"});
  SweptCurve stood_on_end = straight_curve();
  stood_on_end.points = {{0, 0, 15}, {0, 0, 5}};
  expect_error([&] { (void)blade_of(stood_on_end, 1); }, {"'top'", "turn the saw direction"});
  SweptCurve flat = straight_curve();
  flat.depth_mm = flat.lead_mm = 0;
  expect_error([&] { (void)blade_of(flat, 1); }, {"'top'", "no depth"});
}

TEST(SweptCurve, SplinePassesThroughItsPointsAndLinesStayStraight)
{
  const std::vector<Vec3> drawn = {{0, 0, 0}, {10, 5, 0}, {10, 5, 0}, {20, 0, 3}};
  for (const bool straight : {false, true})
  {
    const std::vector<Vec3> points = resampled_curve(drawn, false, straight, 1);
    EXPECT_GT(points.size(), 20U);
    for (const Vec3& p : drawn)
    {
      double nearest = 1e9;
      for (const Vec3& q : points)
        nearest = std::min(nearest, (p - q).norm());
      EXPECT_LT(nearest, 1e-12);
    }
    for (std::size_t i = 1; i < points.size(); ++i)
      EXPECT_LT((points[i] - points[i - 1]).norm(), 1.3);
  }
  const std::vector<Vec3> ring =
      resampled_curve({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, true, false, 0.2);
  for (const Vec3& p : ring)
    EXPECT_NEAR(p.norm(), 1, 0.13);
}

TEST(Osteotomy, CurveFreesTheSideOfTheFragmentPoint)
{
  const ScalarGrid bone = box_bone();
  Osteotomy cut;
  cut.fragment = "end";
  cut.curves = {straight_curve()};
  cut.fragment_point = {20, 0, 0};
  const BonePartition partition = cut_bone(bone, bone, {cut});
  EXPECT_EQ(partition.labels.nearest({20, 0, 0}), first);
  EXPECT_EQ(partition.labels.nearest({-20, 0, 0}), BonePartition::uncut);
  EXPECT_NEAR(partition.fragment_volume_mm3.at(0), 25 * 40 * 30, 0.02 * 25 * 40 * 30);
  cut.curves[0].depth_mm = 20;
  expect_error([&] { cut_bone(bone, bone, {cut}); }, {"curve 'top'", "do not free"});
}

TEST(Osteotomy, ClosedCurveFreesAPlug)
{
  const ScalarGrid bone = box_bone();
  Osteotomy cut;
  cut.fragment = "plug";
  cut.curves = {round_curve()};
  cut.fragment_point = {0, 0, 0};
  const BonePartition partition = cut_bone(bone, bone, {cut});
  EXPECT_EQ(partition.labels.nearest({0, 0, 0}), first);
  EXPECT_EQ(partition.labels.nearest({15, 0, 0}), BonePartition::uncut);
  EXPECT_NEAR(partition.fragment_volume_mm3.at(0), 3.14159 * 100 * 30, 0.05 * 3.14159 * 100 * 30);
}

} // namespace
} // namespace f2b
