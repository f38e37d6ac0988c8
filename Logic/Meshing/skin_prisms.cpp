#include "Meshing/skin_prisms.hpp"

#include "Core/mesh/mesh_quality.hpp"

#include <algorithm>
#include <cmath>

namespace f2b
{

namespace
{

/// A top is on the skin when its distance is below this [mm].
constexpr double on_skin = 0.02;

std::vector<float> gaussian_weights(double sigma_samples)
{
  const int radius = static_cast<int>(std::ceil(3.0 * sigma_samples));
  std::vector<float> weights(2 * radius + 1);
  double sum = 0.0;
  for (int i = -radius; i <= radius; ++i)
    sum += std::exp(-0.5 * i * i / (sigma_samples * sigma_samples));
  for (int i = -radius; i <= radius; ++i)
    weights[i + radius] =
        static_cast<float>(std::exp(-0.5 * i * i / (sigma_samples * sigma_samples)) / sum);
  return weights;
}

void convolve_line(float* first, std::size_t stride, int count, const std::vector<float>& weights,
                   std::vector<float>& line)
{
  const int radius = static_cast<int>(weights.size() / 2);
  line.resize(count);
  for (int i = 0; i < count; ++i)
    line[i] = first[i * stride];
  for (int i = 0; i < count; ++i)
  {
    float sum = 0.0f;
    for (int k = -radius; k <= radius; ++k)
      sum += weights[k + radius] * line[std::clamp(i + k, 0, count - 1)];
    first[i * stride] = sum;
  }
}

double prism_quality(const PrismSheet& sheet, int triangle)
{
  const Triangle& n = sheet.triangles[triangle];
  const PrismCorners x = {sheet.top[n[0]],    sheet.top[n[1]],    sheet.top[n[2]],
                          sheet.bottom[n[0]], sheet.bottom[n[1]], sheet.bottom[n[2]]};
  const double scaled = min_scaled_jacobian(x);
  if (scaled <= 0.0)
    return scaled;
  // The share of the mean also sees tops that have shrunk to nothing, which unit vectors do not.
  const auto jacobians = quadrature_jacobians(x);
  const double least = *std::min_element(jacobians.begin(), jacobians.end());
  const double mean = prism_volume(x);
  return least > 0.0 ? std::min(scaled, least / mean) : 0.0;
}

class TopPlacer
{
public:
  TopPlacer(PrismSheet& sheet, const ShellDomain& domain, const SkinPrismOptions& options,
            const BottomMove& move_bottom)
      : m_sheet(sheet), m_domain(domain), m_options(options), m_move_bottom(move_bottom),
        m_smooth(smoothed(domain.fields().skin, domain.box(), options.smoothing_mm)),
        m_around(sheet.bottom.size()), m_neighbours(sheet.bottom.size())
  {
    for (int t = 0; t < static_cast<int>(sheet.triangles.size()); ++t)
      for (int i = 0; i < 3; ++i)
      {
        const Triangle& n = sheet.triangles[t];
        m_around[n[i]].push_back(t);
        m_neighbours[n[i]].push_back(n[(i + 1) % 3]);
        m_neighbours[n[i]].push_back(n[(i + 2) % 3]);
      }
    for (auto& neighbours : m_neighbours)
    {
      std::sort(neighbours.begin(), neighbours.end());
      neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
    }
  }

  void place()
  {
    m_sheet.top.resize(m_sheet.bottom.size());
    for (int node = 0; node < node_count(); ++node)
      m_sheet.top[node] = traced(node);
    improve(m_options.wanted_jacobian, Move::TopOnSkin);
    for (const Move move : {Move::Bottom, Move::TopOnSkin, Move::TopAnywhere, Move::Bottom})
      improve(m_options.required_jacobian, move);
    for (int pass = 0; pass < 6 && thin_out(0.6); ++pass)
      for (const Move move : {Move::TopAnywhere, Move::Bottom})
        improve(m_options.required_jacobian, move);
  }

private:
  enum class Move
  {
    TopOnSkin,
    TopAnywhere,
    Bottom,
  };

  int node_count() const { return static_cast<int>(m_sheet.bottom.size()); }
  double zeta(int node) const { return m_domain.zeta(m_sheet.bottom[node]); }

  /// Takes away what would lead off the walls that the node lies on.
  Vec3 along_walls(int node, Vec3 direction) const
  {
    for (int axis = 0; axis < 3; ++axis)
      if (m_sheet.walls[node] & (0b1001 << axis))
        direction[axis] = 0.0;
    return direction;
  }

