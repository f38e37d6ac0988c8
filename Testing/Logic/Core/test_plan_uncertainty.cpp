#include "Core/inverse/plan_uncertainty.hpp"
#include "Core/material/law_variation.hpp"
#include "Logic/Core/slab_face.hpp"

#include <random>

namespace f2b
{
namespace
{

using namespace testing;

/// Only one cause counts.
UncertaintySources nothing_but()
{
  UncertaintySources s;
  s.skin_sd_mm = s.registration_sd_mm = s.stiffness_log_sd = s.poisson_ratio_sd =
      s.skin_thickness_sd_mm = 0;
  return s;
}

struct Planned
{
  Slab slab;
  SkinTarget target = slab.target_of(table_2_motion());
  RigidFitResult plan = fit_fragments(slab.face, target, {}, no_progress);

  std::vector<CoordinateUncertainty> spread(const UncertaintySources& sources) const
  {
    return plan_uncertainty(slab.face, target, {}, plan, slab.positions(), sources);
  }
  /// Change of the plan when the model's tissue is another.
  Eigen::VectorXd replanned(const MixedMesh& mesh, const MaterialSet& materials) const
  {
    const Discretization tissue(mesh);
    const FaceModel face{tissue, materials, slab.skin, slab.face.skin_area,
                         slab.face.reference_points};
    return fit_fragments(face, target, {}, no_progress).q - plan.q;
  }
};

void expect_same(const Eigen::VectorXd& dq, const std::vector<CoordinateUncertainty>& spread,
                 double (*part)(const CoordinateUncertainty&))
{
  const double largest = dq.cwiseAbs().maxCoeff();
  for (Eigen::Index k = 0; k < dq.size(); ++k)
    EXPECT_NEAR(part(spread[std::size_t(k)]), std::abs(dq[k]), 0.02 * largest)
        << "coordinate " << k;
}

TEST(PlanUncertainty, AStifferTissueMovesThePlanAsPropagated)
{
  const Planned p;
  UncertaintySources sources = nothing_but();
  sources.stiffness_log_sd = std::log(1.02);
  const auto spread = p.spread(sources);
  MaterialSet stiff = p.slab.materials;
  stiff.laws[0] = stiffened(stiff.laws[0], 1.02);
  expect_same(p.replanned(p.slab.mesh, stiff), spread,
              [](const CoordinateUncertainty& u) { return u.stiffness[0]; });
}

TEST(PlanUncertainty, PoissonsRatioMovesThePlanAsPropagated)
{
  const Planned p;
  UncertaintySources sources = nothing_but();
  sources.poisson_ratio_sd = 2e-4; // K grows by 0.4 %
  MaterialSet soft = p.slab.materials;
  for (Law& law : soft.laws)
    law = with_poisson_ratio(law, poisson_ratio(law) - 2e-4);
  expect_same(p.replanned(p.slab.mesh, soft), p.spread(sources),
              [](const CoordinateUncertainty& u) { return u.poisson_ratio; });
}

TEST(PlanUncertainty, SkinThicknessMovesThePlanAsPropagated)
{
  const Planned p;
  constexpr double share = 0.01; // of the thickness, which the dome changes from place to place
  double thickness = 0;
  MixedMesh thick = p.slab.mesh;
  for (const auto& prism : p.slab.mesh.prisms)
    for (std::size_t c = 0; c < 3; ++c)
    {
      const auto bottom = std::size_t(prism[c + 3]);
      const Vec3 through = p.slab.mesh.X[bottom] - p.slab.mesh.X[std::size_t(prism[c])];
      thickness += through.norm() / (3 * double(p.slab.mesh.prisms.size()));
      if (thick.node_boundary[bottom] == Boundary::Interior)
        thick.X[bottom] = p.slab.mesh.X[bottom] + share * through;
    }
  UncertaintySources sources = nothing_but();
  sources.skin_thickness_sd_mm = share * thickness;
  expect_same(p.replanned(thick, p.slab.materials), p.spread(sources),
              [](const CoordinateUncertainty& u) { return u.skin_thickness; });
}

TEST(PlanUncertainty, NoiseSpreadsThePlanAsManyNoisyTargetsDo)
{
  const Planned p;
  for (const double length : {0.0, 12.0})
  {
    UncertaintySources sources = nothing_but();
    sources.skin_sd_mm = 0.5;
    sources.skin_correlation_mm = length;
    const auto spread = p.spread(sources);
    const std::vector<Vec3> X = p.slab.positions();
    Eigen::MatrixXd covariance(X.size(), X.size());
    for (std::size_t v = 0; v < X.size(); ++v)
      for (std::size_t w = 0; w < X.size(); ++w)
        covariance(Eigen::Index(v), Eigen::Index(w)) =
            length == 0 ? double(v == w)
                        : std::exp(-0.5 * (X[v] - X[w]).squaredNorm() / (length * length)) +
                              (v == w ? 1e-9 : 0);
    const Eigen::MatrixXd root = covariance.llt().matrixL();
    std::mt19937 generator(11);
    std::normal_distribution<double> normal;
    constexpr int draws = 60;
    Eigen::VectorXd squares = Eigen::VectorXd::Zero(6);
    for (int i = 0; i < draws; ++i)
    {
      const Eigen::MatrixXd noise =
          0.5 * root *
          Eigen::MatrixXd::NullaryExpr(root.rows(), 3, [&] { return normal(generator); });
      SkinTarget noisy = p.target;
      for (std::size_t v = 0; v < X.size(); ++v)
        noisy.displacement[v] += noise.row(Eigen::Index(v)).transpose();
      squares += (fit_fragments(p.slab.face, noisy, {}, no_progress).q - p.plan.q).cwiseAbs2();
    }
    for (Eigen::Index k = 0; k < 6; ++k)
    {
      const double seen = std::sqrt(squares[k] / draws), told = spread[std::size_t(k)].noise;
      std::printf("length %2.0f mm, coordinate %td: sd of %d plans %.5f, propagated %.5f\n", length,
                  k, draws, seen, told);
      EXPECT_NEAR(told / seen, 1, 0.3); // three standard errors of a standard deviation from 60
    }
  }
}

/// A face that is not as the plan believes: tissue, skin, noise and registration drawn from the
/// priors that the sources state.
class DrawnTruth
{
public:
  explicit DrawnTruth(const Slab& slab, unsigned seed)
      : m_generator(seed), m_slab(slab), m_positions(slab.positions())
  {
    Eigen::MatrixXd covariance(m_positions.size(), m_positions.size());
    for (std::size_t v = 0; v < m_positions.size(); ++v)
      for (std::size_t w = 0; w < m_positions.size(); ++w)
        covariance(Eigen::Index(v), Eigen::Index(w)) =
            std::exp(-0.5 * (m_positions[v] - m_positions[w]).squaredNorm() / 25) +
            (v == w ? 1e-9 : 0);
    m_root = covariance.llt().matrixL();
  }

