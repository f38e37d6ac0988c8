#include "Core/assembly/discretization.hpp"
#include "Core/error.hpp"
#include "Core/mesh/skin_crease.hpp"
#include "Logic/Core/ball_mesh.hpp"
#include "Logic/Core/dense_model.hpp"
#include "Logic/Core/slab_mesh.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <random>

namespace f2b
{
namespace
{

using namespace testing;

/// Tetrahedra under a skin with a groove around it, whose walls meet at up to 137 degrees: too sharp
/// for a smooth face at its ends.
MixedMesh grooved_ball()
{
  MixedMesh mesh = make_ball(2, 12, 1.5);
  const std::size_t n = (mesh.X.size() - 1) / 2;
  const Vec3 axis(0.36, 0.48, 0.8);
  for (std::size_t i = 1; i <= n; ++i)
  {
    const double height = mesh.X[i + n].normalized().dot(axis);
    const Vec3 inwards = -0.7 * std::exp(-std::abs(height) / 0.15) * mesh.X[i + n];
    mesh.X[i] += inwards;
    mesh.X[i + n] += inwards;
  }
  return mesh;
}

TEST(SmoothSkin, NormalsAreExactOnASphere)
{
  const MixedMesh mesh = make_ball(2, 50, 1.5);
  double worst = 0, skew = 0;
  for (const SkinTangents& t : skin_tangents(mesh))
  {
    worst = std::max(worst, (t.normal - mesh.X[std::size_t(t.node)].normalized()).norm());
    skew = std::max(
        {skew, std::abs(t.normal.dot(t.tangent[0])), std::abs(t.tangent[0].dot(t.tangent[1]))});
    EXPECT_NEAR(t.tangent[0].norm(), t.tangent[1].norm(), 1e-12);
  }
  std::printf("normals of a sphere: %.1e off\n", worst);
  EXPECT_LT(worst, 1e-14);
  EXPECT_LT(skew, 1e-12);
}

TEST(SmoothSkin, TheFaceLiesOnTheSphereWhereFacetsCutIt)
{
  const MixedMesh mesh = make_ball(2, 50, 1.5);
  const SmoothSkin skin(mesh);
  const std::vector<Vec3> rest = skin.rest();
  double smooth = 0, facet = 0;
  for (int p = 0; p < int(mesh.prisms.size()); ++p)
    for (const TrianglePoint& at : corner_graded_rule(3))
    {
      smooth = std::max(smooth, std::abs(skin.surface_point(p, at.L, rest).point.norm() - 50));
      Vec3 flat = Vec3::Zero();
      for (int i = 0; i < 3; ++i)
        flat += at.L[i] * mesh.X[std::size_t(mesh.prisms[std::size_t(p)][std::size_t(i)])];
      facet = std::max(facet, std::abs(flat.norm() - 50));
    }
  std::printf("largest distance from a sphere of radius 50 mm with 320 faces: facets %.3f mm, "
              "smooth %.4f mm\n",
              facet, smooth);
  EXPECT_LT(smooth, 0.05 * facet);
}

TEST(SmoothSkin, CreasesAreTenTimesBelowTheFacetsAtRestAndDeformed)
{
  const MixedMesh mesh = make_ball(2, 50, 1.5);
  const Discretization tissue(mesh, {SkinElement::Smooth});
  // bend, stretch and shear by up to a third
  auto map = [](const Vec3& X)
  {
    return Vec3(X[0] + 6 * std::sin(X[1] / 25), X[1] + 0.004 * X[2] * X[2],
                X[2] * (1 + 0.003 * X[0]));
  };
  auto slope = [](const Vec3& X)
  {
    Mat3 J = Mat3::Identity();
    J(0, 1) = 6. / 25 * std::cos(X[1] / 25);
    J(1, 2) = 0.008 * X[2];
    J(2, 0) = 0.003 * X[2];
    J(2, 2) = 1 + 0.003 * X[0];
    return J;
  };
  const std::vector<Vec3> rest = tissue.rest(), x = tissue.mapped_rest(map, slope);
  for (const auto& [name, state] : {std::pair{"rest", &rest}, std::pair{"deformed", &x}})
  {
    const SkinCrease linear = linear_skin_crease(mesh, *state);
    const SkinCrease smooth = smooth_skin_crease(*tissue.smooth_skin(), *state);
    std::printf("%s, 320 faces, %ld edges: mean crease %.3f deg (max %.2f) linear, %.4f (max "
                "%.3f) smooth: %.0f times\n",
                name, smooth.edges, linear.mean_deg, linear.max_deg, smooth.mean_deg,
                smooth.max_deg, linear.mean_deg / smooth.mean_deg);
    EXPECT_EQ(smooth.edges, 480);
    EXPECT_LT(smooth.mean_deg, 0.1 * linear.mean_deg);
  }
}

TEST(SmoothSkin, SurfaceWeightsReproduceAffineMapsUpToEdgesAndCorners)
{
  const MixedMesh mesh = make_slab({5, 1, 40, 8, 1.5, 6, 0.5});
  const SmoothSkin skin(mesh);
  const std::vector<Vec3> rest = skin.rest();
  double unity = 0, corner = 0;
  for (int p = 0; p < int(mesh.prisms.size()); ++p)
    for (const Vec3& L : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0.5, 0.5, 0),
                          Vec3(0.2, 0, 0.8), Vec3(0.3, 0.3, 0.4)})
    {
      const SurfaceWeights weights = skin.surface_weights(p, L);
      double sum = 0;
      Vec3 point = Vec3::Zero();
      for (std::size_t i = 0; i < 9; ++i)
      {
        const double w = weights.weight[Eigen::Index(i)];
        sum += weights.control[i] < mesh.node_count() ? w : 0;
        point += w * rest[std::size_t(weights.control[i])];
      }
      unity = std::max(unity, std::abs(sum - 1));
      const SurfacePoint direct = skin.surface_point(p, L, rest);
      EXPECT_LT((direct.point - point).norm(), 1e-12);
      EXPECT_NEAR(direct.normal.norm(), 1, 1e-12);
      for (int i = 0; i < 3; ++i)
        if (L[i] == 1)
          corner = std::max(
              corner,
              (point - mesh.X[std::size_t(mesh.prisms[std::size_t(p)][std::size_t(i)])]).norm());
    }
  std::printf("weights of positions sum to 1 within %.1e; corners %.1e mm off\n", unity, corner);
  EXPECT_LT(unity, 1e-13);
  EXPECT_LT(corner, 1e-12);
}

