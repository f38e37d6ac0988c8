#pragma once

#include "Rendering/plan_scene.hpp"
#include "Rendering/report_viewer.hpp"

namespace f2b
{

/// The interactive page of a report; none where this machine has no three.js (Debian's libjs-three,
/// or the file that the environment variable FACETOBONE_THREE_JS names).
std::optional<ViewerParts> case_viewer(const PlanScene& scene, const Texts& texts);

} // namespace f2b
