#pragma once

#include <Rendering/annotation.hpp>
#include <Rendering/plan_scene.hpp>
#include <Rendering/texts.hpp>

/// How do the bones of a plan look together?
namespace f2b
{

/// Bone that stays, and the fragments at rest or where the plan puts them.
/// \param in_colours  each fragment in its own; else all in the bone's
void add_bones(const Panel& panel, const PlanScene& scene, bool planned, bool in_colours);

/// "Bone that stays", and a line for each fragment.
/// \param with_movement  also tells how it moves
std::vector<LegendEntry> fragment_legend(const PlanScene& scene, const Texts& texts,
                                         bool with_movement);

} // namespace f2b
