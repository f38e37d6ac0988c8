#pragma once

#include "Core/geometry/osteotomy.hpp"

#include <map>

/// Where do the usual osteotomies lie on this patient?
namespace f2b
{

/// Named anatomical points [mm, RAS].
using Landmarks = std::map<std::string, Vec3>;

/// The names that `osteotomy_from_template` knows.
std::vector<std::string> osteotomy_template_names();

/// The landmarks without which a template cannot be placed. Throws Error on an unknown name.
std::vector<std::string> landmarks_of_template(const std::string& name);

/// Places a template's planes by landmarks, as a first cut that the surgeon edits.
///
/// - `le-fort-1`: level of the piriform rim, 5 mm above the palatal plane; behind the tuberosities;
///   between the tooth rows. Needs ANS, PNS, Or_R, Or_L, U1, U6_R, U6_L; uses L1 if there.
/// - `le-fort-3`: nasofrontal suture through the orbits to the pterygomaxillary junction; arches;
///   between the tooth rows. Needs N and the landmarks above.
/// - `le-fort-2`: root of the nose, medial orbits, lower rims, down to the buttresses; between the
///   tooth rows. Needs what `le-fort-3` needs.
/// - `zygoma-right`, `zygoma-left`: lateral and lower rim of the orbit, buttress, arch. Needs N and
///   ANS, PNS, Or and Zy, U6 of both sides.
/// - `genioplasty`: from below B back to the lower border of the mandible. Needs Or_R, Or_L, B, Pg,
///   Me, Go_R, Go_L.
/// - `bsso`: bilateral sagittal split, simplified to one vertical plane a side behind the molars
///   and one between the tooth rows; frees the tooth-bearing mandible with the chin. Needs ANS,
///   PNS, Or_R, Or_L, U1, U6_R, U6_L, B, Me, Go_R, Go_L; uses L1 if there.
/// - `bsso-right`, `bsso-left`: the segments behind those of `bsso`, with their condyles: the
///   vertical plane, an arch over the condyle and planes at its poles. Needs Co of its side as well.
/// \param fragment  name of the freed fragment
/// Throws Error naming the template or the landmark that is not there.
Osteotomy osteotomy_from_template(const std::string& name, const std::string& fragment,
                                  const Landmarks& landmarks, double kerf_mm);

} // namespace f2b
