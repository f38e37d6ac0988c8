#include <Rendering/bone_look.hpp>

#include <Rendering/surface_look.hpp>

namespace f2b
{

void add_bones(const Panel& panel, const PlanScene& scene, bool planned, bool in_colours)
{
  const PlanPictures& pictures = scene.pictures();
  add_bone(panel, pictures.uncut_bone, bone_colour);
  for (std::size_t i = 0; i < pictures.fragments.size(); ++i)
  {
    const FragmentPicture& fragment = pictures.fragments[i];
    add_bone(panel, planned ? fragment.planned : fragment.rest,
             in_colours ? fragment_colour(i) : bone_colour);
  }
}

std::vector<LegendEntry> fragment_legend(const PlanScene& scene, const Texts& texts,
                                         bool with_movement)
{
  std::vector<LegendEntry> entries{{texts("legend.bone-that-stays"), bone_colour}};
  const auto& fragments = scene.pictures().fragments;
  for (std::size_t i = 0; i < fragments.size(); ++i)
  {
    const bool has_text = with_movement && !fragments[i].movement.empty();
    entries.push_back(
        {fragments[i].name + (has_text ? ": " + fragments[i].movement : ""), fragment_colour(i)});
  }
  return entries;
}

} // namespace f2b