  struct Case
  {
    Eigen::VectorXd q;
    SkinTarget target;
  };
  Case draw()
  {
    Case drawn;
    drawn.q.resize(6);
    for (int k = 0; k < 6; ++k)
      drawn.q[k] = k < 3 ? uniform(-6, 6) * degree : uniform(-4, 4);
    MaterialSet materials = m_slab.materials;
    const double nu = uniform(0.45, 0.49);
    for (Law& law : materials.laws)
      law =
          with_poisson_ratio(stiffened(law, std::exp(uniform(-std::log(2.0), std::log(2.0)))), nu);
    const MixedMesh mesh = with_skin_of(uniform(1.0, 2.0));
    const Discretization tissue(mesh);
    const FaceModel face{tissue, materials, m_slab.skin, m_slab.face.skin_area,
                         m_slab.face.reference_points};
    const MovementSpace space = movement_space(m_slab.face, {});
    const Prediction truth = predict_face(face, space.motions(drawn.q), {}, no_progress);
    EXPECT_TRUE(truth.summary.converged());
    drawn.target = {truth.skin_displacement, m_slab.weights(), {}};
    add_errors(drawn.target.displacement);
    return drawn;
  }

private:
  double uniform(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(m_generator);
  }
  double normal() { return std::normal_distribution<double>()(m_generator); }
  /// Mean thickness as given; nominal is 1.5 mm where the slab has no dome.
  MixedMesh with_skin_of(double thickness_mm) const
  {
    MixedMesh mesh = m_slab.mesh;
    for (const auto& prism : m_slab.mesh.prisms)
      for (std::size_t c = 0; c < 3; ++c)
      {
        const auto top = std::size_t(prism[c]), bottom = std::size_t(prism[c + 3]);
        if (mesh.node_boundary[bottom] == Boundary::Interior)
          mesh.X[bottom] = m_slab.mesh.X[top] +
                           (thickness_mm / 1.5) * (m_slab.mesh.X[bottom] - m_slab.mesh.X[top]);
      }
    return mesh;
  }
  void add_errors(std::vector<Vec3>& displacement)
  {
    const Eigen::MatrixXd noise =
        0.5 * m_root * Eigen::MatrixXd::NullaryExpr(m_root.rows(), 3, [this] { return normal(); });
    const Vec3 shift = 0.3 * Vec3(normal(), normal(), normal());
    for (std::size_t v = 0; v < displacement.size(); ++v)
      displacement[v] += Vec3(noise.row(Eigen::Index(v))) + shift;
  }

