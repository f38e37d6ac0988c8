#include "Logic/Core/sphere_mesh.hpp"

#include <Core/sculpting/geodesic_distance.hpp>
#include <Core/sculpting/surface_tree.hpp>

#include <gtest/gtest.h>

#include <random>

namespace f2b
{
namespace
{

using testing::icosphere;

TriangleMesh ball(int subdivisions, double radius)
{
  TriangleMesh mesh = icosphere(subdivisions);
  for (Vec3& p : mesh.points)
    p *= radius;
  return mesh;
}

/// The first hit by trying every triangle, each as a tree of its own.
double first_hit_by_force(const TriangleMesh& mesh, const Vec3& origin, const Vec3& direction)
{
  double best = std::numeric_limits<double>::infinity();
  for (const Triangle& t : mesh.triangles)
  {
    TriangleMesh one;
    for (const int v : t)
      one.points.push_back(mesh.points[std::size_t(v)]);
    one.triangles = {{0, 1, 2}};
    if (const auto hit = SurfaceTree(one).first_hit(origin, direction))
      best = std::min(best, hit->distance);
  }
  return best;
}

TEST(SurfaceTree, FindsTheFirstOfTwoWalls)
{
  const TriangleMesh mesh = ball(3, 50);
  const SurfaceTree tree(mesh);
  const auto hit = tree.first_hit({1, 2, 200}, {0, 0, -1});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->point.z(), 50, 0.5);
  EXPECT_NEAR(hit->distance, 200 - hit->point.z(), 1e-12);
  EXPECT_NEAR(hit->weights.sum(), 1, 1e-12);
  EXPECT_FALSE(tree.first_hit({1, 2, 200}, {0, 0, 1}));
  EXPECT_FALSE(tree.first_hit({1, 2, 200}, {0, 0, -1}, 100));
  EXPECT_FALSE(tree.first_hit({60, 0, 200}, {0, 0, -1}));
}

TEST(SurfaceTree, StaysRightWhilePointsMove)
{
  TriangleMesh mesh = ball(2, 50);
  SurfaceTree tree(mesh);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int round = 0; round < 20; ++round)
  {
    std::vector<int> changed;
    for (int k = 0; k < 15; ++k)
    {
      const auto v = static_cast<int>(random() % mesh.points.size());
      mesh.points[std::size_t(v)] += 8 * Vec3(unit(random), unit(random), unit(random));
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const int corner : mesh.triangles[t])
          if (corner == v)
            changed.push_back(static_cast<int>(t));
    }
    tree.update(changed);
    const SurfaceTree fresh(mesh);
    for (int ray = 0; ray < 10; ++ray)
    {
      const Vec3 origin = 150 * Vec3(unit(random), unit(random), unit(random)).normalized();
      const Vec3 direction =
          (20 * Vec3(unit(random), unit(random), unit(random)) - origin).normalized();
      const auto hit = tree.first_hit(origin, direction);
      ASSERT_TRUE(hit);
      EXPECT_NEAR(hit->distance, first_hit_by_force(mesh, origin, direction), 1e-9);
      EXPECT_EQ(tree.nearest(origin).distance, fresh.nearest(origin).distance);
    }
  }
}

TEST(SurfaceTree, NearestIsNoFartherThanAnySample)
{
  const TriangleMesh mesh = ball(2, 30);
  const SurfaceTree tree(mesh);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-60, 60);
  for (int k = 0; k < 50; ++k)
  {
    const Vec3 p(unit(random), unit(random), unit(random));
    const SurfacePlace place = tree.nearest(p);
    EXPECT_NEAR((place.point - p).norm(), place.distance, 1e-9);
    for (const Triangle& t : mesh.triangles)
      for (const Vec3& w : {Vec3(1, 0, 0), Vec3(0.5, 0.5, 0), Vec3(0.2, 0.3, 0.5)})
      {
        const Vec3 q = w[0] * mesh.points[std::size_t(t[0])] +
                       w[1] * mesh.points[std::size_t(t[1])] +
                       w[2] * mesh.points[std::size_t(t[2])];
        ASSERT_LE(place.distance, (q - p).norm() + 1e-9);
      }
  }
}

TEST(GeodesicDistance, IsTheArcOnASphere)
{
  const TriangleMesh mesh = ball(5, 50);
  const SurfaceLinks links(mesh.points.size(), mesh.triangles);
  const SurfaceTree tree(mesh);
  const auto place = tree.nearest(Vec3(10, 20, 60));
  GeodesicDistance distances(links);
  const auto& reached = distances.from(mesh.points, place, 40);
  ASSERT_GT(reached.size(), 1000u);
  double last = 0;
  for (const NearVertex& near : reached)
  {
    const Vec3& p = mesh.points[std::size_t(near.vertex)];
    const double arc = 50 * std::acos(std::min(1.0, p.normalized().dot(place.point.normalized())));
    EXPECT_NEAR(near.distance, arc, 0.02 * arc + 0.05);
    EXPECT_GE(near.distance, last);
    last = near.distance;
  }
  const auto arc_within = [&](const Vec3& p)
  { return 50 * std::acos(p.normalized().dot(place.point.normalized())) < 39; };
  EXPECT_GE(reached.size(), static_cast<std::size_t>(
                                std::count_if(mesh.points.begin(), mesh.points.end(), arc_within)));
}

} // namespace
} // namespace f2b
