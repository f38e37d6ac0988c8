#include "Core/element/hermite_triangle.hpp"
#include "Core/element/triangle_rule.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <random>

namespace f2b
{
namespace
{

Vec3 inside(std::mt19937& generator)
{
  std::uniform_real_distribution<double> u(0.05, 1);
  const Vec3 L(u(generator), u(generator), u(generator));
  return L / L.sum();
}

Mat3 random_triangle(std::mt19937& generator)
{
  std::uniform_real_distribution<double> u(-0.4, 0.4);
  Mat3 X;
  X << 0, 3, 1, 0, 0, 2, 0, 0, 0;
  for (int i = 0; i < 3; ++i)
    X.col(i) += Vec3(u(generator), u(generator), 0);
  return X;
}

/// Degrees of freedom of a function with values f and gradients g at a triangle's corners.
template <class F, class G>
Eigen::Matrix<double, 9, 1> sampled(const Mat3& X, const F& f, const G& g)
{
  Eigen::Matrix<double, 9, 1> d;
  for (int i = 0; i < 3; ++i)
  {
    const Vec3 x = X.col(i);
    d[3 * i] = f(x);
    for (int step = 1; step < 3; ++step)
      d[3 * i + step] = g(x).dot(Vec3(X.col((i + step) % 3)) - x);
  }
  return d;
}

TEST(TriangleRule, IsExactToItsDegree)
{
  auto factorial = [](int n) { return std::tgamma(n + 1.0); };
  const std::pair<int, int> rules[] = {{3, 2}, {6, 4}, {7, 5}, {12, 6}, {96, 6}};
  for (const auto& [points, degree] : rules)
  {
    double worst = 0, beyond = 0;
    for (int i = 0; i <= degree + 1; ++i)
      for (int j = 0; i + j <= degree + 1; ++j)
      {
        double sum = 0;
        for (const TrianglePoint& at : triangle_rule(points))
        {
          EXPECT_GT(at.L.minCoeff(), 0);
          sum += at.weight * std::pow(at.L[0], i) * std::pow(at.L[1], j);
        }
        const double exact = 2 * factorial(i) * factorial(j) / factorial(i + j + 2);
        (i + j <= degree ? worst : beyond) =
            std::max(i + j <= degree ? worst : beyond, std::abs(sum - exact));
      }
    std::printf("triangle rule of %2d points: error %.1e to degree %d, %.1e at degree %d\n", points,
                worst, degree, beyond, degree + 1);
    EXPECT_LT(worst, 1e-14);
  }
}

TEST(HermiteTriangle, ReproducesQuadraticsWithAndWithoutCorrection)
{
  std::mt19937 generator(1);
  double worst_affine = 0, worst_quadratic = 0, unity = 0;
  for (int trial = 0; trial < 20; ++trial)
  {
    const Mat3 X = random_triangle(generator);
    const EdgeCorrection correction = edge_correction(X);
    auto affine = [](const Vec3& x) { return 1 + 2 * x[0] - 3 * x[1]; };
    auto affine_slope = [](const Vec3&) { return Vec3(2, -3, 0); };
    auto quadratic = [](const Vec3& x) { return x[0] * x[0] - 2 * x[0] * x[1] + 3 * x[1] * x[1]; };
    auto quadratic_slope = [](const Vec3& x)
    { return Vec3(2 * x[0] - 2 * x[1], 6 * x[1] - 2 * x[0], 0); };
    for (const EdgeCorrection& c : {correction, EdgeCorrection(EdgeCorrection::Zero())})
    {
      const Vec3 L = inside(generator), x = X * L;
      const HermiteFunctions N = hermite_functions(c, L);
      unity = std::max(unity, std::abs(N.value[0] + N.value[3] + N.value[6] - 1));
      worst_affine = std::max(worst_affine,
                              std::abs(N.value.dot(sampled(X, affine, affine_slope)) - affine(x)));
      worst_quadratic =
          std::max(worst_quadratic,
                   std::abs(N.value.dot(sampled(X, quadratic, quadratic_slope)) - quadratic(x)));
    }
  }
  std::printf("partition of unity %.1e, affine %.1e, quadratic %.1e\n", unity, worst_affine,
              worst_quadratic);
  EXPECT_LT(unity, 1e-14);
  EXPECT_LT(worst_affine, 1e-13);
  EXPECT_LT(worst_quadratic, 1e-12);
}

TEST(HermiteTriangle, SlopesAreDerivatives)
{
  std::mt19937 generator(2);
  double worst = 0;
  for (int trial = 0; trial < 20; ++trial)
  {
    const EdgeCorrection correction = edge_correction(random_triangle(generator));
    const Vec3 L = inside(generator);
    const double h = 1e-6;
    for (const Vec3& d : {Vec3(1, -1, 0), Vec3(0, 1, -1), Vec3(-1, 0, 1)})
    {
      const Eigen::Matrix<double, 9, 1> difference =
          (hermite_functions(correction, L + h * d).value -
           hermite_functions(correction, L - h * d).value) /
          (2 * h);
      worst = std::max(
          worst, (difference - hermite_functions(correction, L).slope * d).cwiseAbs().maxCoeff());
    }
  }
  std::printf("slopes against central differences: %.1e\n", worst);
  EXPECT_LT(worst, 1e-8);
}

TEST(HermiteTriangle, EdgesAndCornersAreTheLimits)
{
  std::mt19937 generator(3);
  const EdgeCorrection correction = edge_correction(random_triangle(generator));
  double worst = 0;
  for (const Vec3& L : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0.3, 0.7, 0),
                        Vec3(0, 0.5, 0.5), Vec3(0.9, 0, 0.1)})
  {
    const HermiteFunctions at = hermite_functions(correction, L);
    ASSERT_TRUE(at.value.allFinite() && at.slope.allFinite());
    const double near = 1e-8;
    const HermiteFunctions close =
        hermite_functions(correction, (1 - near) * L + near * Vec3(0.2, 0.3, 0.5));
    worst = std::max({worst, (at.value - close.value).cwiseAbs().maxCoeff(),
                      (at.slope - close.slope).cwiseAbs().maxCoeff()});
  }
  std::printf("jump over 1e-8 from edges and corners: %.1e\n", worst);
  EXPECT_LT(worst, 1e-6);
  for (int i = 0; i < 3; ++i)
  {
    // at a corner: its own degrees of freedom and no others
    const HermiteFunctions at = hermite_functions(correction, Vec3::Unit(i));
    EXPECT_EQ(at.value, (Eigen::Matrix<double, 9, 1>::Unit(3 * i)));
    for (int step = 1; step < 3; ++step)
      EXPECT_LT((at.slope * (Vec3::Unit((i + step) % 3) - Vec3::Unit(i)) -
                 Eigen::Matrix<double, 9, 1>::Unit(3 * i + step))
                    .norm(),
                1e-15);
  }
}

