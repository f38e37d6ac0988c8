#pragma once

#include "Core/geometry/osteotomy_templates.hpp"

#include <nlohmann/json.hpp>

/// How does a plan read in the patient's own axes?
namespace f2b
{

/// Adds `patient_frame` to a plan (origin and axes in scanner RAS, and what they rest on; or the
/// landmarks that are missing), and to every fragment of every method `in_patient_frame`: the same
/// movement along and about the patient's right, anterior and superior. The other numbers stay in
/// scanner RAS.
void add_patient_frame(nlohmann::json& plan, const Landmarks& landmarks);

} // namespace f2b
