#include "Core/element/triangle_rule.hpp"
#include "Core/solve/cholesky.hpp"
#include "Logic/Core/slab_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>

/// How fast do the errors of the face fall with the size of the prisms?
namespace f2b
{
namespace
{

using namespace testing;

constexpr double side = 20;        ///< of the block that is solved [mm]
constexpr double depth = side / 3; ///< with its skin [mm]
constexpr double k = 0.31415926535897932;

/// The manufactured solution: smooth, large enough for the law to be non-linear.
Vec3 exact_position(const Vec3& X)
{
  return X + Vec3(0.8 * std::sin(k * X.y()) * std::cos(k * X.z()), 0.6 * std::sin(k * X.z()),
                  0.7 * std::sin(k * X.x()) * std::sin(k * X.y()));
}

Mat3 exact_gradient(const Vec3& X)
{
  Mat3 F = Mat3::Identity();
  F(0, 1) += 0.8 * k * std::cos(k * X.y()) * std::cos(k * X.z());
  F(0, 2) -= 0.8 * k * std::sin(k * X.y()) * std::sin(k * X.z());
  F(1, 2) += 0.6 * k * std::cos(k * X.z());
  F(2, 0) += 0.7 * k * std::cos(k * X.x()) * std::sin(k * X.y());
  F(2, 1) += 0.7 * k * std::sin(k * X.x()) * std::cos(k * X.y());
  return F;
}

/// One block of tissue with skin as thick as the elements are long: all errors shrink together.
struct Block
{
  Block(int cells, SkinElement skin)
      : mesh(make_slab({cells, cells / 3 - 1, side, depth - side / cells, side / cells, 0, 0})),
        tissue(mesh, {skin, Dilatation::PerPoint})
  {
    for (const Vec3& X : mesh.X)
      outside.push_back(std::max(std::abs(X.x()), std::abs(X.y())) > 0.499 * side || X.z() < 1e-9);
  }
  MixedMesh mesh;
  Discretization tissue;
  MaterialSet materials = soft_material(0.4);
  std::vector<char> outside; ///< walls and bottom; the face is free
};

/// Weights of an element's controls at its quadrature points, in the order of its gradients.
template <class Prism>
std::vector<Eigen::VectorXd> point_weights(const FaceMap& face)
{
  std::vector<Eigen::VectorXd> all;
  for (const LinePoint& down : gauss_rule(2))
    for (const TrianglePoint& at : triangle_rule(Prism::points / 2))
    {
      Eigen::VectorXd N(Prism::corners);
      if constexpr (Prism::corners == 6)
        N << (1 - down.at) * at.L, down.at * at.L;
      else
        N << (1 - down.at) * (face * face_functions(at.L).value), down.at * at.L;
      all.push_back(N);
    }
  return all;
}

template <class Element, class Controls>
void add_load(const Element& element, const Controls& controls, const Block& block, Tissue kind,
              const std::vector<Eigen::VectorXd>& weights, std::vector<Vec3>& load)
{
  const auto& law = std::get<Yeoh>(block.materials.of(kind));
  for (std::size_t q = 0; q < weights.size(); ++q)
  {
    const std::size_t point = q % element.gradients.size(); // a tetrahedron has one gradient
    Vec3 X = Vec3::Zero();
    for (std::size_t c = 0; c < controls.size(); ++c)
      X += weights[q][Eigen::Index(c)] * block.tissue.rest()[std::size_t(controls[c])];
    const Mat3 P = law.stress(exact_gradient(X)) * element.volumes[point] *
                   (double(element.gradients.size()) / double(weights.size()));
    for (std::size_t c = 0; c < controls.size(); ++c)
      load[std::size_t(controls[c])] +=
          P * element.gradients[point].row(Eigen::Index(c)).transpose();
  }
}

/// The load that makes the manufactured solution an equilibrium, body force and traction of the
/// face together: the integral of P(F_exact) : grad N_a.
std::vector<Vec3> manufactured_load(const Block& block)
{
  std::vector<Vec3> load(block.tissue.control_count(), Vec3::Zero());
  const double b = 0.1381966011250105, a = 1 - 3 * b; // degree 2
  std::vector<Eigen::VectorXd> of_tet(4, Eigen::VectorXd::Constant(4, b));
  for (int q = 0; q < 4; ++q)
    of_tet[std::size_t(q)][q] = a;
  auto positions = [&](auto element, const auto& controls)
  {
    typename decltype(element)::Positions p;
    for (std::size_t c = 0; c < controls.size(); ++c)
      p.col(Eigen::Index(c)) = block.tissue.rest()[std::size_t(controls[c])];
    return p;
  };
  for (std::size_t e = 0; e < block.mesh.tets.size(); ++e)
    add_load(make_tet4(positions(Tet4(), block.mesh.tets[e])), block.mesh.tets[e], block,
             block.mesh.tet_tissue[e], of_tet, load);
  const SmoothSkin* skin = block.tissue.smooth_skin();
  for (int p = 0; p < int(block.mesh.prisms.size()); ++p)
    if (skin)
      add_load(skin->element(p), skin->controls(p), block, Tissue::Skin,
               point_weights<SmoothPrism>(skin->face_map(p)), load);
    else
      add_load(make_prism6(positions(Prism6(), block.mesh.prisms[std::size_t(p)])),
               block.mesh.prisms[std::size_t(p)], block, Tissue::Skin,
               point_weights<Prism6>(FaceMap()), load);
  return load;
}

std::vector<Vec3> solved(const Block& block)
{
  ElasticModel model(block.tissue, block.materials, block.tissue.control_flags(block.outside));
  const std::vector<Vec3> load = manufactured_load(block);
  std::vector<Vec3> x = block.tissue.mapped_rest(exact_position, exact_gradient);
  Cholesky cholesky;
  double step = 1;
  for (int i = 0; i < 12 && step > 1e-10; ++i)
  {
    Eigen::VectorXd residual = model.linearize(x);
    const auto& unknown = model.unknown_controls();
    for (std::size_t u = 0; u < unknown.size(); ++u)
      residual.segment<3>(3 * Eigen::Index(u)) -= load[std::size_t(unknown[u])];
    if (i == 0)
      cholesky.analyze(model.stiffness());
    EXPECT_TRUE(cholesky.factorize(model.stiffness()));
    const Eigen::VectorXd change = cholesky.solve(residual);
    for (std::size_t u = 0; u < unknown.size(); ++u)
      x[std::size_t(unknown[u])] -= change.segment<3>(3 * Eigen::Index(u));
    step = change.lpNorm<Eigen::Infinity>();
  }
  EXPECT_LT(step, 1e-10);
  return x;
}

/// Root mean squares over points inside the prisms' faces.
struct FaceError
{
  double position_mm = 0;
  double normal = 0; ///< [rad]
};

FaceError face_error(int cells, SkinElement skin)
{
  const Block block(cells, skin);
  const std::vector<Vec3> x = solved(block);
  FaceError error;
  int count = 0;
  for (const auto& prism : block.mesh.prisms)
    for (const TrianglePoint& at : triangle_rule(7))
    {
      Mat3 flat, moved;
      for (int i = 0; i < 3; ++i)
      {
        flat.col(i) = block.mesh.X[std::size_t(prism[std::size_t(i)])];
        moved.col(i) = x[std::size_t(prism[std::size_t(i)])];
      }
      SurfacePoint found{moved * at.L,
                         (moved.col(1) - moved.col(0)).cross(moved.col(2) - moved.col(0))};
      if (const SmoothSkin* smooth = block.tissue.smooth_skin())
        found = smooth->surface_point(count / 7, at.L, x);
      const Vec3 X = flat * at.L; // the face is flat at rest
      const Mat3 F = exact_gradient(X);
      error.position_mm += (found.point - exact_position(X)).squaredNorm();
      error.normal +=
          (found.normal.normalized() - F.col(0).cross(F.col(1)).normalized()).squaredNorm();
      ++count;
    }
  return {std::sqrt(error.position_mm / count), std::sqrt(error.normal / count)};
}

struct Convergence
{
  FaceError finest, order;
};

Convergence convergence(SkinElement skin)
{
  FaceError before, order;
  for (const int cells : {6, 12, 24})
  {
    const FaceError error = face_error(cells, skin);
    if (before.normal > 0)
      order = {std::log2(before.position_mm / error.position_mm),
               std::log2(before.normal / error.normal)};
    std::printf("%s face, h = %.2f mm: position %.2e mm (order %.2f), normal %.3f deg (order "
                "%.2f)\n",
                skin == SkinElement::Smooth ? "smooth" : "linear", side / cells, error.position_mm,
                order.position_mm, error.normal * 57.29577951308232, order.normal);
    before = error;
  }
  return {before, order};
}

/// The positions tend to order 2 with either face (with 48 cells 1.82 linear, 1.77 smooth); the
/// smooth one is closer, and its normals converge faster.
TEST(ConvergenceOrder, FaceOfPrismsInPositionAndNormal)
{
  const Convergence linear = convergence(SkinElement::Linear);
  const Convergence smooth = convergence(SkinElement::Smooth);
  EXPECT_GT(linear.order.position_mm, 1.5);
  EXPECT_GT(smooth.order.position_mm, 1.4);
  EXPECT_LT(smooth.finest.position_mm, linear.finest.position_mm);
  EXPECT_GT(linear.order.normal, 0.9);
  EXPECT_GT(smooth.order.normal, 1.3);
  EXPECT_LT(smooth.finest.normal, 0.25 * linear.finest.normal);
}

} // namespace
} // namespace f2b
