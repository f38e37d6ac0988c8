#include "Imaging/segment_head.hpp"

#include "Core/error.hpp"
#include "Imaging/head_region.hpp"
#include "Imaging/histogram.hpp"
#include "Imaging/level_set_bone.hpp"
#include "Imaging/resample_ct.hpp"
#include "Imaging/tissue_surfaces.hpp"

#include <algorithm>
#include <future>
#include <iomanip>
#include <sstream>

namespace f2b
{
namespace
{

constexpr double coarse_spacing = 2.0;

std::string text(double value)
{
  std::ostringstream out;
  out << std::fixed << std::setprecision(0) << value;
  return out.str();
}

std::string text(const Box& box)
{
  std::ostringstream out;
  out << std::fixed << std::setprecision(0) << "R " << box.min.x() << ".." << box.max.x() << ", A "
      << box.min.y() << ".." << box.max.y() << ", S " << box.min.z() << ".." << box.max.z()
      << " mm";
  return out.str();
}

void require_threshold(const ScalarGrid& hu, double threshold, const char* key)
{
  const auto [lowest, highest] = std::minmax_element(hu.values.begin(), hu.values.end());
  if (threshold > *lowest && threshold < *highest)
    return;
  throw Error(key,
              text(threshold) + " HU selects nothing: the CT holds " + text(*lowest) + " to " +
                  text(*highest) + " HU",
              "choose a threshold in that range or leave it out");
}

void require_box(const Box& box, const Box& extent)
{
  for (int a = 0; a < 3; ++a)
    if (!(box.min[a] < box.max[a]))
      throw Error("region_ras", "is empty: " + text(box), "give min < max on every axis");
  for (int a = 0; a < 3; ++a)
    if (box.max[a] < extent.min[a] || box.min[a] > extent.max[a])
      throw Error("region_ras", "lies outside the CT: box " + text(box) + ", CT " + text(extent),
                  "give the box in RAS millimetres inside the CT");
}

void require_inside(const ScalarGrid& distance, const Box& region, const char* what,
                    const Box& extent)
{
  for (int k = 0; k < distance.size.z(); ++k)
    for (int j = 0; j < distance.size.y(); ++j)
      for (int i = 0; i < distance.size.x(); ++i)
      {
        const Vec3 p = distance.position(i, j, k);
        if (distance.values[distance.index(i, j, k)] < 0 &&
            (p.array() >= region.min.array()).all() && (p.array() <= region.max.array()).all())
          return;
      }
  throw Error("region_ras",
              std::string("holds no ") + what + ": box " + text(region) + ", CT " + text(extent),
              "move the box onto the face");
}

HeadLabel label_at(const HeadSegmentation& result, std::size_t s, const SegmentOptions& options)
{
  if (result.skin.values[s] >= 0)
    return HeadLabel::Air;
  if (result.bone.values[s] < 0)
    return HeadLabel::Bone;
  if (result.closed_bone.values[s] < 0)
    return HeadLabel::ClosedCavity;
  if (result.skin.values[s] > -options.skin_thickness_mm)
    return HeadLabel::Skin;
  if (result.hu.values[s] < result.skin_threshold_hu)
    return HeadLabel::FilledAirway;
  return result.hu.values[s] < options.fat_threshold_hu ? HeadLabel::Fat : HeadLabel::Muscle;
}

LabelGrid labels_of(const HeadSegmentation& result, const SegmentOptions& options)
{
  LabelGrid labels{result.hu.origin, result.hu.spacing, result.hu.size, {}};
  labels.values.resize(labels.count());
  for (std::size_t s = 0; s < labels.values.size(); ++s)
    labels.values[s] = static_cast<unsigned char>(label_at(result, s, options));
  return labels;
}

void choose_thresholds(const ScalarGrid& hu, const SegmentOptions& options,
                       HeadSegmentation& result)
{
  const TissuePeaks peaks = tissue_peaks(hu);
  result.skin_threshold_hu = options.skin_threshold_hu.value_or(automatic_skin_threshold(peaks));
  result.bone_threshold_hu = options.bone_threshold_hu.value_or(automatic_bone_threshold(peaks));
  require_threshold(hu, result.skin_threshold_hu, "skin_threshold_hu");
  require_threshold(hu, result.bone_threshold_hu, "bone_threshold_hu");
  if (result.skin_threshold_hu >= result.bone_threshold_hu)
    throw Error("skin_threshold_hu",
                text(result.skin_threshold_hu) + " HU is not below bone_threshold_hu " +
                    text(result.bone_threshold_hu) + " HU",
                "skin is about -220 HU, bone about 240 HU");
  result.notes.push_back("Peaks of the histogram: air " + text(peaks.air) + " HU, soft tissue " +
                         text(peaks.soft_tissue) + " HU.");
  result.notes.push_back("Skin threshold " + text(result.skin_threshold_hu) +
                         (options.skin_threshold_hu ? " HU (given)." : " HU (automatic)."));
  result.notes.push_back("Bone threshold " + text(result.bone_threshold_hu) +
                         (options.bone_threshold_hu ? " HU (given)." : " HU (automatic)."));
}

HeadMask whole_head(const CtImage& ct, const SegmentOptions& options, HeadSegmentation& result)
{
  const Lattice lattice = lattice_over(extent_ras(ct), coarse_spacing, anchor_ras(ct));
  const ScalarGrid hu = resample_ct(ct, lattice);
  choose_thresholds(hu, options, result);
  HeadMaskOptions mask_options;
  mask_options.skin_threshold_hu = result.skin_threshold_hu;
  mask_options.bone_threshold_hu = result.bone_threshold_hu;
  mask_options.head_closing_mm = options.head_closing_mm;
  mask_options.bone_closing_mm = options.bone_closing_mm;
  return find_head(hu, mask_options);
}

Lattice lattice_around(const Box& region, const CtImage& ct, const SegmentOptions& options)
{
  const Vec3 margin = Vec3::Constant(options.margin_mm);
  return lattice_over({region.min - margin, region.max + margin}, options.spacing_mm,
                      anchor_ras(ct));
}

/// What a person drew over what was found.
void respect(const LabelEdits& edits, HeadSegmentation& result)
{
  const std::size_t bone = apply_edits(result.bone, edits.bone),
                    skin = apply_edits(result.skin, edits.head);
  result.notes.insert(result.notes.end(), edits.notes.begin(), edits.notes.end());
  result.notes.push_back("The drawn labels changed " + std::to_string(bone) +
                         " samples of bone and " + std::to_string(skin) + " of the head.");
}

void find_surfaces(const HeadMask& head, const SegmentOptions& options, HeadSegmentation& result)
{
  const TissueSurfaceOptions surfaces{result.skin_threshold_hu, result.bone_threshold_hu,
                                      options.head_closing_mm, options.bone_closing_mm,
                                      options.smallest_bone_ml};
  auto bone = std::async(std::launch::async,
                         [&]
                         {
                           return options.level_set ? level_set_bone(result.hu, head, surfaces,
                                                                     *options.level_set)
                                                    : bone_distance(result.hu, head, surfaces);
                         });
  result.skin = face_distance(result.hu, head, surfaces);
  result.bone = bone.get();
  if (options.edits)
    respect(*options.edits, result);
  result.closed_bone = closed_bone_distance(result.hu, result.skin, result.bone, head, surfaces);
}

} // namespace

HeadSegmentation segment_head(const CtImage& ct, const SegmentOptions& options,
                              const Progress& progress)
{
  const Box extent = extent_ras(ct);
  if (options.region_ras)
    require_box(*options.region_ras, extent);
  HeadSegmentation result;
  progress("Finding the head", 0.0);
  const HeadMask head = whole_head(ct, options, result);
  result.region_ras = options.region_ras ? *options.region_ras : face_region(head);
  if (!options.region_ras)
    result.notes.push_back("Region (automatic, the face): " + text(result.region_ras) + ".");
  progress("Resampling the CT", 0.3);
  result.hu = resample_ct(ct, lattice_around(result.region_ras, ct, options));
  progress("Distances to skin and bone", 0.4);
  find_surfaces(head, options, result);
  require_inside(result.skin, result.region_ras, "skin", extent);
  require_inside(result.bone, result.region_ras, "bone", extent);
  progress("Labelling tissues", 0.95);
  result.labels = labels_of(result, options);
  progress("Segmented", 1.0);
  return result;
}

} // namespace f2b
