#include <Rendering/plan_pictures.hpp>

#include <Rendering/offscreen_display.hpp>
#include <Rendering/quiet_messages.hpp>

#include <algorithm>

namespace f2b
{

namespace
{

// 210 dots per inch and two pictures on an A4 page, letters of 6 points there, and quick enough in
// software.
constexpr PixelSize report_size{1500, 800};

std::vector<View> views(const std::vector<const char*>& names)
{
  std::vector<View> list;
  for (const char* name : names)
  {
    list.push_back(require_view(name));
  }
  return list;
}

bool can_be_shown(Subject subject, const PlanScene& scene)
{
  return missing_for(subject, scene).empty();
}

} // namespace

std::vector<PictureDefinition> report_pictures(const PlanScene& scene)
{
  const std::vector<View> around = views({"frontal", "profile-right", "three-quarter-right"});
  std::vector<PictureDefinition> list;
  const auto add = [&](const std::string& name, const std::vector<Subject>& wanted,
                       const std::vector<View>& from)
  {
    PictureDefinition definition;
    definition.name = name;
    std::copy_if(wanted.begin(), wanted.end(), std::back_inserter(definition.show),
                 [&](Subject subject) { return can_be_shown(subject, scene); });
    definition.views = from;
    definition.size = report_size;
    if (!definition.show.empty())
    {
      list.push_back(definition);
    }
  };
  const auto file_part = [](std::string view)
  {
    std::replace(view.begin(), view.end(), '-', '_');
    return view;
  };
  for (const View& view : around)
  {
    add("faces_" + file_part(view.name),
        {Subject::FaceBefore, Subject::FaceTarget, Subject::FacePredicted}, {view});
  }
  add("target_displacement", {Subject::TargetDisplacement}, around);
  add("distance_map", {Subject::DistanceMap}, around);
  add("reachability", {Subject::Reachability}, around);
  for (const View& view : around)
  {
    add("fragments_" + file_part(view.name), {Subject::FragmentsBefore, Subject::FragmentsAfter},
        {view});
  }
  add("intervals", {Subject::Intervals}, views({"frontal", "profile-right"}));
  add("face_over_skull", {Subject::FaceOverSkull}, around);
  add("ct_slices", {Subject::CtAxial, Subject::CtCoronal, Subject::CtSagittal}, {});
  add("regions", {Subject::Regions}, around);
  add("boundary_parts", {Subject::BoundaryParts},
      views({"three-quarter-right", "profile-left", "submental"}));
  add("contact_surfaces", {Subject::ContactSurfaces, Subject::ContactDistance},
      views({"three-quarter-right"}));
  return list;
}

std::vector<WrittenPicture> write_pictures(const PlanScene& scene,
                                           const std::vector<PictureDefinition>& definitions,
                                           const std::filesystem::path& folder, const Texts& texts)
{
  for (const PictureDefinition& definition : definitions)
  {
    for (const Subject subject : definition.show)
    {
      require_shown(subject, scene); // before anything is written
    }
  }
  const QuietMessages messages;
  const OffscreenDisplay display;
  std::vector<WrittenPicture> written;
  for (const PictureDefinition& definition : definitions)
  {
    written.push_back({definition.name, folder / (definition.name + ".png")});
    write_png(draw_picture(scene, definition, texts), written.back().path, definition.dpi);
  }
  return written;
}

} // namespace f2b
