#include "Imaging/label_edits.hpp"

#include "Core/error.hpp"
#include "Imaging/label_volume.hpp"
#include "Imaging/segment_head.hpp"
#include "Imaging/signed_distance.hpp"

#include <algorithm>
#include <memory>
#include <set>

namespace f2b
{
namespace
{

std::string lower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool mentions(const std::string& name, const std::vector<const char*>& words)
{
  return std::any_of(words.begin(), words.end(),
                     [&](const char* word) { return lower(name).find(word) != std::string::npos; });
}

/// The values of a label map that mean bone, and those that mean inside the head.
struct Meaning
{
  std::set<int> bone, head;
};

Meaning own_labels()
{
  Meaning meaning;
  meaning.bone = {static_cast<int>(HeadLabel::Bone)};
  for (int value = 1; value <= static_cast<int>(HeadLabel::FilledAirway); ++value)
    meaning.head.insert(value);
  return meaning;
}

Meaning by_name(const LabelVolume& volume, std::vector<std::string>& notes)
{
  Meaning meaning;
  for (const auto& [value, name] : volume.segments)
  {
    const bool bone = mentions(name, {"bone", "skull", "mandible", "maxilla", "teeth", "tooth"});
    const bool head = mentions(name, {"skin", "fat", "muscle", "soft tissue", "head"});
    if (bone)
      meaning.bone.insert(value);
    if (head || bone)
      meaning.head.insert(value);
    notes.push_back("Segment '" + name + "' counts as " +
                    (bone   ? "bone."
                     : head ? "soft tissue."
                            : "nothing: its name says neither bone nor soft tissue."));
  }
  // bone alone does not say where the skin is
  if (meaning.head == meaning.bone)
    meaning.head.clear();
  return meaning;
}

std::function<Drawn(const Vec3&)> sampler(const std::shared_ptr<LabelVolume>& volume,
                                          const std::set<int>& wanted)
{
  return [=](const Vec3& p)
  {
    const int value = wanted.empty() ? -1 : volume->at_lps(-p.x(), -p.y(), p.z());
    return value < 0 ? Drawn::Unsaid : wanted.count(value) ? Drawn::Is : Drawn::Not;
  };
}

} // namespace

LabelEdits read_label_edits(const std::filesystem::path& file)
{
  const auto volume = std::make_shared<LabelVolume>(read_label_volume(file));
  LabelEdits edits;
  const Meaning meaning = volume->is_segmentation ? by_name(*volume, edits.notes) : own_labels();
  if (meaning.bone.empty() && meaning.head.empty())
    throw Error(file.string(), "no segment has a name that says what it is",
                "call the segments bone, mandible, teeth, skin, muscle or fat");
  edits.bone = sampler(volume, meaning.bone);
  edits.head = sampler(volume, meaning.head);
  return edits;
}

std::size_t apply_edits(ScalarGrid& distance, const std::function<Drawn(const Vec3&)>& drawn)
{
  const auto half = static_cast<float>(0.5 * distance.spacing);
  std::size_t changed = 0, s = 0;
  ScalarGrid level = distance;
  for (int k = 0; k < distance.size.z(); ++k)
    for (int j = 0; j < distance.size.y(); ++j)
      for (int i = 0; i < distance.size.x(); ++i, ++s)
      {
        const Drawn said = drawn(distance.position(i, j, k));
        float& value = level.values[s];
        if (said == Drawn::Is && value >= 0)
          value = -half;
        else if (said == Drawn::Not && value < 0)
          value = half;
        else
          continue;
        ++changed;
      }
  if (changed > 0)
    distance = signed_distance(level);
  return changed;
}

} // namespace f2b
