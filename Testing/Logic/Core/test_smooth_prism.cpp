#include "Logic/Core/ball_mesh.hpp"
#include "Logic/Core/dense_model.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <random>

namespace f2b
{
namespace
{

using namespace testing;
using Gradients = SmoothPrism::Gradients;

/// The ball away from the origin, as a head lies in a scanner.
MixedMesh distant_ball(int levels, double radius_mm = 12)
{
  MixedMesh mesh = make_ball(levels, radius_mm, 1.5);
  for (Vec3& p : mesh.X)
    p += Vec3(100, -50, 80);
  return mesh;
}

template <class Element>
Gradients integral(const Element& element)
{
  Gradients sum = Gradients::Zero();
  for (std::size_t q = 0; q < element.volumes.size(); ++q)
    sum += element.volumes[q] * element.gradients[q];
  return sum;
}

SmoothPrism::Positions rest_positions(const SmoothSkin& skin, int prism)
{
  return DenseModel<SmoothPrism>::gathered<SmoothPrism>(skin.rest(), skin.controls(prism));
}

TEST(SmoothPrism, AffineFieldsAreExactAtEveryPoint)
{
  const MixedMesh mesh = distant_ball(2);
  const SmoothSkin skin(mesh);
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> u(-0.3, 0.3);
  double worst = 0;
  for (int p = 0; p < static_cast<int>(mesh.prisms.size()); ++p)
  {
    const Mat3 A = Mat3::Identity() + Mat3::NullaryExpr([&]() { return u(generator); });
    SmoothPrism::Positions x = A * rest_positions(skin, p);
    x.leftCols<3>().colwise() += Vec3(3, 1, -2);
    x.rightCols<3>().colwise() += Vec3(3, 1, -2);
    for (const Gradients& G : skin.element(p).gradients)
      worst = std::max(worst, (x * G - A).cwiseAbs().maxCoeff());
  }
  std::printf("F of affine fields on a sphere of 320 faces: %.1e off\n", worst);
  EXPECT_LT(worst, 1e-12);
}

TEST(SmoothPrism, MeanGradientsFollowTheDivergenceTheorem)
{
  const MixedMesh mesh = distant_ball(1);
  const SmoothSkin skin(mesh);
  const std::size_t controls = skin.rest().size();
  std::vector<Vec3> total(controls, Vec3::Zero());
  double volume_error = 0, shifted = 0;
  for (int p = 0; p < static_cast<int>(mesh.prisms.size()); ++p)
  {
    const auto Q = rest_positions(skin, p);
    const Gradients exact = exact_gradient_integrals(Q, skin.face_map(p));
    const double volume = (Q * exact).trace() / 3;
    volume_error =
        std::max(volume_error, (Q * exact / volume - Mat3::Identity()).cwiseAbs().maxCoeff());
    shifted = std::max(shifted, (integral(skin.element(p)) - exact).cwiseAbs().maxCoeff());
    const auto of_prism = skin.controls(p);
    for (std::size_t a = 0; a < 12; ++a)
      total[static_cast<std::size_t>(of_prism[a])] += exact.row(static_cast<Eigen::Index>(a));
  }
  for (const auto& tet : mesh.tets)
  {
    const Tet4 element = make_tet4(DenseModel<SmoothPrism>::gathered<Tet4>(mesh.X, tet));
    for (std::size_t a = 0; a < 4; ++a)
      total[static_cast<std::size_t>(tet[a])] +=
          element.volumes[0] * element.gradients[0].row(static_cast<Eigen::Index>(a)).transpose();
  }
  double inner = 0, outer = 0;
  const std::size_t below = (mesh.X.size() - 1) / 2;
  const Mat3 identity = Mat3::Identity();
  const Eigen::VectorXd face = face_traction(skin, identity);
  for (std::size_t c = 0; c < controls; ++c)
    (c <= below ? inner : outer) =
        std::max(c <= below ? inner : outer,
                 (total[c] - face.segment<3>(3 * static_cast<long>(c))).cwiseAbs().maxCoeff());
  std::printf("sum of mean gradients: %.1e mm^2 inside, %.1e on the face against its own integral; "
              "sum Q g = V I to %.1e; elements have them to %.1e\n",
              inner, outer, volume_error, shifted);
  EXPECT_LT(inner, 1e-11);
  EXPECT_LT(outer, 1e-11);
  EXPECT_LT(volume_error, 1e-11);
  EXPECT_LT(shifted, 1e-11);
}

TEST(SmoothPrism, ForcesAndStiffnessAreDerivatives)
{
  const MixedMesh mesh = distant_ball(1);
  const SmoothSkin skin(mesh);
  const SmoothPrism element = skin.element(3);
  SmoothPrism::Positions x = rest_positions(skin, 3);
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> u(-0.1, 0.1);
  x += SmoothPrism::Positions::NullaryExpr([&]() { return u(generator); });
  const NeoHookean law = test_law();
  const auto f = element_forces(element, x, law);
  const Eigen::MatrixXd K = full_stiffness(element, x, law);
  double force_error = 0, stiffness_error = 0;
  const double h = 1e-5;
  for (int i = 0; i < 36; ++i)
  {
    auto plus = x, minus = x;
    plus(i % 3, i / 3) += h;
    minus(i % 3, i / 3) -= h;
    const double slope =
        (element_energy(element, plus, law) - element_energy(element, minus, law)) / (2 * h);
    force_error = std::max(force_error, std::abs(slope - f(i % 3, i / 3)) / f.norm());
    const SmoothPrism::Positions column =
        (element_forces(element, plus, law) - element_forces(element, minus, law)) / (2 * h);
    stiffness_error =
        std::max(stiffness_error,
                 (Eigen::Map<const Eigen::Matrix<double, 36, 1>>(column.data()) - K.col(i)).norm() /
                     K.norm());
  }
  std::printf("force %.1e, stiffness %.1e against central differences\n", force_error,
              stiffness_error);
  EXPECT_LT(force_error, 1e-7);
  EXPECT_LT(stiffness_error, 1e-7);
}

/// Motions of an element at rest with (next to) no stiffness; six are rigid. With it the smallest
/// stiffness of the others relative to the largest.
template <class Element>
std::pair<int, double> loose_modes(const Element& element, const SmoothPrism::Positions& Q)
{
  const Eigen::MatrixXd K = full_stiffness(element, Q, test_law());
  const Eigen::VectorXd spectrum =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K, Eigen::EigenvaluesOnly).eigenvalues();
  int loose = 0;
  while (loose < 36 && spectrum[loose] < 1e-8 * spectrum[35])
    ++loose;
  return {loose, loose < 36 ? spectrum[loose] / spectrum[35] : 0};
}

/// A smooth strong deformation of nodes and slopes, and a rough one on top.
std::vector<Vec3> deformed(const SmoothSkin& skin, double rough_mm)
{
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> u(-rough_mm, rough_mm);
  std::vector<Vec3> x = skin.rest();
  const std::size_t nodes = skin.mesh().X.size();
  const Vec3 c(100, -50, 80);
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    const std::size_t node =
        i < nodes ? i : static_cast<std::size_t>(skin.tangents()[(i - nodes) / 2].node);
    const Vec3 d = skin.mesh().X[node] - c;
    // x + 0.02 (y z, x z, x^2)
    Mat3 J = Mat3::Identity();
    J.row(0) += 0.02 * Eigen::RowVector3d(0, d[2], d[1]);
    J.row(1) += 0.02 * Eigen::RowVector3d(d[2], 0, d[0]);
    J.row(2) += 0.02 * Eigen::RowVector3d(2 * d[0], 0, 0);
    if (i < nodes)
      x[i] += 0.02 * Vec3(d[1] * d[2], d[0] * d[2], d[0] * d[0]);
    else
      x[i] = J * x[i];
    x[i] += Vec3(u(generator), u(generator), u(generator));
  }
  return x;
}