TEST(SmoothSkin, NormalsAtARimNodeAreThoseOfItsFacets)
{
  const MixedMesh mesh = make_slab({4, 1, 40, 8, 1.5, 0, 0.5}); // flat, open at its rim
  const SmoothSkin skin(mesh);
  EXPECT_EQ(skin.tangents().size(), 25u);
  for (const SkinTangents& t : skin.tangents())
    EXPECT_LT((t.normal - Vec3::UnitZ()).norm(), 1e-15);
}

TEST(SmoothSkin, HeldNodesOfTheFaceAreClamped)
{
  const MixedMesh mesh = make_slab({4, 1, 40, 8, 1.5, 3, 0.5});
  const Discretization tissue(mesh, {SkinElement::Smooth});
  std::vector<char> held(mesh.X.size(), 0);
  const int node = mesh.prisms[7][1];
  held[std::size_t(node)] = 1;
  const std::vector<char> flags = tissue.control_flags(held);
  ASSERT_EQ(flags.size(), tissue.control_count());
  const auto slope = std::size_t(tissue.smooth_skin()->slope_control(node));
  EXPECT_EQ(std::count(flags.begin(), flags.end(), 1), 3);
  EXPECT_TRUE(flags[slope] && flags[slope + 1]);
}

/// Moves the outside by an affine map; inner nodes, and the face with its slopes under the traction
/// of the constant stress, must follow.
struct Patch
{
  double displacement = 0; ///< largest error of a control vector [mm]
  double stress = 0;       ///< largest error relative to the stress
};

Patch run_patch(const SmoothSkin& skin, bool face_is_free)
{
  Mat3 A;
  A << 1.10, 0.05, 0.02, -0.04, 0.95, 0.03, 0.01, -0.06, 1.05;
  const DenseModel<SmoothPrism> model(skin, make_smooth_prism<6>);
  const std::vector<Vec3> rest = skin.rest();
  std::vector<Vec3> exact = rest;
  for (Vec3& p : exact)
    p = A * p;
  const Mat3 P = model.law().stress(A);
  const Eigen::VectorXd load = face_traction(skin, P);
  std::vector<char> held(rest.size(), 0);
  if (face_is_free)
    for (const int corner : skin.mesh().tets[0])
      held[std::size_t(corner)] = 1; // no rigid motion
  else
    for (std::size_t c = 0; c < rest.size(); ++c)
      held[c] = c > (skin.mesh().X.size() - 1) / 2;
  held[0] = 1;
  std::vector<Vec3> x = exact;
  std::mt19937 generator(9);
  std::uniform_real_distribution<double> u(-0.01, 0.01);
  for (std::size_t c = 0; c < x.size(); ++c)
    if (!held[c])
      x[c] += Vec3(u(generator), u(generator), u(generator));
  EXPECT_LT(model.solve(x, held, load), 1e-10);
  Patch patch;
  for (std::size_t c = 0; c < x.size(); ++c)
    patch.displacement = std::max(patch.displacement, (x[c] - exact[c]).norm());
  patch.stress = model.stress_deviation(x, P) / P.norm();
  return patch;
}

