#include "Case/target_recipes.hpp"

#include "Bridge/resources.hpp"
#include "Core/error.hpp"
#include "Core/geometry/landmark_warp.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace f2b
{
namespace
{

using nlohmann::json;

const Vec3& nearest_vertex(const std::vector<Vec3>& skin, const Vec3& point)
{
  return *std::min_element(skin.begin(), skin.end(),
                           [&](const Vec3& a, const Vec3& b)
                           { return (a - point).squaredNorm() < (b - point).squaredNorm(); });
}

const Vec3& landmark_of(const Landmarks& landmarks, const std::string& name,
                        const std::string& target)
{
  const auto found = landmarks.find(name);
  if (found == landmarks.end())
    throw Error("target '" + target + "' of Experiment 3",
                "the landmark '" + name + "' is not there",
                "add it to the case's landmarks, or evaluate --experiments 1,2");
  return found->second;
}

/// Of a landmark, or the middle of two.
Vec3 place_of(const Landmarks& landmarks, const std::string& name, const std::string& target)
{
  const std::size_t bar = name.find('|');
  if (bar == std::string::npos)
    return landmark_of(landmarks, name, target);
  return 0.5 * (landmark_of(landmarks, name.substr(0, bar), target) +
                landmark_of(landmarks, name.substr(bar + 1), target));
}

TargetRecipe recipe_from(const json& document)
{
  TargetRecipe recipe;
  recipe.name = document.at("name");
  recipe.title = document.at("title");
  recipe.warps_chin = document.at("warps_chin");
  recipe.radius_mm = document.at("radius_mm");
  for (const auto& [name, d] : document.at("points").items())
    recipe.points.emplace_back(name, Vec3(d.at(0), d.at(1), d.at(2)));
  return recipe;
}

} // namespace

std::vector<Vec3> TargetRecipe::displacement(const std::vector<Vec3>& skin,
                                             const Landmarks& landmarks) const
{
  std::vector<Vec3> from, to;
  for (const auto& [landmark, shift] : points)
  {
    from.push_back(nearest_vertex(skin, place_of(landmarks, landmark, name)));
    to.push_back(from.back() + shift);
  }
  const LandmarkWarp warp(from, to, radius_mm);
  std::vector<Vec3> displacement;
  for (const Vec3& p : skin)
    displacement.push_back(warp.displacement(p));
  return displacement;
}

std::vector<TargetRecipe> target_recipes()
{
  std::vector<TargetRecipe> recipes;
  const json carried = json::parse(*carried_resource("evaluation/targets.json"));
  for (const json& document : carried.at("targets"))
    recipes.push_back(recipe_from(document));
  return recipes;
}

} // namespace f2b
