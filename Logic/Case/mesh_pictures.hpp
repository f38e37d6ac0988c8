#pragma once

#include "Case/case_folder.hpp"
#include "Rendering/plan_scene.hpp"

namespace f2b
{

/// The parts of the mesh's boundary, and the tissue's contact surfaces on the fragments before and
/// after the virtual forces (once there is a plan).
void add_mesh_pictures(PlanPictures& pictures, const CaseFolder& folder);

} // namespace f2b
