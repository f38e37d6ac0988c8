#include "Core/element/triangle_rule.hpp"

#include <cassert>
#include <cmath>

namespace f2b
{
namespace
{

/// Legendre's polynomial P_n and its derivative at z.
std::array<double, 2> legendre(int n, double z)
{
  double before = 1, p = z;
  for (int k = 2; k <= n; ++k)
  {
    const double next = ((2 * k - 1) * z * p - (k - 1) * before) / k;
    before = p;
    p = next;
  }
  return {p, n * (z * p - before) / (z * z - 1)};
}

using Rule = std::vector<TrianglePoint>;

/// The three points (a, a, 1 - 2 a).
void add_three(Rule& rule, double a, double weight)
{
  const double b = 1 - 2 * a;
  rule.push_back({{b, a, a}, weight});
  rule.push_back({{a, b, a}, weight});
  rule.push_back({{a, a, b}, weight});
}

/// The six points (a, b, 1 - a - b).
void add_six(Rule& rule, double a, double b, double weight)
{
  const double c = 1 - a - b;
  for (const Vec3& L :
       {Vec3(a, b, c), Vec3(b, c, a), Vec3(c, a, b), Vec3(b, a, c), Vec3(a, c, b), Vec3(c, b, a)})
    rule.push_back({L, weight});
}

void add_degree_4(Rule& rule)
{
  const double root = std::sqrt(38 - 44 * std::sqrt(0.4));
  const double share = std::sqrt(213125 - 53320 * std::sqrt(10.0));
  add_three(rule, (8 - std::sqrt(10.0) + root) / 18, (620 + share) / 3720);
  add_three(rule, (8 - std::sqrt(10.0) - root) / 18, (620 - share) / 3720);
}

void add_degree_5(Rule& rule)
{
  const double root = std::sqrt(15.0);
  rule.push_back({Vec3::Constant(1. / 3), 0.225});
  add_three(rule, (6 - root) / 21, (155 - root) / 1200);
  add_three(rule, (6 + root) / 21, (155 + root) / 1200);
}

void add_degree_6(Rule& rule)
{
  add_three(rule, 0.249286745170910, 0.116786275726379);
  add_three(rule, 0.063089014491502, 0.050844906370207);
  add_six(rule, 0.310352451033784, 0.053145049844817, 0.082851075618374);
}

} // namespace

std::vector<LinePoint> gauss_rule(int n)
{
  std::vector<LinePoint> rule;
  if (n == 1)
    return {{0.5, 1}};
  for (int i = 0; i < n; ++i)
  {
    double z = std::cos(M_PI * (i + 0.75) / (n + 0.5));
    for (int step = 0; step < 20; ++step) // Newton from this start needs five or fewer
    {
      const auto [value, slope] = legendre(n, z);
      z -= value / slope;
    }
    const double slope = legendre(n, z)[1];
    rule.push_back({0.5 * (1 - z), 1 / ((1 - z * z) * slope * slope)});
  }
  return rule;
}

std::vector<TrianglePoint> triangle_rule(int points)
{
  Rule rule;
  switch (points)
  {
  case 3:
    add_three(rule, 1. / 6, 1. / 3);
    break;
  case 6:
    add_degree_4(rule);
    break;
  case 7:
    add_degree_5(rule);
    break;
  case 12:
    add_degree_6(rule);
    break;
  case 96:
    return corner_graded_rule(4);
  default:
    assert(!"no rule with so many points");
  }
  return rule;
}

std::vector<TrianglePoint> corner_graded_rule(int n)
{
  const std::vector<LinePoint> line = gauss_rule(n);
  const Vec3 centre = Vec3::Constant(1. / 3);
  Rule rule;
  for (int corner = 0; corner < 3; ++corner)
    for (const int other : {(corner + 1) % 3, (corner + 2) % 3})
    {
      const Vec3 tip = Vec3::Unit(corner), middle = 0.5 * (tip + Vec3::Unit(other));
      for (const LinePoint& along : line)
        for (const LinePoint& across : line)
        {
          const Vec3 base = (1 - across.at) * middle + across.at * centre;
          // a sixth of the area, and the collapse squeezes by twice the distance from the tip
          rule.push_back({(1 - along.at) * tip + along.at * base,
                          along.weight * across.weight * along.at / 3});
        }
    }
  return rule;
}

} // namespace f2b
