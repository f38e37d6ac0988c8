#include "CommandLine/screenshot_arguments.hpp"

#include "Rendering/framing.hpp"
#include "Rendering/subject.hpp"

#include <cmath>
#include <cstdio>

namespace f2b
{
namespace
{

/// "1800x1200" in pixels, or "170x120mm", which takes a --dpi.
std::string read_size(const std::string& text, ScreenshotOptions& options)
{
  double width = 0, height = 0;
  char unit[3] = "", rest = 0;
  const int fields = std::sscanf(text.c_str(), "%lfx%lf%2[m]%c", &width, &height, unit, &rest);
  const bool in_mm = fields == 3 && std::string(unit) == "mm";
  if (!(fields == 2 || in_mm) || !(width > 0 && height > 0 && width < 1e5 && height < 1e5))
    return text + " is no size such as 1800x1200 (pixels) or 170x120mm";
  if (in_mm && options.dpi == 0)
    options.dpi = 300;
  const double pixels = in_mm ? options.dpi / 25.4 : 1;
  options.width = static_cast<int>(std::lround(width * pixels));
  options.height = static_cast<int>(std::lround(height * pixels));
  return {};
}

std::string joined(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
    text += (text.empty() ? "" : ", ") + word;
  return text;
}

} // namespace

void add_screenshot_options(CLI::App& verb, ScreenshotOptions& options)
{
  std::vector<std::string> subjects, views;
  for (const Subject subject : all_subjects())
    subjects.push_back(name_of(subject));
  for (const View& view : named_views())
    views.push_back(view.name);
  verb.add_option("--show", options.show, "What to show, comma-separated: " + joined(subjects))
      ->delimiter(',')
      ->capture_default_str();
  verb.add_option("--view", options.views, "From where, comma-separated: " + joined(views))
      ->delimiter(',')
      ->capture_default_str();
  verb.add_option("-o,--output", options.output,
                  "Picture to write (.png); a folder with --definition, --turntable and --morph")
      ->required();
  verb.add_option("--dpi", options.dpi, "Dots per inch that the file states")
      ->check(CLI::Range(1, 2400));
  verb.add_option_function<std::string>(
          "--size",
          [&options](const std::string& text)
          {
            const std::string fault = read_size(text, options);
            if (!fault.empty())
              throw CLI::ValidationError("--size", fault);
          },
          "1800x1200 in pixels, or 170x120mm at --dpi [300]; 1200x1000 a panel where absent")
      ->trigger_on_parse(false);
  verb.add_option("--background", options.background, "light, white, dark or transparent")
      ->check(CLI::IsMember({"light", "white", "dark", "transparent"}))
      ->capture_default_str();
  verb.add_option("--slice", options.slice_mm,
                  "R, A or S of a CT slice [mm]; through the fragments where absent");
  verb.add_option("--fraction", options.fraction, "Of the way to the predicted face, for morph")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  auto* definition = verb.add_option("--definition", options.definition,
                                     "Many pictures (Resources/Schema/views.schema.json)");
  auto* turntable = verb.add_option("--turntable", options.turntable,
                                    "Frames once around; a film too where ffmpeg is there");
  auto* morph = verb.add_option("--morph", options.morph, "Frames from before to predicted");
  for (CLI::Option* frames : {turntable, morph})
    frames->check(CLI::Range(1, 3600))->excludes(definition);
  morph->excludes(turntable);
  verb.add_option("--texts", options.texts, "A translation of Resources/texts/en.json");
}

Path folder_of_case(const Path& named)
{
  if (!std::filesystem::is_regular_file(named))
    return named;
  return named.has_parent_path() ? named.parent_path() : Path(".");
}

} // namespace f2b
