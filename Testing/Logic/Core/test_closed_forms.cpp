#include "Core/solve/equilibrium.hpp"
#include "Logic/Core/slab_mesh.hpp"
#include "Logic/Core/sphere_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>

/// Does a hollow sphere blow up as the closed form says?
namespace f2b
{
namespace
{

using namespace testing;

constexpr double c1 = 0.01; // [MPa]
constexpr double c2 = 0.004;
constexpr double c3 = 0.002;

/// dW/d lambda of Yeoh's law for the stretches (lambda^-2, lambda, lambda).
double yeoh_slope(double l)
{
  const double e = 2 * l * l + std::pow(l, -4) - 3;
  return (c1 + e * (2 * c2 + 3 * c3 * e)) * (4 * l - 4 * std::pow(l, -5));
}

/// Inner pressure of an incompressible sphere, the outside free: the integral of
/// W'(lambda) / (lambda^3 - 1) over the hoop stretch from outside to inside (Ogden, Non-linear
/// Elastic Deformations, 1984, section 5.3.2), by Simpson's rule.
double closed_pressure(double stretch_inside, double stretch_outside)
{
  const int n = 2000;
  const double h = (stretch_inside - stretch_outside) / n;
  double sum = 0;
  for (int i = 0; i <= n; ++i)
  {
    const double l = stretch_outside + i * h;
    sum += (i == 0 || i == n ? 1 : i % 2 ? 4 : 2) * yeoh_slope(l) / (l * l * l - 1);
  }
  return sum * h / 3;
}

struct Inflation
{
  double pressure = 0;     ///< [MPa]
  double outer_radius = 0; ///< mean [mm]
  double closed_pressure = 0;
  double closed_outer_radius = 0;
};

/// Moves the inner wall outwards by a stretch; the pressure that does it is the work of the wall's
/// reactions by the change of the cavity's volume.
Inflation inflate(const SphereOptions& o, ElementScheme scheme, double stretch, double nu)
{
  const MixedMesh mesh = make_sphere(o);
  MaterialSet materials = soft_material(nu);
  const Discretization tissue(mesh, scheme);
  std::vector<char> wall(mesh.X.size());
  for (std::size_t n = 0; n < wall.size(); ++n)
    wall[n] = mesh.node_boundary[n] == Boundary::FixedBone;
  ElasticModel model(tissue, materials, tissue.control_flags(wall));
  std::vector<Vec3> x = tissue.rest(), target = x;
  for (std::size_t n = 0; n < wall.size(); ++n)
    if (wall[n])
      target[n] *= stretch;
  EXPECT_TRUE(EquilibriumSolver(model, {}).move_to(x, target).converged());

  ElasticModel all(tissue, materials, std::vector<char>(tissue.control_count(), 0));
  const Eigen::VectorXd reactions = all.forces(x);
  const TriangleMesh unit = icosphere(o.subdivisions);
  double work = 0, cavity = 0, outer = 0;
  const std::size_t count = unit.points.size();
  for (std::size_t n = 0; n < count; ++n)
  {
    work += reactions.segment<3>(3 * static_cast<Eigen::Index>(n)).dot(unit.points[n]);
    outer += x[mesh.X.size() - count + n].norm() / static_cast<double>(count);
  }
  for (const auto& t : unit.triangles)
    cavity += x[std::size_t(t[0])].dot(x[std::size_t(t[1])].cross(x[std::size_t(t[2])])) / 6;
  const double A = o.inner_mm, B = o.outer_mm + o.skin_mm;
  Inflation result;
  result.pressure = work / (3 * cavity / (stretch * A));
  result.outer_radius = outer;
  result.closed_outer_radius = std::cbrt(B * B * B + A * A * A * (std::pow(stretch, 3) - 1));
  result.closed_pressure = closed_pressure(stretch, result.closed_outer_radius / B);
  return result;
}

void print(const char* what, const Inflation& i)
{
  std::printf("%-30s pressure %.6f MPa (closed form %.6f, %+.2f %%), outer radius %.4f mm "
              "(%.4f, %+.3f %%)\n",
              what, i.pressure, i.closed_pressure, 100 * (i.pressure / i.closed_pressure - 1),
              i.outer_radius, i.closed_outer_radius,
              100 * (i.outer_radius / i.closed_outer_radius - 1));
}

TEST(ClosedForm, PressurisedThickSphere)
{
  const ElementScheme averaged{SkinElement::Linear, Dilatation::Averaged};
  const SphereOptions coarse{3, 4, 20, 30, 1.5}, fine{4, 7, 20, 30, 1.5};
  print("1280 faces, 4 layers, plain", inflate(coarse, {}, 1.3, 0.4999));
  print("1280 faces, 4 layers, averaged", inflate(coarse, averaged, 1.3, 0.4999));
  const Inflation best = inflate(fine, averaged, 1.3, 0.4999);
  print("5120 faces, 7 layers, averaged", best);
  EXPECT_NEAR(best.pressure, best.closed_pressure, 0.01 * best.closed_pressure);
  EXPECT_NEAR(best.outer_radius, best.closed_outer_radius, 1e-3 * best.closed_outer_radius);
}

} // namespace
} // namespace f2b
