#include "expect_error.hpp"

#include <Core/inverse/cut_suggestion.hpp>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <random>

namespace f2b
{
namespace
{

constexpr double degree = 3.14159265358979323846 / 180;

/// A flat face, 100 x 100 mm, with a vertex every 4 mm.
std::vector<Vec3> face_points()
{
  std::vector<Vec3> points;
  for (int i = 0; i <= 25; ++i)
    for (int j = 0; j <= 25; ++j)
      points.emplace_back(4 * i - 50, 0, 4 * j - 50);
  return points;
}

/// Skin that goes with a bone below a place, less the farther it is from there.
double share_of(const Vec3& point, const Vec3& place)
{
  return std::exp(-(point - place).squaredNorm() / (15 * 15));
}

/// What a fragment 20 mm below a place of the face does to it.
CutEffect cut_below(const std::string& name, const Vec3& place, double volume_mm3 = 1000)
{
  CutEffect effect{{name}, {name + " bone"}, {place - Vec3(0, 20, 0)}, volume_mm3, {}};
  for (int p = 0; p < 6; ++p)
  {
    std::vector<Vec3> column;
    const Vec3 axis = Vec3::Unit(p % 3);
    for (const Vec3& x : face_points())
      column.push_back(share_of(x, place) *
                       (p < 3 ? Vec3(axis.cross(x - effect.reference_points[0])) : axis));
    effect.columns.push_back(column);
  }
  return effect;
}

CutEffect together(CutEffect a, const CutEffect& b)
{
  auto append = [](auto& list, const auto& more)
  { list.insert(list.end(), more.begin(), more.end()); };
  append(a.cuts, b.cuts);
  append(a.fragments, b.fragments);
  append(a.reference_points, b.reference_points);
  append(a.columns, b.columns);
  a.bone_volume_mm3 += b.bone_volume_mm3;
  return a;
}

using Movement = Eigen::Matrix<double, 6, 1>;

/// The face that a small movement gives, to first order.
SkinTarget face_of(const CutEffect& effect, const Movement& q)
{
  SkinTarget target;
  for (std::size_t v = 0; v < face_points().size(); ++v)
  {
    Vec3 d = Vec3::Zero();
    for (int p = 0; p < 6; ++p)
      d += q[p] * effect.columns[static_cast<std::size_t>(p)][v];
    target.displacement.push_back(d);
    target.weight.push_back(1);
  }
  return target;
}

SkinTarget sum(SkinTarget a, const SkinTarget& b)
{
  for (std::size_t v = 0; v < a.displacement.size(); ++v)
    a.displacement[v] += b.displacement[v];
  return a;
}

std::vector<double> even_area()
{
  return std::vector<double>(face_points().size(), 16.0);
}

const CutEffect upper = cut_below("upper", {0, 0, 25}), lower = cut_below("lower", {0, 0, -25});
const Movement forward = (Movement() << 0, 0, 0, 0, 6, 0).finished();
const Movement turned = (Movement() << 0.05, 0, -0.02, 1, 4, -2).finished();

std::vector<std::string> ranked(const SkinTarget& target, const std::vector<CutEffect>& effects)
{
  std::vector<CutReach> reaches;
  for (const CutEffect& effect : effects)
    reaches.push_back(reach_of(effect, target, even_area()));
  rank(reaches);
  std::vector<std::string> order;
  for (const CutReach& reach : reaches)
    order.push_back(reach.cuts.size() > 1 ? "both" : reach.cuts[0]);
  return order;
}

TEST(CutSuggestion, FindsTheMovementThatGaveTheFace)
{
  CutSuggestionOptions options;
  options.cost_of_movement = 1e-9;
  const CutReach reach = reach_of(upper, face_of(upper, turned), even_area(), options);
  EXPECT_NEAR(reach.face.reached, 1, 1e-6);
  EXPECT_LT((reach.motions[0].translation - turned.tail<3>()).norm(), 1e-5);
  const Eigen::AngleAxisd turn(reach.motions[0].rotation);
  EXPECT_LT((turn.angle() * turn.axis() - turned.head<3>()).norm(), 1e-6);
  EXPECT_EQ(reach.motions[0].reference_point, upper.reference_points[0]);
  EXPECT_FALSE(reach.at_limit[0]);
}

TEST(CutSuggestion, TheCostOfMovementTakesLittleFromWhatTheSkinFeels)
{
  const CutReach reach = reach_of(upper, face_of(upper, turned), even_area());
  EXPECT_GT(reach.face.reached, 0.97);
  EXPECT_LT((reach.motions[0].translation - turned.tail<3>()).norm(), 0.3);
}

TEST(CutSuggestion, WhatTheSkinHardlyFeelsIsNotProposed)
{
  CutEffect effect = cut_below("upper", {0, 0, 25});
  for (Vec3& d : effect.columns[3]) // to the right: slides below the skin
    d *= 1e-3;
  SkinTarget target = face_of(upper, forward);
  for (std::size_t v = 0; v < target.displacement.size(); ++v) // as noise would ask for
    target.displacement[v] += 10 * effect.columns[3][v];
  EXPECT_LT(std::abs(reach_of(effect, target, even_area()).motions[0].translation.x()), 0.1);
}

TEST(CutSuggestion, OneCutRanksBeforeTwoThatReachAsMuch)
{
  const CutEffect both = together(upper, lower);
  EXPECT_EQ(ranked(face_of(lower, forward), {both, upper, lower}).front(), "lower");
  EXPECT_EQ(ranked(face_of(upper, turned), {both, lower, upper}).front(), "upper");
  EXPECT_GE(reach_of(both, face_of(lower, forward), even_area()).face.reached,
            reach_of(lower, face_of(lower, forward), even_area()).face.reached - 1e-3);
}

TEST(CutSuggestion, ATargetOfBothRanksThePairFirst)
{
  const SkinTarget target = sum(face_of(upper, turned), face_of(lower, forward));
  EXPECT_EQ(ranked(target, {upper, lower, together(upper, lower)}).front(), "both");
}

TEST(CutSuggestion, AmongEqualsTheSmallerFragmentRanksFirst)
{
  const std::vector<CutEffect> effects = {cut_below("large", {0, 0, 25}, 30000),
                                          cut_below("small", {0, 0, 25}, 9000)};
  EXPECT_EQ(ranked(face_of(upper, forward), effects), (std::vector<std::string>{"small", "large"}));
}

TEST(CutSuggestion, ASkinThatNoFragmentMovesIsNotReached)
{
  const CutReach reach =
      reach_of(upper, face_of(cut_below("far", {0, 0, -45}), forward), even_area());
  EXPECT_GE(reach.face.reached, 0);
  EXPECT_LT(reach.face.reached, 0.01);
  EXPECT_LT(reach.motions[0].translation.norm(), 0.2);
  EXPECT_NEAR(reach.face.rms_left_mm,
              target_rms_mm(face_of(cut_below("far", {0, 0, -45}), forward), even_area()), 0.01);
}

TEST(CutSuggestion, WeightsAndAreasSayWhatCounts)
{
  const SkinTarget of_upper = face_of(upper, forward), of_lower = face_of(lower, forward);
  SkinTarget target = sum(of_upper, of_lower);
  std::vector<double> area = even_area();
  for (std::size_t v = 0; v < area.size(); ++v)
    if (face_points()[v].z() < 0)
      (v % 2 ? target.weight[v] : area[v]) = 0;
  EXPECT_GT(reach_of(upper, target, area).face.reached, 0.9);
  EXPECT_LT(reach_of(lower, target, area).face.reached, 0.3);
}

TEST(CutSuggestion, MovementsStayWithinTheirLimits)
{
  const Movement far = (Movement() << 0, 0, 0, 0, 60, 0).finished();
  CutSuggestionOptions options;
  options.cost_of_movement = 1e-6;
  const CutReach reach = reach_of(upper, face_of(upper, far), even_area(), options);
  EXPECT_TRUE(reach.at_limit[0]);
  EXPECT_NEAR(reach.motions[0].translation.norm(), options.largest_shift_mm, 1e-6);
  EXPECT_NEAR(reach.face.reached, 25.0 / 60, 0.02);
  const Eigen::AngleAxisd turn(reach.motions[0].rotation);
  EXPECT_LT(turn.angle(), options.largest_turn_rad + 1e-9);
  EXPECT_GT(reach.motions[0].translation.y(), 24.9);

  const Movement twisted = (Movement() << 0.8, 0, 0, 0, 0, 0).finished();
  const CutReach turning = reach_of(upper, face_of(upper, twisted), even_area(), options);
  EXPECT_TRUE(turning.at_limit[0]);
  EXPECT_LT(Eigen::AngleAxisd(turning.motions[0].rotation).angle(), 20 * degree + 1e-9);
}

/// The gradient is zero where a ball holds nothing back, and points out of it where one does.
TEST(CutSuggestion, TheBoundedMinimumIsOne)
{
  std::mt19937 generator(3);
  std::normal_distribution<double> normal;
  int held = 0;
  for (int trial = 0; trial < 40; ++trial)
  {
    Eigen::MatrixXd A(15, 12);
    Eigen::VectorXd g(12);
    for (double& a : A.reshaped())
      a = normal(generator);
    for (double& b : g)
      b = 12 * normal(generator);
    const Eigen::VectorXd stretch = Eigen::VectorXd::LinSpaced(12, 0.1, 3);
    const Eigen::MatrixXd H = stretch.asDiagonal() * (A.transpose() * A) * stretch.asDiagonal();
    const Eigen::VectorXd q = minimum_in_unit_balls(H, g);
    const Eigen::VectorXd pull = g - H * q; // against the ball
    for (int block = 0; block < 12; block += 3)
    {
      const Vec3 at = q.segment<3>(block), out = pull.segment<3>(block);
      EXPECT_LE(at.norm(), 1 + 1e-12);
      if (at.norm() < 1 - 1e-9)
      {
        EXPECT_LT(out.norm(), 1e-6 * g.norm());
        continue;
      }
      ++held;
      EXPECT_GE(out.dot(at), -1e-6 * g.norm());
      EXPECT_LT(out.cross(at).norm(), 1e-6 * g.norm());
    }
  }
  EXPECT_GT(held, 20);
  EXPECT_LT(held, 140);
}

TEST(CutSuggestion, ATargetThatAsksForNothingIsRefused)
{
  const SkinTarget rest = face_of(upper, Movement::Zero());
  test::expect_error([&] { (void)reach_of(upper, rest, even_area()); },
                     {"target", "no change", "mask"});
  SkinTarget unweighted = face_of(upper, forward);
  unweighted.weight.assign(unweighted.weight.size(), 0);
  test::expect_error([&] { (void)reach_of(upper, unweighted, even_area()); }, {"no change"});
}

} // namespace
} // namespace f2b
