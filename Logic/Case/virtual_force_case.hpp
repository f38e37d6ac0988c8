#pragma once

#include "Case/case_session.hpp"
#include "Core/inverse/virtual_force.hpp"

/// How does a case ask for the virtual force, and what does its plan say about it?
namespace f2b
{

/// What `/solver/virtual_force` asks for; throws Error for a landmark that the case does not have.
VirtualForceOptions virtual_force_options(const CaseSession& session);

/// The force with which the skin was pulled, and how near that brought it.
nlohmann::json force_json(const VirtualForceOptions& options, const VirtualForceResult& dragged);

/// A plan's fragments, each with what its registration leaves (`registration`).
nlohmann::json with_registrations(nlohmann::json fragments,
                                  const std::vector<FragmentRegistration>& registrations);

} // namespace f2b
