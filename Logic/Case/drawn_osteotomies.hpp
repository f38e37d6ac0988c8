#pragma once

#include "Case/case_settings.hpp"
#include "Core/geometry/osteotomy_templates.hpp"

/// Where does a case want the saw?
namespace f2b
{

/// A template placed by landmarks, or the planes and curves that the user drew.
/// \param bone  signed distance, by which a curve without a direction is sawn inwards
/// Throws Error naming the file, the landmark or the curve that is wrong.
Osteotomy drawn_osteotomy(const OsteotomySettings& settings, const Landmarks& landmarks,
                          const ScalarGrid& bone);

/// Points close together on a structure that the saw should spare [mm, RAS].
std::vector<Vec3> points_of(const ProtectedSettings& structure);

} // namespace f2b
