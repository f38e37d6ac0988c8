#include "Core/assembly/elastic_model.hpp"
#include "Logic/Core/slab_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>

/// How fast does the displacement error fall with the size of the elements?
namespace f2b
{
namespace
{

using namespace testing;

constexpr double side = 20; // [mm]

/// The manufactured solution: smooth, large enough for the law to be non-linear.
Vec3 exact_position(const Vec3& X)
{
  const double k = 2 * std::acos(-1.0) / side;
  return X + Vec3(0.8 * std::sin(k * X.y()) * std::cos(k * X.z()), 0.6 * std::sin(k * X.z()),
                  0.7 * std::sin(k * X.x()) * std::sin(k * X.y()));
}

Mat3 exact_gradient(const Vec3& X)
{
  const double h = 1e-5;
  Mat3 F;
  for (int a = 0; a < 3; ++a)
    F.col(a) =
        (exact_position(X + h * Vec3::Unit(a)) - exact_position(X - h * Vec3::Unit(a))) / (2 * h);
  return F;
}

/// The load that makes the manufactured solution an equilibrium, tested with the element's shape
/// functions: the integral of P(F_exact) : grad N_a, which is that of N_a times the body force
/// since every N_a of an unknown vanishes on the boundary. Four points a tetrahedron, degree 2.
Eigen::VectorXd manufactured_load(const MixedMesh& mesh, const MaterialSet& materials,
                                  const ElasticModel& model)
{
  std::vector<Vec3> load(mesh.X.size(), Vec3::Zero());
  const double b = 0.1381966011250105, a = 1 - 3 * b;
  for (std::size_t e = 0; e < mesh.tets.size(); ++e)
  {
    Tet4::Positions X;
    for (int c = 0; c < 4; ++c)
      X.col(c) = mesh.X[std::size_t(mesh.tets[e][std::size_t(c)])];
    const Tet4 tet = make_tet4(X);
    for (int q = 0; q < 4; ++q)
    {
      Eigen::Vector4d weights = Eigen::Vector4d::Constant(b);
      weights[q] = a;
      const Mat3 P =
          std::get<Yeoh>(materials.of(mesh.tet_tissue[e])).stress(exact_gradient(X * weights));
      for (int c = 0; c < 4; ++c)
        load[std::size_t(mesh.tets[e][std::size_t(c)])] +=
            0.25 * tet.volumes[0] * P * tet.gradients[0].row(c).transpose();
    }
  }
  Eigen::VectorXd result(model.unknown_count());
  for (std::size_t i = 0; i < model.unknown_controls().size(); ++i)
    result.segment<3>(3 * Eigen::Index(i)) = load[std::size_t(model.unknown_controls()[i])];
  return result;
}

/// Root mean square of the displacement error at the nodes [mm].
double error_of(int cells)
{
  MixedMesh mesh = make_slab({cells, cells, side, side, 1, 0, 0});
  mesh.prisms.clear();
  const MaterialSet materials = soft_material(0.4);
  const Discretization tissue(mesh);
  std::vector<char> outside(mesh.X.size());
  for (std::size_t n = 0; n < outside.size(); ++n)
  {
    const Vec3& X = mesh.X[n];
    outside[n] = std::max(std::abs(X.x()), std::abs(X.y())) > 0.499 * side || X.z() < 1e-9 ||
                 X.z() > side - 1e-9;
  }
  ElasticModel model(tissue, materials, outside);
  const Eigen::VectorXd load = manufactured_load(mesh, materials, model);
  std::vector<Vec3> x = mesh.X;
  for (std::size_t n = 0; n < x.size(); ++n)
    x[n] = exact_position(mesh.X[n]);
  Cholesky cholesky;
  double step = 1;
  for (int i = 0; i < 12 && step > 1e-11; ++i)
  {
    const Eigen::VectorXd residual = model.linearize(x) - load;
    if (i == 0)
      cholesky.analyze(model.stiffness());
    EXPECT_TRUE(cholesky.factorize(model.stiffness()));
    const Eigen::VectorXd change = cholesky.solve(residual);
    for (std::size_t n = 0; n < model.unknown_controls().size(); ++n)
      x[std::size_t(model.unknown_controls()[n])] -= change.segment<3>(3 * Eigen::Index(n));
    step = change.lpNorm<Eigen::Infinity>();
  }
  EXPECT_LT(step, 1e-11);
  double sum = 0;
  for (const int n : model.unknown_controls())
    sum += (x[std::size_t(n)] - exact_position(mesh.X[std::size_t(n)])).squaredNorm();
  return std::sqrt(sum / double(model.unknown_controls().size()));
}

TEST(ConvergenceOrder, TetrahedraAreOfSecondOrder)
{
  double before = 0, order = 0;
  for (const int cells : {8, 16, 24})
  {
    const double error = error_of(cells);
    if (before > 0)
      order = std::log(before / error) / std::log(cells == 16 ? 2.0 : 1.5);
    std::printf("h = %.3f mm: displacement error %.3e mm, order %.2f\n", side / cells, error,
                order);
    before = error;
  }
  EXPECT_GT(order, 1.8);
}

} // namespace
} // namespace f2b
