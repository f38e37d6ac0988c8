#include "Case/case_pictures.hpp"
#include "Case/case_texts.hpp"
#include "Case/verbs.hpp"
#include "Case/view_definitions.hpp"
#include "Core/error.hpp"
#include "Rendering/child_program.hpp"
#include "Rendering/plan_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace f2b
{
namespace
{

constexpr int frames_per_second = 25;

PictureDefinition asked_picture(const ScreenshotOptions& options)
{
  PictureDefinition picture;
  for (const std::string& subject : options.show)
    picture.show.push_back(require_subject(subject));
  for (const std::string& view : options.views)
    picture.views.push_back(require_view(view));
  picture.size = {1200 * panel_count(picture), 1000};
  if (options.width > 0)
    picture.size = {options.width, options.height};
  picture.dpi = options.dpi;
  picture.background = require_background(options.background);
  picture.options.fraction = options.fraction;
  picture.options.slice_mm = options.slice_mm;
  return picture;
}

/// The same picture again and again, from all around or on the way to the predicted face.
std::vector<PictureDefinition> frames_of(const PictureDefinition& picture,
                                         const ScreenshotOptions& options)
{
  const int count = std::max(options.turntable, options.morph);
  std::vector<PictureDefinition> frames;
  for (int i = 0; i < count; ++i)
  {
    char name[32];
    std::snprintf(name, sizeof name, "frame_%04d", i);
    PictureDefinition frame = picture;
    frame.name = name;
    if (options.turntable > 0)
      for (View& view : frame.views)
      {
        view.azimuth_deg += 360.0 * i / count;
        view.turned_deg = static_cast<int>(std::lround(360.0 * i / count));
      }
    else
      frame.options.fraction = count > 1 ? double(i) / (count - 1) : 1;
    frames.push_back(frame);
  }
  return frames;
}

PictureNeeds needs_of(const std::vector<PictureDefinition>& pictures)
{
  PictureNeeds needs;
  for (const PictureDefinition& picture : pictures)
    for (const Subject subject : picture.show)
    {
      needs.ct = needs.ct || is_ct_slice(subject);
      needs.mesh = needs.mesh || subject == Subject::BoundaryParts ||
                   subject == Subject::ContactSurfaces || subject == Subject::ContactDistance;
    }
  return needs;
}

/// Frames of an earlier, longer film would end up in the new one.
void remove_frames(const Path& folder)
{
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().filename().string().rfind("frame_", 0) == 0 &&
        entry.path().extension() == ".png")
      std::filesystem::remove(entry.path());
}

/// An animation of the frames, where the machine has ffmpeg; whole or not at all.
void make_film(const Path& folder)
{
  const auto ffmpeg = find_program("ffmpeg");
  if (!ffmpeg)
    return;
  const Path film = folder / "animation.mp4", part = folder / ".animation.part.mp4";
  const ChildResult done =
      run_program(*ffmpeg,
                  {"-nostdin", "-loglevel", "error", "-y", "-framerate",
                   std::to_string(frames_per_second), "-i", (folder / "frame_%04d.png").string(),
                   "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white", "-pix_fmt", "yuv420p",
                   "-fflags", "+bitexact", "-flags:v", "+bitexact", part.string()},
                  std::chrono::minutes(10));
  std::error_code ignored;
  if (done.exit_code == 0)
    std::filesystem::rename(part, film, ignored);
  else
  {
    std::filesystem::remove(part, ignored);
    throw Error(film.string(), "ffmpeg could not make it: " + done.messages,
                "the frames are there; make it with another program");
  }
}

void make_folder(const Path& folder)
{
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed)
    throw Error(folder.string(), "it cannot be made: " + failed.message(),
                "give a folder that you may write to");
}

} // namespace

void screenshot_case(CaseSession& session, const ScreenshotOptions& options)
{
  session.progress("reading the case", 0);
  const bool is_film = options.turntable > 0 || options.morph > 0;
  std::vector<PictureDefinition> pictures;
  Path folder = options.output;
  if (!options.definition.empty())
    pictures = read_view_definitions(options.definition);
  else if (is_film)
    pictures = frames_of(asked_picture(options), options);
  else
  {
    if (options.output.extension() != ".png")
      throw Error(options.output.string(), "a picture's name must end in .png", "name it so");
    pictures = {asked_picture(options)};
    pictures[0].name = options.output.stem().string();
    folder = options.output.parent_path().empty() ? "." : options.output.parent_path();
  }
  const PlanScene scene(case_pictures(session.folder, needs_of(pictures)));
  make_folder(folder);
  if (is_film)
    remove_frames(folder);
  session.progress("drawing", 0.3);
  write_pictures(scene, pictures, folder, case_texts(options.texts));
  if (is_film)
    make_film(folder);
  session.progress("drawn", 1);
}

} // namespace f2b
