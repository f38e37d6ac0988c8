#include "qFaceToBoneCaseDocument.h"

#include <Bridge/json_file.hpp>
#include <Bridge/vtk_surface.hpp>
#include <Case/live_plan.hpp>
#include <Core/error.hpp>
#include <Core/geometry/cephalometry.hpp>
#include <Core/geometry/nearest_vertex.hpp>
#include <Core/sculpting/mirror_plane.hpp>
#include <Core/sculpting/sculpting_session.hpp>

#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

/// The landmarks of a list that allow it, with f2b::Error answered by none.
std::vector<f2b::CephalometricMeasure> measuresOf(const f2b::Landmarks& landmarks,
                                                  const f2b::MidSagittalPlane& plane)
{
  try
  {
    return f2b::cephalometry(landmarks, plane);
  }
  catch (const f2b::Error&)
  {
    return {};
  }
}

/// None without N, Or_R or Or_L.
std::optional<f2b::MidSagittalPlane> middleOf(const f2b::Landmarks& landmarks)
{
  try
  {
    return f2b::mid_sagittal_plane(landmarks);
  }
  catch (const f2b::Error&)
  {
    return std::nullopt;
  }
}

double distanceTo(const std::vector<f2b::Vec3>& surface, const f2b::Vec3& p)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const f2b::Vec3& v : surface)
    nearest = std::min(nearest, (v - p).squaredNorm());
  return std::sqrt(nearest);
}

} // namespace

/// What each landmark rides on: the skin, a fragment, or bone that stays.
void qFaceToBoneCase::findRides()
{
  m_rides.clear();
  const f2b::Landmarks& rest = m_document->landmarks;
  const auto pointsOf = [this](const QString& key)
  {
    const qFaceToBoneObject* object = m_objects.find(key);
    return object ? f2b::points_of(object->surface) : std::vector<f2b::Vec3>{};
  };
  const std::vector<f2b::Vec3> stays = pointsOf("uncut");
  std::vector<std::vector<f2b::Vec3>> pieces;
  for (const QString& fragment : m_fragments)
    pieces.push_back(pointsOf("fragment/" + fragment));
  for (const f2b::LandmarkDefinition& definition : f2b::landmark_definitions())
  {
    const auto found = rest.find(definition.name);
    if (found == rest.end())
      continue;
    Ride ride{definition.name, -1, -1};
    if (definition.soft_tissue && m_sculpting)
      ride.vertex =
          static_cast<int>(f2b::nearest_vertex(m_sculpting->skin().rest(), found->second));
    else if (!definition.soft_tissue)
    {
      f2b::Vec3 at = found->second;
      const auto& teeth = f2b::tooth_landmarks();
      if (std::find(teeth.begin(), teeth.end(), definition.name) != teeth.end())
        at = f2b::bone_of_tooth(rest, definition.name);
      double nearest = stays.empty() ? 0 : distanceTo(stays, at);
      for (std::size_t f = 0; f < pieces.size(); ++f)
        if (const double away = distanceTo(pieces[f], at); away < nearest)
        {
          nearest = away;
          ride.fragment = static_cast<int>(f);
        }
    }
    m_rides.push_back(ride);
  }
}

std::vector<qFaceToBoneCase::Measure> qFaceToBoneCase::measures() const
{
  std::vector<Measure> all;
  const f2b::Landmarks& rest = m_document->landmarks;
  const auto plane = middleOf(rest);
  if (!plane) // there is no side to look from
    return all;
  f2b::Landmarks moved = rest;
  for (const Ride& ride : m_rides)
    if (m_plan && ride.vertex >= 0)
      moved[ride.landmark] += m_plan->skin_displacement[static_cast<std::size_t>(ride.vertex)];
    else if (m_plan && ride.fragment >= 0)
      moved[ride.landmark] =
          m_plan->motions.at(static_cast<std::size_t>(ride.fragment)).apply(moved[ride.landmark]);
  const auto before = measuresOf(rest, *plane), after = measuresOf(moved, *plane);
  for (const f2b::CephalometricMeasure& m : before)
  {
    Measure measure{QString::fromStdString(m.name), QString::fromStdString(m.unit),
                    QString::fromStdString(m.definition), m.value, m.value};
    for (const f2b::CephalometricMeasure& planned : after)
      if (planned.name == m.name)
        measure.planned = planned.value;
    all.push_back(measure);
  }
  return all;
}

bool qFaceToBoneCase::isSymmetryGuessed() const
{
  return m_objects.find("skin") && !middleOf(m_document->landmarks);
}

f2b::SymmetryPlane qFaceToBoneCase::symmetryPlane() const
{
  if (const auto plane = middleOf(m_document->landmarks))
    return {plane->point, plane->normal};
  std::optional<f2b::SymmetryPlane>& guessed = m_document->guessed;
  const qFaceToBoneObject* skin = m_objects.find("skin");
  if (!guessed && skin)
    guessed = guessedSymmetry(skin->surface);
  return guessed.value_or(f2b::SymmetryPlane{});
}

/// As it was found with the skin; looked for here in folders that do not tell it.
f2b::SymmetryPlane qFaceToBoneCase::guessedSymmetry(vtkPolyData* skin) const
{
  f2b::SymmetryPlane symmetry;
  skin->GetCenter(symmetry.point.data());
  const auto told = has("segment.json") ? f2b::read_json(file("segment.json")) : nlohmann::json();
  if (const auto guess = told.find("midline_guess"); guess == told.end())
  {
    if (const auto found = f2b::mirror_plane(f2b::to_triangle_mesh(skin)))
      symmetry = found->plane;
  }
  else if (guess->is_object())
    for (int k = 0; k < 3; ++k)
    {
      symmetry.point[k] = guess->at("point_ras").at(static_cast<std::size_t>(k)).get<double>();
      symmetry.normal[k] = guess->at("normal_ras").at(static_cast<std::size_t>(k)).get<double>();
    }
  return symmetry;
}