  std::mt19937 m_generator;
  const Slab& m_slab;
  std::vector<Vec3> m_positions;
  Eigen::MatrixXd m_root;
};

TEST(PlanUncertainty, NinetyPercentIntervalsHoldTheTruthNineTimesInTen)
{
  Slab slab;
  slab.materials = soft_material(0.49);
  slab.materials.laws[0] = stiffened(slab.materials.laws[0], 3); // skin
  slab.materials.laws[1] = stiffened(slab.materials.laws[1], 0.5);
  DrawnTruth truth(slab, 20261123);
  constexpr int cases = 200;
  std::array<int, 6> held{};
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(6), widths = Eigen::VectorXd::Zero(6);
  for (int i = 0; i < cases; ++i)
  {
    const DrawnTruth::Case drawn = truth.draw();
    const RigidFitResult plan = fit_fragments(slab.face, drawn.target, {}, no_progress);
    const auto spread = plan_uncertainty(slab.face, drawn.target, {}, plan, slab.positions(), {});
    for (std::size_t k = 0; k < 6; ++k)
    {
      const double off = plan.q[Eigen::Index(k)] - drawn.q[Eigen::Index(k)];
      held[k] += std::abs(off) <= spread[k].half_90();
      squares[Eigen::Index(k)] += off * off / cases;
      widths[Eigen::Index(k)] += spread[k].sd() / cases;
    }
  }
  const MovementSpace space = movement_space(slab.face, {});
  for (std::size_t k = 0; k < 6; ++k)
  {
    const double share = double(held[k]) / cases;
    std::printf("%-9s 90 %% intervals hold the truth in %.1f %% of %d cases; rms error %.4g, mean "
                "sd told %.4g\n",
                space.coordinates()[k].name(), 100 * share, cases,
                std::sqrt(squares[Eigen::Index(k)]), widths[Eigen::Index(k)]);
    EXPECT_GE(share, 0.85);
    EXPECT_LE(share, 0.95);
  }
}

TEST(PlanUncertainty, AShiftOfTheTargetSpreadsTheTranslation)
{
  const Planned p;
  UncertaintySources sources = nothing_but();
  sources.registration_sd_mm = 0.1;
  const auto spread = p.spread(sources);
  SkinTarget shifted = p.target;
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(6);
  for (int axis = 0; axis < 3; ++axis)
  {
    shifted = p.target;
    for (Vec3& d : shifted.displacement)
      d += 0.1 * Vec3::Unit(axis);
    squares += (fit_fragments(p.slab.face, shifted, {}, no_progress).q - p.plan.q).cwiseAbs2();
  }
  expect_same(squares.cwiseSqrt(), spread,
              [](const CoordinateUncertainty& u) { return u.registration; });
}

TEST(PlanUncertainty, ACoordinateAtItsBoundIsCertain)
{
  const Planned p;
  RigidFitOptions options;
  options.rules.resize(1);
  options.rules[0].coordinates[4].least = -3;
  const RigidFitResult plan = fit_fragments(p.slab.face, p.target, options, no_progress);
  const auto spread =
      plan_uncertainty(p.slab.face, p.target, options, plan, p.slab.positions(), {});
  EXPECT_EQ(spread[4].sd(), 0);
  EXPECT_GT(spread[5].sd(), 0);
}

} // namespace
} // namespace f2b
