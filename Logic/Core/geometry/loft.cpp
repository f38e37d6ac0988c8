#include "Core/geometry/loft.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace f2b
{
namespace
{

struct Hermite
{
  double value, slope;
};

Hermite hermite(double y0, double m0, double y1, double m1, double step, double t)
{
  const double t2 = t * t, t3 = t2 * t;
  const double value = (2 * t3 - 3 * t2 + 1) * y0 + (t3 - 2 * t2 + t) * step * m0 +
                       (3 * t2 - 2 * t3) * y1 + (t3 - t2) * step * m1;
  const double slope =
      6 * (t2 - t) * (y0 - y1) / step + (3 * t2 - 4 * t + 1) * m0 + (3 * t2 - 2 * t) * m1;
  return {value, slope};
}

} // namespace

Loft::Loft(std::vector<LoftSection> sections, double centre, double back, double exponent)
    : m_sections(std::move(sections)), m_centre(centre), m_back(back), m_exponent(exponent)
{
  assert(m_sections.size() >= 2);
  std::sort(m_sections.begin(), m_sections.end(),
            [](const LoftSection& a, const LoftSection& b) { return a.superior < b.superior; });
  for (std::size_t i = 0; i < m_sections.size(); ++i)
  {
    const bool at_end = i == 0 || i + 1 == m_sections.size();
    const LoftSection& below = m_sections[i == 0 ? 0 : i - 1];
    const LoftSection& above = m_sections[std::min(i + 1, m_sections.size() - 1)];
    const double step = above.superior - below.superior;
    m_knots.push_back({m_sections[i].half_width, m_sections[i].front,
                       at_end ? 0 : (above.half_width - below.half_width) / step,
                       at_end ? 0 : (above.front - below.front) / step});
  }
}

Loft::Outline Loft::outline(double superior) const
{
  if (superior <= m_sections.front().superior)
    return m_knots.front();
  if (superior >= m_sections.back().superior)
    return m_knots.back();
  std::size_t i = 0;
  while (superior > m_sections[i + 1].superior)
    ++i;
  const double step = m_sections[i + 1].superior - m_sections[i].superior;
  const double t = (superior - m_sections[i].superior) / step;
  const Outline &lower = m_knots[i], &upper = m_knots[i + 1];
  const Hermite width = hermite(lower.half_width, lower.half_width_slope, upper.half_width,
                                upper.half_width_slope, step, t);
  const Hermite front =
      hermite(lower.front, lower.front_slope, upper.front, upper.front_slope, step, t);
  return {width.value, front.value, width.slope, front.slope};
}

double Loft::distance(const Vec3& point) const
{
  // rho is 1 on the surface and homogeneous of degree 1 within a section: (rho - 1) / |grad rho| is
  // the distance to first order; multiplied by rho it keeps its size far away as for an ellipsoid.
  const Outline o = outline(point.z());
  const bool before = point.y() >= m_centre;
  const double depth = before ? o.front - m_centre : m_back;
  const double depth_slope = before ? o.front_slope : 0.0;
  const double u = std::abs(point.x()) / o.half_width;
  const double v = std::abs(point.y() - m_centre) / depth;
  const double un = std::pow(u, m_exponent), vn = std::pow(v, m_exponent);
  const double rho = std::pow(un + vn, 1 / m_exponent);
  if (rho < 1e-6)
    return -std::min(o.half_width, depth);
  const double scale = std::pow(rho, 1 - m_exponent);
  const double to_u = scale * (u > 0 ? un / u : 0), to_v = scale * (v > 0 ? vn / v : 0);
  const Vec3 gradient(to_u / o.half_width, to_v / depth,
                      -to_u * u * o.half_width_slope / o.half_width -
                          to_v * v * depth_slope / depth);
  return rho * (rho - 1) / (gradient.norm() * std::max(rho, 0.2));
}

} // namespace f2b
