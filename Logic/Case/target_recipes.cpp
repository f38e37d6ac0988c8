#include "Case/target_recipes.hpp"

#include "Bridge/resources.hpp"
#include "Core/error.hpp"
#include "Core/geometry/nearest_vertex.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace f2b
{
namespace
{

using nlohmann::json;

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

/// The mean of landmarks joined by bars.
Vec3 place_of(const Landmarks& landmarks, const std::string& names, const std::string& target)
{
  Vec3 sum = Vec3::Zero();
  int count = 0;
  std::istringstream stream(names);
  for (std::string name; std::getline(stream, name, '|'); ++count)
    sum += landmark_of(landmarks, name, target);
  return sum / count;
}

/// Share of a stroke that skin at a distance from its path takes; its slope is continuous.
double share_at(const BrushStroke& stroke, double distance)
{
  const double t =
      std::clamp((distance - stroke.full_mm) / (stroke.reach_mm - stroke.full_mm), 0.0, 1.0);
  return 1 - t * t * (3 - 2 * t);
}

/// A stroke laid on a face.
class LaidStroke
{
public:
  LaidStroke(const BrushStroke& stroke, const std::vector<Vec3>& skin, const Landmarks& landmarks,
             const std::string& target)
      : m_stroke(stroke)
  {
    for (const BrushStroke::PathPoint& point : stroke.path)
      m_path.push_back(skin[nearest_vertex(skin, place_of(landmarks, point.place, target))]);
  }

  struct Touch
  {
    double share;
    Vec3 shift;
  };
  Touch at(const Vec3& skin) const;

private:
  const BrushStroke& m_stroke;
  std::vector<Vec3> m_path;
};

LaidStroke::Touch LaidStroke::at(const Vec3& skin) const
{
  double nearest = (skin - m_path[0]).norm();
  Vec3 shift = m_stroke.path[0].shift;
  for (std::size_t i = 1; i < m_path.size(); ++i)
  {
    const Vec3 along = m_path[i] - m_path[i - 1];
    const double length = along.squaredNorm();
    const double t =
        length > 0 ? std::clamp((skin - m_path[i - 1]).dot(along) / length, 0.0, 1.0) : 0;
    const double distance = (skin - m_path[i - 1] - t * along).norm();
    if (distance >= nearest)
      continue;
    nearest = distance;
    shift = (1 - t) * m_stroke.path[i - 1].shift + t * m_stroke.path[i].shift;
  }
  return {share_at(m_stroke, nearest), shift};
}

Vec3 blended(const std::vector<LaidStroke>& strokes, const Vec3& skin)
{
  double untouched = 1, shares = 0;
  Vec3 sum = Vec3::Zero();
  for (const LaidStroke& stroke : strokes)
  {
    const LaidStroke::Touch touch = stroke.at(skin);
    untouched *= 1 - touch.share;
    shares += touch.share;
    sum += touch.share * touch.shift;
  }
  return shares > 0 ? Vec3((1 - untouched) / shares * sum) : Vec3(Vec3::Zero());
}

BrushStroke stroke_from(const json& document)
{
  BrushStroke stroke;
  stroke.full_mm = document.at("full_mm");
  stroke.reach_mm = document.at("reach_mm");
  for (const json& point : document.at("path"))
  {
    const json& d = point.at("shift_mm");
    stroke.path.push_back({point.at("at"), Vec3(d.at(0), d.at(1), d.at(2))});
  }
  return stroke;
}

TargetRecipe recipe_from(const json& document)
{
  TargetRecipe recipe;
  recipe.name = document.at("name");
  recipe.title = document.at("title");
  recipe.moves_chin = document.at("moves_chin");
  for (const json& stroke : document.at("strokes"))
    recipe.strokes.push_back(stroke_from(stroke));
  return recipe;
}

} // namespace

std::vector<Vec3> TargetRecipe::displacement(const std::vector<Vec3>& skin,
                                             const Landmarks& landmarks) const
{
  std::vector<LaidStroke> laid;
  for (const BrushStroke& stroke : strokes)
    laid.emplace_back(stroke, skin, landmarks, name);
  std::vector<Vec3> displacement;
  for (const Vec3& p : skin)
    displacement.push_back(blended(laid, p));
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