/// The face at each prism's centroid when the ball's lower nodes at z < 0 move up by 1.5 mm: face
/// and slopes are free, all other lower nodes are held.
template <class Element>
std::vector<Vec3> pushed_face(const SmoothSkin& skin, const DenseModel<Element>& model)
{
  std::vector<Vec3> x = skin.rest();
  std::vector<char> held(x.size(), 0);
  const std::size_t below = (skin.mesh().X.size() - 1) / 2;
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(3 * static_cast<long>(x.size()));
  constexpr int steps = 5;
  for (int step = 0; step < steps; ++step)
  {
    for (std::size_t i = 0; i <= below; ++i)
    {
      held[i] = 1;
      if (skin.mesh().X[i][2] < 80)
        x[i][2] += 1.5 / steps;
    }
    EXPECT_LT(model.solve(x, held, none), 1e-9);
  }
  std::vector<Vec3> face;
  for (int p = 0; p < static_cast<int>(skin.mesh().prisms.size()); ++p)
    face.push_back(skin.surface_point(p, Vec3::Constant(1. / 3), x).point);
  return face;
}

/// Largest error when the centre and everything on the face moves affinely and the lower nodes are
/// free.
template <class Element>
double patch_error(const SmoothSkin& skin, const DenseModel<Element>& model)
{
  Mat3 A;
  A << 1.10, 0.05, 0.02, -0.04, 0.95, 0.03, 0.01, -0.06, 1.05;
  const std::vector<Vec3> rest = skin.rest();
  std::vector<Vec3> exact = rest;
  for (Vec3& p : exact)
    p = A * p;
  std::vector<Vec3> x = exact;
  std::vector<char> held(x.size(), 1);
  const std::size_t below = (skin.mesh().X.size() - 1) / 2;
  for (std::size_t i = 1; i <= below; ++i)
  {
    held[i] = 0;
    x[i] += Vec3(0.01, -0.02, 0.01);
  }
  model.solve(x, held, Eigen::VectorXd::Zero(3 * static_cast<long>(x.size())));
  double worst = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    worst = std::max(worst, (x[i] - exact[i]).norm());
  return worst;
}

