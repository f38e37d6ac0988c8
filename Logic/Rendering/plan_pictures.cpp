#include <Rendering/plan_pictures.hpp>

#include <Rendering/map_arrays.hpp>
#include <Rendering/offscreen_display.hpp>
#include <Rendering/quiet_messages.hpp>
#include <Rendering/views.hpp>

#include <vtkPointData.h>

namespace f2b
{

namespace
{

class Album
{
public:
  Album(const PlanScene& scene, std::filesystem::path folder, const PictureOptions& options)
      : m_scene(scene), m_folder(std::move(folder)), m_options(options)
  {
  }

  void add_faces(View view);
  void add_bones(View view);
  void add_maps();
  void add_reach();
  void add_face_over_bones();
  std::vector<WrittenPicture> take() { return std::move(m_written); }

private:
  void add(const Image& image, const WrittenPicture& about);
  void add_single_faces(View view);
  void add_single_bones(View view);

  const PlanScene& m_scene;
  std::filesystem::path m_folder;
  PictureOptions m_options;
  std::vector<WrittenPicture> m_written;
};

void Album::add(const Image& image, const WrittenPicture& about)
{
  WrittenPicture picture = about;
  picture.path = m_folder / (about.name + ".png");
  write_png(image, picture.path);
  m_written.push_back(picture);
}

void Album::add_single_faces(View view)
{
  const auto add_state = [&](FaceState state, const std::string& name, const std::string& title)
  {
    add(face_picture(m_scene, state, view, m_options.single),
        {name + "_" + view_name(view), title + ", " + view_title(view), "", {}, false});
  };
  add_state(FaceState::Before, "face_before", "Face before");
  if (m_scene.has_target())
  {
    add_state(FaceState::Target, "face_target", "Target face");
  }
  if (m_scene.has_predicted())
  {
    add_state(FaceState::Predicted, "face_predicted", "Predicted face");
  }
}

void Album::add_faces(View view)
{
  add(face_comparison(m_scene, view, m_options.panel),
      {"faces_" + view_name(view),
       "The face, " + view_title(view),
       "Face before, target face and the face predicted for the planned bone movement, side by "
       "side at one scale (parallel projection). Grey in the prediction: skin beyond the mesh, "
       "which was not computed.",
       {},
       true});
  if (m_options.singles)
  {
    add_single_faces(view);
  }
}

void Album::add_single_bones(View view)
{
  add(bones_picture(m_scene, BoneState::Before, view, m_options.single),
      {"bones_before_" + view_name(view), "Bones before, " + view_title(view), "", {}, false});
  add(bones_picture(m_scene, BoneState::After, view, m_options.single),
      {"bones_after_" + view_name(view), "Bones as planned, " + view_title(view), "", {}, false});
}

void Album::add_bones(View view)
{
  add(bones_comparison(m_scene, view, m_options.panel),
      {"bones_" + view_name(view),
       "The bones, " + view_title(view),
       "Bones before and as planned. Each fragment has its own colour; grey: where it was. The "
       "arrow is the movement of the fragment's reference point, to scale, with its length.",
       {},
       true});
  if (m_options.singles)
  {
    add_single_bones(view);
  }
}

void Album::add_maps()
{
  const PlanPictures& pictures = m_scene.pictures();
  if (m_scene.has_target() || pictures.skin->GetPointData()->GetArray(target_displacement_array))
  {
    add(target_region_picture(m_scene, m_options.panel),
        {"target_region",
         "What was asked for",
         "Length of the wished displacement of the skin, drawn on the face before.",
         {},
         true});
  }
  if (m_scene.has_distance())
  {
    add(distance_map_picture(m_scene, m_options.panel),
        {"distance_map",
         "What is reached",
         "Signed distance between the predicted and the target face in mm, drawn on the predicted "
         "face. Blue: the prediction lies behind the target; red: in front of it; grey: skin "
         "beyond the mesh, not computed. The range holds 99 % of the skin's vertices.",
         {},
         true});
  }
}

void Album::add_reach()
{
  if (m_scene.has_unreachable())
  {
    add(reachability_picture(m_scene, m_options.panel),
        {"reachability",
         "What these cuts cannot reach",
         "Length of what is left of the target in mm, drawn on the predicted face: no movement of "
         "these fragments brings the whole face nearer. Grey: nothing was asked for there, or the "
         "skin lies beyond the mesh.",
         {},
         true});
  }
  if (m_scene.has_regions())
  {
    add(regions_picture(m_scene, m_options.panel),
        {"regions",
         "Regions of the face",
         "The regions by which errors and reachability are told, drawn on the face before. They "
         "come from the landmarks and can be edited in the array 'region' of skin.vtp.",
         {},
         true});
  }
}

void Album::add_face_over_bones()
{
  add(face_over_bones_picture(m_scene, m_options.panel),
      {"face_over_bones",
       "Face over the planned bones",
       "The planned bones seen through the face.",
       {},
       true});
}

} // namespace

std::vector<WrittenPicture> write_plan_pictures(const PlanPictures& pictures,
                                                const std::filesystem::path& folder,
                                                const PictureOptions& options)
{
  const QuietMessages messages;
  const PlanScene scene(pictures);
  const OffscreenDisplay display;
  Album album(scene, folder, options);
  for (const View view : all_views)
  {
    album.add_faces(view);
  }
  album.add_maps();
  album.add_reach();
  for (const View view : all_views)
  {
    album.add_bones(view);
  }
  album.add_face_over_bones();
  return album.take();
}

} // namespace f2b
