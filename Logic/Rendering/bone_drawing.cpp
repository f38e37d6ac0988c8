#include <Rendering/subject_drawing.hpp>

#include <Rendering/bone_look.hpp>
#include <Rendering/interval_glyph.hpp>
#include <Rendering/movement_arrows.hpp>
#include <Rendering/surface_look.hpp>

namespace f2b
{

namespace
{

void draw_movements(const Panel& panel, const PlanScene& scene, const ViewAxes& axes,
                    double mm_per_pixel)
{
  add_bones(panel, scene, true, true);
  for (const FragmentPicture& fragment : scene.pictures().fragments)
  {
    add_ghost(panel, fragment.rest);
    add_movement_arrow(panel, fragment, axes, mm_per_pixel);
  }
}

void draw_with_cuts(const Panel& panel, const PlanScene& scene)
{
  add_bones(panel, scene, false, true);
  if (scene.pictures().cut_planes)
  {
    add_planes(panel, scene.pictures().cut_planes);
  }
}

std::vector<LegendEntry> interval_legend(const PlanScene& scene, const Texts& texts,
                                         double enlarged)
{
  std::vector<LegendEntry> entries;
  const auto& fragments = scene.pictures().fragments;
  for (std::size_t i = 0; i < fragments.size(); ++i)
  {
    if (fragments[i].intervals)
    {
      entries.push_back({fragments[i].name + ": " + interval_text(*fragments[i].intervals, texts),
                         fragment_colour(i)});
    }
  }
  entries.push_back(
      {texts("legend.interval", {{"times", std::to_string(int(enlarged))}}), interval_colour});
  return entries;
}

SubjectDrawing intervals(const PlanScene& scene, const Texts& texts)
{
  const double enlarged = interval_enlargement(scene);
  SubjectDrawing drawing;
  drawing.legend = interval_legend(scene, texts, enlarged);
  drawing.draw = [&scene, enlarged](const Panel& panel, const ViewAxes& axes, double mm_per_pixel)
  {
    add_bones(panel, scene, true, true);
    for (const FragmentPicture& fragment : scene.pictures().fragments)
    {
      if (fragment.intervals)
      {
        add_interval_glyph(panel, fragment, axes, enlarged, mm_per_pixel);
      }
    }
  };
  return drawing;
}

} // namespace

SubjectDrawing bone_drawing(Subject subject, const PlanScene& scene, const Texts& texts)
{
  SubjectDrawing drawing;
  const bool planned = subject == Subject::SkullPlanned;
  switch (subject)
  {
  case Subject::FragmentsBefore:
    drawing.legend = fragment_legend(scene, texts, false);
    if (scene.pictures().cut_planes)
    {
      drawing.legend.push_back({texts("legend.cut"), cut_colour, 0.6});
    }
    drawing.draw = [&scene](const Panel& panel, const ViewAxes&, double)
    { draw_with_cuts(panel, scene); };
    break;
  case Subject::FragmentsAfter:
    drawing.legend = fragment_legend(scene, texts, true);
    drawing.legend.push_back({texts("legend.position-before"), ghost_colour, 0.45});
    drawing.draw = [&scene](const Panel& panel, const ViewAxes& axes, double mm_per_pixel)
    { draw_movements(panel, scene, axes, mm_per_pixel); };
    break;
  case Subject::Intervals:
    drawing = intervals(scene, texts);
    break;
  default:
    drawing.draw = [&scene, planned](const Panel& panel, const ViewAxes&, double)
    { add_bones(panel, scene, planned, false); };
  }
  drawing.title = texts("subject." + name_of(subject));
  drawing.framed = scene.bones();
  return drawing;
}

} // namespace f2b
