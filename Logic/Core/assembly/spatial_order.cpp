#include "Core/assembly/spatial_order.hpp"

#include <algorithm>
#include <cstdint>

namespace f2b
{
namespace
{

/// The 21 lower bits with two zeros after each.
std::uint64_t spread(std::uint64_t bits)
{
  bits = (bits | bits << 32) & 0x1f00000000ffff;
  bits = (bits | bits << 16) & 0x1f0000ff0000ff;
  bits = (bits | bits << 8) & 0x100f00f00f00f00f;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
  return (bits | bits << 2) & 0x1249249249249249;
}

} // namespace

std::vector<int> spatial_order(const std::vector<Vec3>& points)
{
  if (points.empty())
    return {};
  Vec3 low = points.front(), high = low;
  for (const Vec3& p : points)
  {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double extent = (high - low).maxCoeff();
  const double cells = extent > 0 ? ((1 << 21) - 1) / extent : 0;
  std::vector<std::pair<std::uint64_t, int>> keys;
  keys.reserve(points.size());
  for (const Vec3& p : points)
  {
    const Vec3 at = cells * (p - low);
    const auto code = spread(static_cast<std::uint64_t>(at[0])) |
                      spread(static_cast<std::uint64_t>(at[1])) << 1 |
                      spread(static_cast<std::uint64_t>(at[2])) << 2;
    keys.emplace_back(code, static_cast<int>(keys.size()));
  }
  std::sort(keys.begin(), keys.end());
  std::vector<int> order;
  order.reserve(keys.size());
  for (const auto& key : keys)
    order.push_back(key.second);
  return order;
}

} // namespace f2b
