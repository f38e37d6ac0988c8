#pragma once

#include "Core/geometry/scalar_grid.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// What did a person draw over the automatic segmentation?
///
/// Label maps are NRRD: our own labels.nrrd after editing (values of HeadLabel), or a segmentation of
/// 3D Slicer (.seg.nrrd), whose segments count by their names: bone, skull, mandible, maxilla, teeth
/// are bone; skin, fat, muscle, soft tissue, head are inside the head.
namespace f2b
{

/// What a place was drawn as.
enum class Drawn : unsigned char
{
  Unsaid, ///< outside the label map, or a Slicer segmentation without such segments
  Not,
  Is,
};

struct LabelEdits
{
  std::function<Drawn(const Vec3&point_ras)> bone, head;
  std::vector<std::string> notes; ///< what was understood, a sentence each
};

/// Throws Error naming the file: unreadable, overlapping segments (several layers), no label or
/// segment name that is known.
LabelEdits read_label_edits(const std::filesystem::path& file);

/// Makes a signed distance say what was drawn where it says otherwise; returns the samples changed.
std::size_t apply_edits(ScalarGrid& distance, const std::function<Drawn(const Vec3&)>& drawn);

} // namespace f2b
