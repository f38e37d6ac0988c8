#pragma once

#include "Case/case_folder.hpp"
#include "Core/geometry/osteotomy.hpp"

/// Where did the verb `cut` place the saw?
namespace f2b
{

/// In the order of the fragments. Throws Error where the case has not been cut.
std::vector<Osteotomy> placed_osteotomies(const CaseFolder& folder);

} // namespace f2b
