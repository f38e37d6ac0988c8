#pragma once

#include "Case/case_folder.hpp"
#include "Scene/scene_settings.hpp"

/// Which results of a case rest on settings that its nodes no longer state?
namespace f2b
{

/// Sets the status of every step: current, stale or not done.
/// \param files  of the case folder
void mark_stale_steps(const CaseOutlook& files, const CaseNodes& nodes);

} // namespace f2b