TEST(HermiteTriangle, TheSlopeAcrossASharedEdgeIsContinuous)
{
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> u(-1, 1);
  double with = 0, without = 0;
  for (int trial = 0; trial < 100; ++trial)
  {
    // two flat triangles on the edge from P to Q, with random values and gradients at the corners
    const Mat3 X = random_triangle(generator);
    const Vec3 P = X.col(0), Q = X.col(1), A = X.col(2);
    const Vec3 B = 0.5 * (P + Q) + Vec3(u(generator), -1.5 + 0.5 * u(generator), 0);
    Mat3 one, two;
    one << P, Q, A;
    two << Q, P, B;
    Eigen::Matrix<double, 4, 1> value;
    Eigen::Matrix<double, 3, 4> gradient;
    for (int i = 0; i < 4; ++i)
    {
      value[i] = u(generator);
      gradient.col(i) << u(generator), u(generator), 0;
    }
    auto degrees = [&](const Mat3& T, const std::array<int, 3>& node)
    {
      Eigen::Matrix<double, 9, 1> d;
      for (int i = 0; i < 3; ++i)
      {
        const int n = node[static_cast<std::size_t>(i)];
        d[3 * i] = value[n];
        for (int step = 1; step < 3; ++step)
          d[3 * i + step] = gradient.col(n).dot(T.col((i + step) % 3) - T.col(i));
      }
      return d;
    };
    const Vec3 normal = Vec3::UnitZ().cross(Q - P).normalized();
    auto slope = [&](const Mat3& T, const Eigen::Matrix<double, 9, 1>& d, const Vec3& L, bool star)
    {
      Mat3 system;
      system << T.row(0), T.row(1), Eigen::RowVector3d::Ones();
      const Vec3 dL = system.inverse() * Vec3(normal[0], normal[1], 0);
      const EdgeCorrection c = star ? edge_correction(T) : EdgeCorrection(EdgeCorrection::Zero());
      return d.dot(hermite_functions(c, L).slope * dL);
    };
    for (const double share : {0.1, 0.35, 0.5, 0.8})
      for (const bool star : {false, true})
      {
        const double jump =
            std::abs(slope(one, degrees(one, {0, 1, 2}), {1 - share, share, 0}, star) -
                     slope(two, degrees(two, {1, 0, 3}), {share, 1 - share, 0}, star));
        (star ? with : without) = std::max(star ? with : without, jump);
      }
  }
  std::printf("jump of the normal slope over an edge: N9 %.3g, N9* %.1e\n", without, with);
  EXPECT_LT(with, 1e-12);
  EXPECT_GT(without, 0.1);
}

} // namespace
} // namespace f2b
