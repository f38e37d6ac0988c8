#include "Core/error.hpp"
#include "Core/inverse/box_step.hpp"
#include "Core/inverse/movement_space.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <random>

namespace f2b
{
namespace
{

constexpr double degree = 3.14159265358979323846 / 180;

/// Where a motion takes some points that do not lie in a plane.
std::vector<Vec3> taken(const RigidMotion& motion)
{
  std::vector<Vec3> points;
  for (const Vec3& p : {Vec3(10, 0, 0), Vec3(0, 20, -5), Vec3(-7, 3, 30), Vec3(1, 1, 1)})
    points.push_back(motion.apply(p));
  return points;
}

/// Twists against central differences of where the motions take points.
void expect_twists_are_derivatives(const MovementSpace& space, const Eigen::VectorXd& q)
{
  const double h = 1e-6;
  const std::vector<RigidMotion> here = space.motions(q);
  for (Eigen::Index k = 0; k < space.size(); ++k)
  {
    const Eigen::VectorXd d = h * Eigen::VectorXd::Unit(space.size(), k);
    const std::vector<RigidMotion> ahead = space.motions(q + d), behind = space.motions(q - d);
    const std::vector<Twist> twists = space.twists(q, k);
    for (std::size_t f = 0; f < space.fragment_count(); ++f)
    {
      const auto a = taken(ahead[f]), b = taken(behind[f]), x = taken(here[f]);
      const Vec3 reference = here[f].reference_point + here[f].translation;
      for (std::size_t i = 0; i < x.size(); ++i)
      {
        const Vec3 velocity = twists[f].v + twists[f].omega.cross(x[i] - reference);
        EXPECT_LT((velocity - (a[i] - b[i]) / (2 * h)).norm(), 1e-7)
            << "fragment " << f << " coordinate " << space.coordinates()[std::size_t(k)].name();
      }
    }
  }
}

void expect_wish_slopes_are_derivatives(const MovementSpace& space, const Eigen::VectorXd& q)
{
  const double h = 1e-6;
  const Eigen::MatrixXd slopes = space.wish_slopes(q);
  for (Eigen::Index k = 0; k < space.size(); ++k)
  {
    const Eigen::VectorXd d = h * Eigen::VectorXd::Unit(space.size(), k);
    const Eigen::VectorXd differences = (space.wishes(q + d) - space.wishes(q - d)) / (2 * h);
    EXPECT_LT((slopes.col(k) - differences).norm(), 1e-6 * (1 + differences.norm()));
  }
}

const std::vector<std::string> three = {"maxilla", "mandible", "chin"};
const std::vector<Vec3> references = {{0, 0, 0}, {3, -10, -40}, {0, 5, -60}};

Eigen::VectorXd some_movement(const MovementSpace& space)
{
  Eigen::VectorXd q(space.size());
  for (Eigen::Index k = 0; k < q.size(); ++k)
    q[k] = (space.coordinates()[std::size_t(k)].is_angle() ? 0.1 : 3.0) * std::cos(1.0 + double(k));
  return q;
}

TEST(MovementSpace, FreeFragmentsHaveTheirReportedCoordinates)
{
  const MovementSpace space(three, references);
  ASSERT_EQ(space.size(), 18);
  const Eigen::VectorXd q = some_movement(space);
  const auto motions = space.motions(q);
  for (std::size_t f = 0; f < 3; ++f)
  {
    const EulerAngles angles = euler_angles(motions[f].rotation);
    const auto first = Eigen::Index(6 * f);
    EXPECT_NEAR(angles.pitch, q[first], 1e-14);
    EXPECT_NEAR(angles.roll, q[first + 1], 1e-14);
    EXPECT_NEAR(angles.yaw, q[first + 2], 1e-14);
    EXPECT_EQ(motions[f].translation, Vec3(q.segment<3>(first + 3)));
    EXPECT_EQ(motions[f].reference_point, references[f]);
  }
  expect_twists_are_derivatives(space, q);
  EXPECT_EQ(space.wishes(q).size(), 0);
}

TEST(MovementSpace, LockedCoordinatesStayAndBoundsHold)
{
  std::vector<FragmentRules> rules(3);
  rules[0].coordinates[1].is_locked = true;
  rules[0].coordinates[4] = {true, 0, 0, 5.0};
  rules[1].coordinates[3].least = 2;
  rules[1].coordinates[3].most = 4;
  const MovementSpace space(three, references, rules);
  ASSERT_EQ(space.size(), 16);
  const Eigen::VectorXd q = some_movement(space);
  EXPECT_NEAR(euler_angles(space.motions(q)[0].rotation).roll, 0, 1e-15);
  EXPECT_EQ(space.motions(q)[0].translation.y(), 5);
  EXPECT_EQ(space.motions(space.start())[1].translation, Vec3(2, 0, 0));
  EXPECT_EQ(space.most().maxCoeff(), MovementSpace::largest_shift_mm);
  expect_twists_are_derivatives(space, q);
}

TEST(MovementSpace, AHingeLeavesItsAxisWhereItIs)
{
  std::vector<FragmentRules> rules(3);
  rules[1].hinge = Hinge{{5, -60, 10}, Vec3(1, 0.1, 0).normalized(), {}};
  const MovementSpace space(three, references, rules);
  ASSERT_EQ(space.size(), 13);
  Eigen::VectorXd q = some_movement(space);
  const RigidMotion mandible = space.motions(q)[1];
  for (const double t : {-50.0, 0.0, 40.0})
  {
    const Vec3 on_axis = rules[1].hinge->point + t * rules[1].hinge->direction;
    EXPECT_LT((mandible.apply(on_axis) - on_axis).norm(), 1e-12);
  }
  EXPECT_GT((mandible.apply(references[1]) - references[1]).norm(), 1);
  expect_twists_are_derivatives(space, q);
}

TEST(MovementSpace, AnExactBiteFollowsItsLeaderThroughAChain)
{
  std::vector<FragmentRules> rules(3);
  rules[1].bite = BiteRelation{0, {rotation_from({0.1, 0, -0.2}), {1, 2, 3}, {0, 0, -20}}, 0, {}};
  rules[2].bite = BiteRelation{1, {}, 0, {}};
  const MovementSpace space(three, references, rules);
  ASSERT_EQ(space.size(), 6);
  const Eigen::VectorXd q = some_movement(space);
  const auto motions = space.motions(q);
  const RigidMotion splint = rules[1].bite->splint;
  const Vec3 p(4, -8, -33);
  EXPECT_LT((motions[1].apply(p) - motions[0].apply(splint.apply(p))).norm(), 1e-12);
  EXPECT_LT((motions[2].apply(p) - motions[1].apply(p)).norm(), 1e-12);
  expect_twists_are_derivatives(space, q);
}

TEST(MovementSpace, WishesAreThePriorsAndTheBite)
{
  std::vector<FragmentRules> rules(3);
  rules[0].coordinates[4].expected = 5;
  rules[0].coordinates[4].sd = 2;
  rules[1].bite = BiteRelation{0, {}, 0.5, {Vec3(20, 0, -20), Vec3(-20, 0, -20), Vec3(0, 30, -20)}};
  const MovementSpace space(three, references, rules);
  ASSERT_EQ(space.size(), 18);
  Eigen::VectorXd q = Eigen::VectorXd::Zero(18);
  q[4] = 9; // the maxilla forwards
  const Eigen::VectorXd wishes = space.wishes(q);
  ASSERT_EQ(wishes.size(), 10);
  EXPECT_DOUBLE_EQ(wishes[0], 2);                                 // 4 mm beyond 5, sd 2
  EXPECT_NEAR(wishes.tail(9).norm(), 18 * std::sqrt(3.0), 1e-12); // 9 mm off, three points
  expect_wish_slopes_are_derivatives(space, some_movement(space));
}

TEST(MovementSpace, RefusesRulesThatCannotHold)
{
  std::vector<FragmentRules> rules(3);
  rules[0].coordinates[3].least = 4;
  rules[0].coordinates[3].most = 2;
  try
  {
    const MovementSpace space(three, references, rules);
    FAIL() << "bounds without room";
  }
  catch (const Error& error)
  {
    EXPECT_NE(std::string(error.what()).find("maxilla"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("right from 4 mm to 2 mm"), std::string::npos)
        << error.what();
  }
  std::vector<FragmentRules> circle(3);
  circle[0].bite = BiteRelation{1, {}, 0, {}};
  circle[1].bite = BiteRelation{0, {}, 0, {}};
  EXPECT_THROW(MovementSpace(three, references, circle), Error);
  std::vector<FragmentRules> alone(3);
  alone[2].bite = BiteRelation{2, {}, 0, {}};
  EXPECT_THROW(MovementSpace(three, references, alone), Error);
  std::vector<FragmentRules> pointless(3);
  pointless[2].bite = BiteRelation{0, {}, 1.0, {Vec3::Zero()}};
  EXPECT_THROW(MovementSpace(three, references, pointless), Error);
}

/// The minimum within bounds, by trying all combinations of bounds.
Eigen::VectorXd best_of_all(const Eigen::MatrixXd& H, const Eigen::VectorXd& g,
                            const Eigen::VectorXd& least, const Eigen::VectorXd& most)
{
  const auto n = g.size();
  Eigen::VectorXd best;
  double lowest = std::numeric_limits<double>::infinity();
  for (int code = 0; code < int(std::pow(3, n)); ++code)
  {
    Eigen::VectorXd s(n);
    std::vector<Eigen::Index> free;
    for (Eigen::Index i = 0, c = code; i < n; ++i, c /= 3)
    {
      s[i] = c % 3 == 0 ? 0 : c % 3 == 1 ? least[i] : most[i];
      if (c % 3 == 0)
        free.push_back(i);
    }
    if (!free.empty())
      s(free) = -H(free, free).ldlt().solve((H * s + g)(free));
    if (((s - least).array() < -1e-12).any() || ((most - s).array() < -1e-12).any())
      continue;
    const double value = 0.5 * s.dot(H * s) + g.dot(s);
    if (value < lowest)
    {
      lowest = value;
      best = s;
    }
  }
  return best;
}

TEST(BoxStep, FindsTheMinimumThatTryingAllBoundsFinds)
{
  std::mt19937 generator(3);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 200; ++trial)
  {
    const int n = 1 + trial % 6;
    const Eigen::MatrixXd A = Eigen::MatrixXd::NullaryExpr(n, n, [&] { return normal(generator); });
    const Eigen::MatrixXd H = A.transpose() * A + 1e-3 * Eigen::MatrixXd::Identity(n, n);
    const Eigen::VectorXd g = Eigen::VectorXd::NullaryExpr(n, [&] { return normal(generator); });
    Eigen::VectorXd least(n), most(n);
    for (int i = 0; i < n; ++i)
    {
      least[i] = trial % 3 ? -std::abs(normal(generator)) : 0;
      most[i] = trial % 5 ? std::abs(normal(generator)) : 0;
    }
    const Eigen::VectorXd s = box_step(H, g, least, most);
    EXPECT_LT((s - best_of_all(H, g, least, most)).norm(), 1e-8) << "trial " << trial;
  }
}

TEST(BoxStep, IsNewtonsWithoutBounds)
{
  const Eigen::Matrix2d H{{2, 1}, {1, 3}};
  const Eigen::Vector2d g(1, -4), wide(1e9, 1e9);
  EXPECT_LT((H * box_step(H, g, -wide, wide) + g).norm(), 1e-12);
  EXPECT_EQ(box_step(H, Eigen::Vector2d::Zero(), -wide, wide).norm(), 0);
}

} // namespace
} // namespace f2b
