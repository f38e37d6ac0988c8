#include <Rendering/views.hpp>

#include <Core/geometry/face_regions.hpp>
#include <Rendering/annotation.hpp>
#include <Rendering/map_arrays.hpp>
#include <Rendering/movement_arrows.hpp>
#include <Rendering/surface_look.hpp>

#include <algorithm>

namespace f2b
{

namespace
{

// Frames one panel and says which side is which.
void frame(const Panel& panel, View view, const std::vector<Surface>& surfaces,
           const Margins& margins, double mm_per_pixel)
{
  aim(panel, view, extents(surfaces, view), margins, mm_per_pixel);
  add_orientation(panel, view);
}

double fitting_scale(const std::vector<Surface>& surfaces, View view, const Panel& panel,
                     const Margins& margins)
{
  return fitting_mm_per_pixel(extents(surfaces, view), panel.size, margins);
}

// The scale at which every view of the surfaces fits a panel.
double common_scale(const std::vector<Surface>& surfaces, const Panel& panel,
                    const Margins& margins)
{
  double mm_per_pixel = 0;
  for (const View view : all_views)
  {
    mm_per_pixel = std::max(mm_per_pixel, fitting_scale(surfaces, view, panel, margins));
  }
  return mm_per_pixel;
}

std::string face_title(FaceState state)
{
  return state == FaceState::Before   ? "Face before"
         : state == FaceState::Target ? "Target face"
                                      : "Predicted face";
}

const Surface& face_surface(const PlanScene& scene, FaceState state)
{
  const PlanPictures& pictures = scene.pictures();
  return state == FaceState::Before   ? pictures.skin
         : state == FaceState::Target ? pictures.target
                                      : pictures.predicted;
}

// Skin beyond the mesh stays where it was; a prediction says so.
bool partly_predicted(const PlanScene& scene)
{
  return scene.has_distance() &&
         has_unknown_values(scene.pictures().predicted, signed_distance_array);
}

void draw_face(const Panel& panel, const PlanScene& scene, FaceState state, View view)
{
  // all states leave the same room, so that they are framed alike
  const bool partly = partly_predicted(scene);
  const Margins margins = annotation_margins(panel, partly ? 1 : 0);
  add_title(panel, face_title(state), view_title(view));
  if (partly && state == FaceState::Predicted)
  {
    add_skin_known_by(panel, face_surface(scene, state), signed_distance_array);
    add_legend(panel, {{"not computed", no_value_colour}});
  }
  else
  {
    add_skin(panel, face_surface(scene, state));
  }
  const double mm_per_pixel = fitting_scale(scene.faces(), view, panel, margins);
  frame(panel, view, scene.faces(), margins, mm_per_pixel);
  add_scale(panel, mm_per_pixel);
}

struct MapDrawing
{
  Surface surface;
  std::string array;
  vtkSmartPointer<vtkLookupTable> map;
  std::string title;
  std::string bar_title;
  std::string unknown = "not computed"; ///< what it means where there is no value
};

// One map from every side at one scale, with one bar in the middle.
Image draw_map(const PlanScene& scene, const MapDrawing& drawing, PixelSize panel_size)
{
  Picture picture(static_cast<int>(all_views.size()), panel_size);
  std::vector<LegendEntry> legend;
  if (has_unknown_values(drawing.surface, drawing.array))
  {
    legend.push_back({drawing.unknown, no_value_colour});
  }
  const Margins margins = annotation_margins(picture.panel(0), legend.size());
  const double mm_per_pixel = common_scale(scene.faces(), picture.panel(0), margins);
  for (std::size_t i = 0; i < all_views.size(); ++i)
  {
    const Panel& panel = picture.panel(static_cast<int>(i));
    add_map(panel, drawing.surface, drawing.array, drawing.map);
    add_title(panel, i == 0 ? drawing.title : "", view_title(all_views[i]));
    frame(panel, all_views[i], scene.faces(), margins, mm_per_pixel);
  }
  add_legend(picture.panel(0), legend);
  add_scale(picture.panel(0), mm_per_pixel);
  add_scale(picture.panel(2), mm_per_pixel);
  add_value_bar(picture.panel(1), drawing.map, drawing.bar_title);
  return picture.render();
}

// "orbits" for the right and the left one, which have one colour.
std::string region_text(FaceRegion region)
{
  const std::string name = name_of(region), right = "right ";
  return name.compare(0, right.size(), right) == 0 ? name.substr(right.size()) + "s" : name;
}

std::vector<LegendEntry> region_legend(const PlanScene& scene, vtkLookupTable* map)
{
  std::vector<char> there(face_region_count, 0);
  for (const double value : point_values(scene.pictures().skin, region_array))
  {
    if (const auto region = face_region_of(value))
    {
      there[static_cast<std::size_t>(*region)] = 1;
    }
  }
  std::vector<LegendEntry> entries;
  for (const FaceRegion region : all_face_regions())
  {
    const auto value = static_cast<std::size_t>(region);
    const bool is_left = name_of(region).compare(0, 5, "left ") == 0;
    if (there[value] && !is_left)
    {
      const double* c = map->GetTableValue(static_cast<vtkIdType>(value));
      entries.push_back({region_text(region), {c[0], c[1], c[2]}});
    }
  }
  return entries;
}

// The rows of a legend that one of several panels shows.
std::vector<LegendEntry> part_of(const std::vector<LegendEntry>& legend, std::size_t part,
                                 std::size_t rows)
{
  const auto first = legend.begin() + static_cast<long>(std::min(legend.size(), part * rows));
  return {first, legend.begin() + static_cast<long>(std::min(legend.size(), (part + 1) * rows))};
}

std::vector<LegendEntry> fragment_legend(const PlanScene& scene, bool with_movement)
{
  std::vector<LegendEntry> entries{{"Bone that stays", bone_colour}};
  const auto& fragments = scene.pictures().fragments;
  for (std::size_t i = 0; i < fragments.size(); ++i)
  {
    const bool has_text = with_movement && !fragments[i].movement.empty();
    entries.push_back(
        {fragments[i].name + (has_text ? ": " + fragments[i].movement : ""), fragment_colour(i)});
  }
  return entries;
}

std::vector<LegendEntry> bone_legend(const PlanScene& scene, BoneState state)
{
  std::vector<LegendEntry> entries = fragment_legend(scene, state == BoneState::After);
  if (state == BoneState::After)
  {
    entries.push_back({"Position before", ghost_colour, 0.45});
  }
  else if (scene.pictures().cut_planes)
  {
    entries.push_back({"Cut", cut_colour, 0.6});
  }
  return entries;
}

// Before and after leave the same room, so that they are framed alike.
Margins bone_margins(const Panel& panel, const PlanScene& scene)
{
  return annotation_margins(panel, bone_legend(scene, BoneState::After).size());
}

void draw_bone_surfaces(const Panel& panel, const PlanScene& scene, BoneState state)
{
  const PlanPictures& pictures = scene.pictures();
  add_bone(panel, pictures.uncut_bone, bone_colour);
  for (std::size_t i = 0; i < pictures.fragments.size(); ++i)
  {
    const FragmentPicture& fragment = pictures.fragments[i];
    add_bone(panel, state == BoneState::Before ? fragment.rest : fragment.planned,
             fragment_colour(i));
  }
}

void draw_bones(const Panel& panel, const PlanScene& scene, BoneState state, View view)
{
  const Margins margins = bone_margins(panel, scene);
  const double mm_per_pixel = fitting_scale(scene.bones(), view, panel, margins);
  draw_bone_surfaces(panel, scene, state);
  if (state == BoneState::Before && scene.pictures().cut_planes)
  {
    add_planes(panel, scene.pictures().cut_planes);
  }
  add_title(panel, state == BoneState::Before ? "Bones before" : "Bones as planned",
            view_title(view));
  add_legend(panel, bone_legend(scene, state));
  frame(panel, view, scene.bones(), margins, mm_per_pixel);
  add_scale(panel, mm_per_pixel);
  if (state == BoneState::After)
  {
    for (const FragmentPicture& fragment : scene.pictures().fragments)
    {
      add_ghost(panel, fragment.rest);
      add_movement_arrow(panel, fragment, view, mm_per_pixel);
    }
  }
}

} // namespace

Image face_picture(const PlanScene& scene, FaceState state, View view, PixelSize size)
{
  Picture picture(1, size);
  draw_face(picture.panel(0), scene, state, view);
  return picture.render();
}

Image face_comparison(const PlanScene& scene, View view, PixelSize panel_size)
{
  std::vector<FaceState> states;
  for (const FaceState state : {FaceState::Before, FaceState::Target, FaceState::Predicted})
  {
    if (face_surface(scene, state))
    {
      states.push_back(state);
    }
  }
  Picture picture(static_cast<int>(states.size()), panel_size);
  for (std::size_t i = 0; i < states.size(); ++i)
  {
    draw_face(picture.panel(static_cast<int>(i)), scene, states[i], view);
  }
  return picture.render();
}

Image target_region_picture(const PlanScene& scene, PixelSize panel_size)
{
  MapDrawing drawing;
  drawing.surface = with_target_length(scene);
  drawing.array = target_length_array;
  drawing.map = sequential_map(nice_range(point_values(drawing.surface, drawing.array), 1.0, 1.0));
  drawing.title = "Wished skin movement";
  drawing.bar_title = "length, before to target [mm]";
  return draw_map(scene, drawing, panel_size);
}

Image distance_map_picture(const PlanScene& scene, PixelSize panel_size)
{
  MapDrawing drawing;
  drawing.surface = scene.pictures().predicted;
  drawing.array = signed_distance_array;
  drawing.map = diverging_map(nice_range(point_values(drawing.surface, drawing.array), 0.99, 0.5));
  drawing.title = "Predicted against target";
  drawing.bar_title = "predicted - target [mm], negative: behind the target";
  return draw_map(scene, drawing, panel_size);
}

Image reachability_picture(const PlanScene& scene, PixelSize panel_size)
{
  MapDrawing drawing;
  drawing.surface = scene.pictures().predicted;
  drawing.array = unreachable_array;
  drawing.map = sequential_map(nice_range(point_values(drawing.surface, drawing.array), 0.99, 1.0));
  drawing.title = "What these cuts cannot reach";
  drawing.bar_title = "target - best reachable, length [mm]";
  drawing.unknown = "no target here, or not computed";
  return draw_map(scene, drawing, panel_size);
}

Image regions_picture(const PlanScene& scene, PixelSize panel_size)
{
  Picture picture(static_cast<int>(all_views.size()), panel_size);
  const auto map = region_map();
  const std::vector<LegendEntry> legend = region_legend(scene, map);
  const std::size_t rows = (legend.size() + all_views.size() - 1) / all_views.size();
  const Margins margins = annotation_margins(picture.panel(0), rows);
  const std::vector<Surface> skin{scene.pictures().skin};
  const double mm_per_pixel = common_scale(skin, picture.panel(0), margins);
  for (std::size_t i = 0; i < all_views.size(); ++i)
  {
    const Panel& panel = picture.panel(static_cast<int>(i));
    add_categories(panel, skin[0], region_array, map);
    add_title(panel, i == 0 ? "Regions of the face" : "", view_title(all_views[i]));
    add_legend(panel, part_of(legend, i, rows));
    frame(panel, all_views[i], skin, margins, mm_per_pixel);
    add_scale(panel, mm_per_pixel);
  }
  return picture.render();
}

Image bones_picture(const PlanScene& scene, BoneState state, View view, PixelSize size)
{
  Picture picture(1, size);
  draw_bones(picture.panel(0), scene, state, view);
  return picture.render();
}

Image bones_comparison(const PlanScene& scene, View view, PixelSize panel_size)
{
  Picture picture(2, panel_size);
  draw_bones(picture.panel(0), scene, BoneState::Before, view);
  draw_bones(picture.panel(1), scene, BoneState::After, view);
  return picture.render();
}

Image face_over_bones_picture(const PlanScene& scene, PixelSize panel_size)
{
  constexpr double opacity = 0.32;
  Picture picture(static_cast<int>(all_views.size()), panel_size);
  std::vector<Surface> surfaces = scene.faces();
  const std::vector<Surface> bones = scene.bones();
  surfaces.insert(surfaces.end(), bones.begin(), bones.end());
  const Margins margins = bone_margins(picture.panel(0), scene);
  const double mm_per_pixel = common_scale(surfaces, picture.panel(0), margins);
  const Surface face = scene.has_predicted() ? scene.pictures().predicted : scene.pictures().skin;
  for (std::size_t i = 0; i < all_views.size(); ++i)
  {
    const Panel& panel = picture.panel(static_cast<int>(i));
    draw_bone_surfaces(panel, scene, BoneState::After);
    add_skin(panel, face, opacity);
    add_title(panel, i > 0 ? "" : "Face over planned bones", view_title(all_views[i]));
    frame(panel, all_views[i], surfaces, margins, mm_per_pixel);
    add_scale(panel, mm_per_pixel);
  }
  std::vector<LegendEntry> legend = fragment_legend(scene, false);
  legend.push_back(
      {scene.has_predicted() ? "Predicted face" : "Face before", skin_colour, opacity});
  add_legend(picture.panel(0), legend);
  return picture.render();
}

} // namespace f2b
