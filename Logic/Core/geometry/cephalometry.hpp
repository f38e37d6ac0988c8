#pragma once

#include "Core/geometry/bite.hpp"

/// What does a cephalometric analysis say of this face?
///
/// Landmarks are projected on the mid-sagittal plane, pairs by their middles, as on a lateral
/// cephalogram without magnification. Measures: Steiner 1953 (SNA, SNB, ANB, SN-MP), Downs 1948
/// (facial angle, convexity, FH-MP), Ricketts 1968 (E line), Legan and Burstone 1980 (soft tissue),
/// Jacobson 1975 (Wits). No norms are given: they depend on age, sex and population.
namespace f2b
{

/// A landmark's name and what it is; pairs end in _R and _L.
struct LandmarkDefinition
{
  const char* name;
  const char* meaning;
  bool soft_tissue;
};

/// The names that templates, frame and measures know.
const std::vector<LandmarkDefinition>& landmark_definitions();

struct CephalometricMeasure
{
  std::string name;       ///< "SNA", "convexity", "E line to ls", ...
  std::string unit;       ///< "deg" or "mm"
  double value = 0;       ///< finite
  std::string definition; ///< in one line, with what a positive sign means
};

/// The measures that these landmarks allow, always in the same order; those whose landmarks are
/// missing or coincide are left out.
///
/// To compare before with after a movement give both the mid-sagittal plane at rest.
std::vector<CephalometricMeasure> cephalometry(const Landmarks& landmarks,
                                               const MidSagittalPlane& mid_sagittal);
/// With the landmarks' own mid-sagittal plane; empty where N, Or_R or Or_L is missing.
std::vector<CephalometricMeasure> cephalometry(const Landmarks& landmarks);

/// Measures that these landmarks do not allow, and the landmarks that they would need.
struct LeftOutMeasures
{
  std::vector<std::string> landmarks; ///< in the order of landmark_definitions()
  std::vector<std::string> measures;  ///< in the order of cephalometry()
};
LeftOutMeasures left_out_measures(const Landmarks& landmarks);

} // namespace f2b
