#pragma once

#include "Core/progress.hpp"
#include "Imaging/ct_image.hpp"
#include "Imaging/label_edits.hpp"
#include "Imaging/lattice.hpp"
#include "Imaging/level_set_options.hpp"

#include <optional>
#include <string>
#include <vector>

/// Where are skin, bone and the tissues between them in a CT? Positions in mm, RAS.
namespace f2b
{

struct SegmentOptions
{
  std::optional<double> skin_threshold_hu; ///< default: from the histogram, about -220
  std::optional<double> bone_threshold_hu; ///< default: from the histogram, about 240
  std::optional<Box> region_ras;           ///< default: `face_region` of head_region.hpp
  double spacing_mm = 1.0;                 ///< of the lattice of the results
  double margin_mm = 12.0;                 ///< of the lattice around the region
  double head_closing_mm = 5.0;            ///< shuts mouth and nostrils
  double bone_closing_mm = 8.0;            ///< shuts sinuses, orbits' fissures, the mouth's cavity
  double skin_thickness_mm = 1.5;          ///< zeta, for the labels only
  double fat_threshold_hu = -30.0;         ///< below: fat; above: muscle
  double smallest_bone_ml = 0.5;           ///< smaller pieces of bone are dropped
  /// Bone by the level set instead of the threshold.
  std::optional<LevelSetBoneOptions> level_set;
  std::optional<LabelEdits> edits; ///< what a person drew counts more than either
};

/// Values of HeadSegmentation::labels.
enum class HeadLabel : unsigned char
{
  Air = 0,
  Skin = 1, ///< nearer to the face than the skin's thickness
  Fat = 2,
  Muscle = 3,
  Bone = 4,
  ClosedCavity = 5, ///< in the closed bone, not bone
  FilledAirway = 6, ///< air that the head's closing counts as inside
};

/// All grids lie on one lattice. Distances [mm] are negative inside.
struct HeadSegmentation
{
  ScalarGrid hu;          ///< the CT on the lattice
  ScalarGrid skin;        ///< distance to the face, mouth and nostrils shut, holder removed
  ScalarGrid bone;        ///< distance to the bone
  ScalarGrid closed_bone; ///< distance to the bone with its cavities shut and filled
  LabelGrid labels;       ///< HeadLabel
  Box region_ras;
  double skin_threshold_hu = 0;
  double bone_threshold_hu = 0;
  std::vector<std::string> notes; ///< what a reader of the report should know, a sentence each
};

/// \throws Error  thresholds that select nothing, a region without bone or skin, outside the CT or
///                with min >= max; names the values
HeadSegmentation segment_head(const CtImage& ct, const SegmentOptions& options = {},
                              const Progress& progress = no_progress);

} // namespace f2b