struct Study
{
  int loose;
  double energy_error, rough_error, face_error_mm, patch_mm;
};

struct Reference
{
  double energy, rough;
  std::vector<Vec3> face;
};

template <class Element>
Study study(const char* name, const SmoothSkin& skin, typename DenseModel<Element>::MakePrism make,
            const Reference& reference)
{
  const DenseModel<Element> model(skin, make);
  const auto [loose, stiffness] = loose_modes(model.prisms()[5], rest_positions(skin, 5));
  Study s{loose, 0, 0, 0, 0};
  s.energy_error = std::abs(model.prism_energy(deformed(skin, 0)) / reference.energy - 1);
  s.rough_error = std::abs(model.prism_energy(deformed(skin, 0.3)) / reference.rough - 1);
  const std::vector<Vec3> face = pushed_face(skin, model);
  for (std::size_t p = 0; p < face.size(); ++p)
    s.face_error_mm = std::max(s.face_error_mm, (face[p] - reference.face[p]).norm());
  s.patch_mm = patch_error(skin, model);
  std::printf("%-18s %2zu points: %d rigid or loose motions (next %.1e), energy %.1e smooth %.1e "
              "rough, face %.2e mm, patch test %.1e mm\n",
              name, model.prisms()[0].gradients.size(), loose, stiffness, s.energy_error,
              s.rough_error, s.face_error_mm, s.patch_mm);
  return s;
}

/// The rule is chosen here: against 384 points a prism, on a sphere of 80 faces (20 degrees between
/// faces), with plain gradients and with gradients that have their exact mean.
TEST(SmoothPrism, QuadratureStudy)
{
  const MixedMesh mesh = distant_ball(1);
  const SmoothSkin skin(mesh);
  using Finest = SmoothPrismOf<96, 4>;
  const DenseModel<Finest> finest(skin, make_smooth_prism<96, 4>);
  const Reference reference{finest.prism_energy(deformed(skin, 0)),
                            finest.prism_energy(deformed(skin, 0.3)), pushed_face(skin, finest)};
  (void)study<SmoothPrismOf<3>>("plain", skin, make_plain_smooth_prism<3>, reference);
  const Study plain6 =
      study<SmoothPrismOf<6>>("plain", skin, make_plain_smooth_prism<6>, reference);
  (void)study<SmoothPrismOf<7>>("plain", skin, make_plain_smooth_prism<7>, reference);
  (void)study<SmoothPrismOf<12>>("plain", skin, make_plain_smooth_prism<12>, reference);
  const Study mean3 = study<SmoothPrismOf<3>>("exact mean", skin, make_smooth_prism<3>, reference);
  const Study mean6 = study<SmoothPrismOf<6>>("exact mean", skin, make_smooth_prism<6>, reference);
  const Study mean7 = study<SmoothPrismOf<7>>("exact mean", skin, make_smooth_prism<7>, reference);
  const Study mean12 =
      study<SmoothPrismOf<12>>("exact mean", skin, make_smooth_prism<12>, reference);
  EXPECT_GT(plain6.patch_mm, 1e-6); // why the mean is needed
  for (const Study& s : {mean3, mean6, mean7, mean12})
    EXPECT_LT(s.patch_mm, 1e-10);
  EXPECT_GT(mean3.loose, 6); // too few points: the element is loose
  EXPECT_EQ(mean6.loose, 6);
  EXPECT_LT(mean6.face_error_mm, 5e-3); // of a push of 1.5 mm
  EXPECT_LT(mean6.face_error_mm, mean3.face_error_mm);
  EXPECT_LT(mean12.face_error_mm, mean6.face_error_mm);
}

TEST(SmoothPrism, TellsWhatElevenThousandElementsCost)
{
  const MixedMesh mesh = make_ball(5, 80, 1.5); // 20480 faces
  const auto start = std::chrono::steady_clock::now();
  auto seconds = [&]
  { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  const SmoothSkin skin(mesh);
  const double slopes = seconds();
  double volume = 0;
  for (int p = 0; p < 11000; ++p)
    volume += skin.element(p).volumes[0];
  const double elements = seconds() - slopes;
  std::printf("slopes of %zu prisms %.3f s; 11000 elements %.3f s\n", mesh.prisms.size(), slopes,
              elements);
  EXPECT_GT(volume, 0);
}

} // namespace
} // namespace f2b