  Vec3 within_box(const Vec3& p) const
  {
    return p.cwiseMax(m_domain.box().lo).cwiseMin(m_domain.box().hi);
  }

  Vec3 traced(int node) const
  {
    const double step = 0.2, longest = 3.0 * zeta(node);
    Vec3 p = m_sheet.bottom[node];
    for (double length = 0.0; length < longest; length += step)
    {
      const Vec3 direction = along_walls(node, m_smooth.gradient(p));
      const Vec3 next = within_box(p + step * direction.normalized());
      if (m_domain.skin(next) >= 0.0)
        break;
      p = next;
    }
    slide_to_skin(node, p);
    return p;
  }

  /// Newton steps to the zero level. False when the level is not reached.
  bool slide_to_skin(int node, Vec3& p) const
  {
    for (int iteration = 0; iteration < 6; ++iteration)
    {
      const double distance = m_domain.skin(p);
      if (std::abs(distance) < 0.2 * on_skin)
        return true;
      const Vec3 gradient = along_walls(node, m_domain.fields().skin.gradient(p));
      const double slope2 = std::max(gradient.squaredNorm(), 0.05);
      p = within_box(p - std::clamp(distance / slope2, -1.0, 1.0) * gradient);
    }
    return std::abs(m_domain.skin(p)) < on_skin;
  }

  /// The least quality around a node, lowered where the prisms' edge at it is very short or long.
  double node_quality(int node) const
  {
    double least = 1.0;
    for (const int triangle : m_around[node])
      least = std::min(least, prism_quality(m_sheet, triangle));
    const double height = (m_sheet.top[node] - m_sheet.bottom[node]).norm() / zeta(node);
    return least - std::max(0.0, 0.5 - height) - std::max(0.0, 0.3 * (height - 2.0));
  }

  Vec3 mean_offset_top(int node) const
  {
    Vec3 offset = Vec3::Zero();
    for (const int other : m_neighbours[node])
      offset += m_sheet.top[other] - m_sheet.bottom[other];
    return m_sheet.bottom[node] + offset / static_cast<double>(m_neighbours[node].size());
  }

  Vec3 mean_top(int node) const
  {
    Vec3 sum = Vec3::Zero();
    for (const int other : m_neighbours[node])
      sum += m_sheet.top[other];
    return sum / static_cast<double>(m_neighbours[node].size());
  }

  Vec3 bottom_normal(int node) const
  {
    Vec3 sum = Vec3::Zero();
    for (const int t : m_around[node])
    {
      const Triangle& n = m_sheet.triangles[t];
      const Vec3& a = m_sheet.bottom[n[0]];
      sum += (m_sheet.bottom[n[1]] - a).cross(m_sheet.bottom[n[2]] - a).normalized();
    }
    return sum.normalized();
  }

  /// Positions around `here` worth trying, in a fixed order: in the tangent plane, or in space.
  void add_around(std::vector<Vec3>& result, const Vec3& here, const Vec3& normal, double zeta,
                  bool in_space) const
  {
    const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u);
    for (const double share : {0.8, 0.4, 0.2, 0.1, 0.05})
    {
      const double radius = share * zeta;
      for (int k = 0; k < 8; ++k)
      {
        const double angle = 0.7853981633974483 * k;
        const Vec3 across = std::cos(angle) * u + std::sin(angle) * v;
        result.push_back(here + radius * across);
        if (in_space)
        {
          result.push_back(here + 0.7 * radius * (across + normal));
          result.push_back(here + 0.7 * radius * (across - normal));
        }
      }
      if (in_space)
      {
        result.push_back(here + radius * normal);
        result.push_back(here - radius * normal);
      }
    }
  }

  std::vector<Vec3> candidates(int node, Move move) const
  {
    const Vec3 here = move == Move::Bottom ? m_sheet.bottom[node] : m_sheet.top[node];
    const Vec3 normal = bottom_normal(node);
    std::vector<Vec3> result;
    if (move != Move::Bottom)
      result = {mean_offset_top(node), mean_top(node), 0.5 * (here + mean_offset_top(node)),
                m_sheet.bottom[node] + zeta(node) * normal};
    add_around(result, here, normal, zeta(node), move != Move::TopOnSkin);
    return result;
  }

  /// Puts a candidate where the move allows it to be; false when it may not be there.
  bool admissible(int node, Move move, const Vec3& before, Vec3& p) const
  {
    p = within_box(before + along_walls(node, p - before));
    return move != Move::TopOnSkin || slide_to_skin(node, p);
  }

