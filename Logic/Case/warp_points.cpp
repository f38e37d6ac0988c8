#include "Case/warp_points.hpp"

#include "Bridge/markups.hpp"
#include "Core/error.hpp"
#include "Core/geometry/landmark_warp.hpp"

namespace f2b
{
namespace
{

void require_apart(const Landmarks& points, const Path& file)
{
  for (auto a = points.begin(); a != points.end(); ++a)
    for (auto b = std::next(a); b != points.end(); ++b)
      if ((a->second - b->second).norm() < LandmarkWarp::nearest_mm)
        throw Error(file.string(),
                    "the points '" + a->first + "' and '" + b->first + "' lie in one place",
                    "remove one of them, or place them apart");
}

void require_labels(const Landmarks& points, const Path& file, const Landmarks& others,
                    const Path& other)
{
  for (const auto& [label, position] : others)
    if (!points.count(label))
      throw Error(file.string(), "it has no point '" + label + "'",
                  "give every point of " + other.string() + " its counterpart");
}

} // namespace

WarpPoints read_warp_points(const TargetSettings& target)
{
  const Landmarks from = read_landmarks(target.warp_from), to = read_landmarks(target.warp_to);
  require_labels(to, target.warp_to, from, target.warp_from);
  require_labels(from, target.warp_from, to, target.warp_to);
  require_apart(from, target.warp_from);
  WarpPoints points;
  for (const auto& [label, position] : from)
  {
    points.from.push_back(position);
    points.to.push_back(to.at(label));
  }
  return points;
}

} // namespace f2b
