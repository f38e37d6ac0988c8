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
  SkinTarget target = slab.target_of({table_2_motion()});
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
