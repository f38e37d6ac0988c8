#include <Rendering/subject_drawing.hpp>

#include <Core/geometry/face_regions.hpp>
#include <Rendering/map_arrays.hpp>
#include <Rendering/surface_look.hpp>

#include <cmath>

namespace f2b
{

namespace
{

struct Map
{
  Surface surface;
  std::string array;
  vtkSmartPointer<vtkLookupTable> colours;
  std::string unknown = "legend.not-computed"; ///< what it means where there is no value
  std::vector<double> contours;                ///< thin at odd, thick at even places [mm]
};

Map distance_map(const PlanScene& scene)
{
  const Surface& face = scene.pictures().predicted;
  return {face,
          signed_distance_array,
          diverging_map(nice_range(point_values(face, signed_distance_array), 0.99, 0.5)),
          "legend.not-computed",
          {1, 2, -1, -2}};
}

Map reachability(const PlanScene& scene)
{
  const Surface& face = scene.pictures().predicted;
  return {face,
          unreachable_array,
          sequential_map(nice_range(point_values(face, unreachable_array), 0.99, 1.0)),
          "legend.no-target",
          {}};
}

Map target_displacement(const PlanScene& scene)
{
  const Surface skin = with_target_length(scene);
  return {skin,
          target_length_array,
          sequential_map(nice_range(point_values(skin, target_length_array), 1.0, 1.0)),
          "legend.not-computed",
          {}};
}

// "orbits" for the right and the left one, which have one colour.
std::string region_text(FaceRegion region, const Texts& texts)
{
  const std::string key = key_of(region), right = "_right";
  const bool has_sides =
      key.size() > right.size() && key.compare(key.size() - right.size(), right.size(), right) == 0;
  return texts("region." + (has_sides ? key.substr(0, key.size() - right.size()) + "s" : key));
}

bool is_left(FaceRegion region)
{
  const std::string key = key_of(region), left = "_left";
  return key.size() > left.size() && key.compare(key.size() - left.size(), left.size(), left) == 0;
}

SubjectDrawing regions(const PlanScene& scene, const Texts& texts)
{
  SubjectDrawing drawing;
  const Surface& skin = scene.pictures().skin;
  const auto map = region_map();
  std::vector<char> there(face_region_count, 0);
  for (const double value : point_values(skin, region_array))
  {
    if (const auto region = face_region_of(value))
    {
      there[static_cast<std::size_t>(*region)] = 1;
    }
  }
  for (const FaceRegion region : all_face_regions())
  {
    const auto value = static_cast<std::size_t>(region);
    if (there[value] && !is_left(region))
    {
      const double* c = map->GetTableValue(static_cast<vtkIdType>(value));
      drawing.legend.push_back({region_text(region, texts), {c[0], c[1], c[2]}});
    }
  }
  drawing.draw = [&skin, map](const Panel& panel, const ViewAxes&, double)
  { add_categories(panel, skin, region_array, map); };
  return drawing;
}

void draw_map(const Panel& panel, const Map& map)
{
  add_map(panel, map.surface, map.array, map.colours);
  for (const double level : map.contours)
  {
    add_contour(panel, map.surface, map.array, level, std::abs(level) < 1.5 ? 1.2 : 2.6);
  }
}

} // namespace

SubjectDrawing map_drawing(Subject subject, const PlanScene& scene, const Texts& texts)
{
  SubjectDrawing drawing;
  const std::string name = name_of(subject);
  if (subject == Subject::Regions)
  {
    drawing = regions(scene, texts);
  }
  else
  {
    const Map map = subject == Subject::DistanceMap    ? distance_map(scene)
                    : subject == Subject::Reachability ? reachability(scene)
                                                       : target_displacement(scene);
    if (has_unknown_values(map.surface, map.array))
    {
      drawing.legend.push_back({texts(map.unknown), no_value_colour});
    }
    if (!map.contours.empty())
    {
      drawing.legend.push_back({texts("legend.contours"), {0.1, 0.1, 0.12}});
    }
    drawing.bar = ValueBar{map.colours, texts("bar." + name)};
    drawing.draw = [map](const Panel& panel, const ViewAxes&, double) { draw_map(panel, map); };
  }
  drawing.title = texts("subject." + name);
  drawing.framed = scene.faces();
  return drawing;
}

} // namespace f2b
