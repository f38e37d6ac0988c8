#pragma once

#include <Rendering/plan_scene.hpp>

#include <string>
#include <vector>

/// Which values [mm] does a map show?
namespace f2b
{

constexpr const char* target_length_array = "target_length_mm";

/// The values of a scalar point array.
std::vector<double> point_values(const Surface& surface, const std::string& array);

/// Whether a scalar point array has a value that is not finite; false without the array.
bool has_unknown_values(const Surface& surface, const std::string& array);

/// The faces whose vertices all have a finite value of a scalar point array.
Surface known_part(const Surface& surface, const std::string& array);

/// The skin at rest with the length of its wished displacement: from target_displacement_array
/// (a length or a vector) if it is there, else from the target's vertices.
/// \throws f2b::Error when there is neither
Surface with_target_length(const PlanScene& scene);

} // namespace f2b