TEST(PatchTest, AffineFieldIsExactUnderASmoothSphericalFace)
{
  const MixedMesh mesh = make_ball(1, 12, 1.5);
  const SmoothSkin skin(mesh);
  for (const bool face_is_free : {false, true})
  {
    const Patch patch = run_patch(skin, face_is_free);
    std::printf("ball of tets and smooth prisms, %s: displacement %.1e mm, stress %.1e\n",
                face_is_free ? "face and slopes free under traction" : "face moved",
                patch.displacement, patch.stress);
    EXPECT_LT(patch.displacement, 1e-10);
    EXPECT_LT(patch.stress, 1e-10);
  }
}

TEST(SmoothSkin, AFoldedPrismBecomesStraightAndStaysConforming)
{
  const MixedMesh mesh = grooved_ball();
  const SmoothSkin skin(mesh);
  const std::vector<Vec3> rest = skin.rest();
  std::printf("grooved ball: %zu prisms fold, %zu edges straight\n", skin.folded_prisms().size(),
              skin.straight_edges().size());
  ASSERT_FALSE(skin.folded_prisms().empty());
  ASSERT_LT(skin.folded_prisms().size(), mesh.prisms.size());
  const std::vector<Vec3> x = [&]
  {
    std::mt19937 generator(10);
    std::uniform_real_distribution<double> u(-0.5, 0.5);
    std::vector<Vec3> shaken = rest;
    for (Vec3& p : shaken)
      p += Vec3(u(generator), u(generator), u(generator));
    return shaken;
  }();
  // every edge's points from both sides, in any state
  std::map<std::pair<int, int>, std::pair<int, Vec3>> first;
  double gap = 0;
  int shared = 0;
  for (int p = 0; p < int(mesh.prisms.size()); ++p)
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const int a = mesh.prisms[std::size_t(p)][std::size_t(i)];
      const int b = mesh.prisms[std::size_t(p)][std::size_t(j)];
      const double share = a < b ? 0.3 : 0.7; // from node a to node b
      const Vec3 point =
          skin.surface_point(p, (1 - share) * Vec3::Unit(i) + share * Vec3::Unit(j), x).point;
      const auto [entry, is_new] = first.emplace(std::minmax(a, b), std::pair{p, point});
      if (is_new)
        continue;
      ++shared;
      gap = std::max(gap, (point - entry->second.second).norm());
    }
  EXPECT_EQ(shared, 480);
  double curved = 0;
  for (const int p : skin.folded_prisms())
  {
    Vec3 flat = Vec3::Zero();
    const Vec3 L(0.2, 0.5, 0.3);
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_TRUE(skin.is_straight(p, i));
      flat += L[i] * x[std::size_t(mesh.prisms[std::size_t(p)][std::size_t(i)])];
    }
    curved = std::max(curved, (skin.surface_point(p, L, x).point - flat).norm());
  }
  const Patch patch = run_patch(skin, false);
  std::printf("edges seen from both sides: %.1e mm apart; straight prisms %.1e mm off their facet; "
              "patch test %.1e mm, stress %.1e\n",
              gap, curved, patch.displacement, patch.stress);
  EXPECT_LT(gap, 1e-12);
  EXPECT_LT(curved, 1e-12);
  EXPECT_LT(patch.displacement, 1e-10);
  EXPECT_LT(patch.stress, 1e-10);
}

TEST(SmoothSkin, APrismInsideOutIsRefused)
{
  MixedMesh mesh = make_ball(1, 12, 1.5);
  std::swap(mesh.prisms[3][1], mesh.prisms[3][2]);
  std::swap(mesh.prisms[3][4], mesh.prisms[3][5]);
  EXPECT_THROW(SmoothSkin{mesh}, Error);
}

} // namespace
} // namespace f2b