  bool improve_node(int node, Move move)
  {
    Vec3& place = move == Move::Bottom ? m_sheet.bottom[node] : m_sheet.top[node];
    const Vec3 before = place;
    Vec3 best = before;
    double best_quality = node_quality(node) + 1e-3;
    bool moved = false;
    for (Vec3 p : candidates(node, move))
    {
      if (!admissible(node, move, before, p))
        continue;
      place = p;
      const double quality = node_quality(node);
      if (quality > best_quality && (move != Move::Bottom || m_move_bottom(node, p)))
      {
        best = p;
        best_quality = quality;
        moved = true;
      }
    }
    place = best;
    return moved;
  }

  /// In the bottom of a narrow cleft there is no room on the skin for the tops of all that stands
  /// around it: there the tops of bad prisms and their neighbours go upright to a part of the
  /// height. False when no prism is bad.
  bool thin_out(double height_share)
  {
    std::vector<bool> thin(node_count(), false);
    bool any = false;
    for (int node = 0; node < node_count(); ++node)
      if (node_quality(node) < m_options.required_jacobian)
      {
        any = thin[node] = true;
        for (const int other : m_neighbours[node])
          thin[other] = true;
      }
    for (int node = 0; node < node_count(); ++node)
      if (thin[node])
        m_sheet.top[node] = m_sheet.bottom[node] +
                            along_walls(node, height_share * zeta(node) * bottom_normal(node));
    return any;
  }

  void improve(double wanted, Move move)
  {
    for (int sweep = 0; sweep < m_options.sweeps; ++sweep)
    {
      bool moved = false;
      for (int node = 0; node < node_count(); ++node)
        if (node_quality(node) < wanted)
          moved = improve_node(node, move) || moved;
      if (!moved)
        return;
    }
  }

  PrismSheet& m_sheet;
  const ShellDomain& m_domain;
  const SkinPrismOptions& m_options;
  const BottomMove& m_move_bottom;
  ScalarGrid m_smooth;
  std::vector<std::vector<int>> m_around;     ///< triangles at each node
  std::vector<std::vector<int>> m_neighbours; ///< nodes joined to each node by an edge
};

} // namespace

ScalarGrid smoothed(const ScalarGrid& field, const RegionBox& box, double sigma_mm)
{
  ScalarGrid result;
  result.spacing = field.spacing;
  const double margin = 3.0 * sigma_mm + 2.0 * field.spacing;
  Eigen::Vector3i first, last;
  for (int a = 0; a < 3; ++a)
  {
    const auto sample = [&](double x) { return (x - field.origin[a]) / field.spacing; };
    first[a] =
        std::clamp(static_cast<int>(std::floor(sample(box.lo[a] - margin))), 0, field.size[a] - 1);
    last[a] =
        std::clamp(static_cast<int>(std::ceil(sample(box.hi[a] + margin))), 0, field.size[a] - 1);
  }
  result.origin = field.position(first.x(), first.y(), first.z());
  result.size = last - first + Eigen::Vector3i::Ones();
  result.values.reserve(result.count());
  for (int k = first.z(); k <= last.z(); ++k)
    for (int j = first.y(); j <= last.y(); ++j)
      for (int i = first.x(); i <= last.x(); ++i)
        result.values.push_back(field.values[field.index(i, j, k)]);

  const std::vector<float> weights = gaussian_weights(sigma_mm / field.spacing);
  std::vector<float> line;
  const auto [nx, ny, nz] = std::array<int, 3>{result.size.x(), result.size.y(), result.size.z()};
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      convolve_line(&result.values[result.index(0, j, k)], 1, nx, weights, line);
  for (int k = 0; k < nz; ++k)
    for (int i = 0; i < nx; ++i)
      convolve_line(&result.values[result.index(i, 0, k)], nx, ny, weights, line);
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
      convolve_line(&result.values[result.index(i, j, 0)], static_cast<std::size_t>(nx) * ny, nz,
                    weights, line);
  return result;
}

void place_tops(PrismSheet& sheet, const ShellDomain& domain, const SkinPrismOptions& options,
                const BottomMove& move_bottom)
{
  TopPlacer(sheet, domain, options, move_bottom).place();
}

std::vector<double> prism_qualities(const PrismSheet& sheet)
{
  std::vector<double> result;
  for (int triangle = 0; triangle < static_cast<int>(sheet.triangles.size()); ++triangle)
    result.push_back(prism_quality(sheet, triangle));
  return result;
}

} // namespace f2b
