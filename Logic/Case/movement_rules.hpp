#pragma once

#include "Case/case_session.hpp"
#include "Core/inverse/movement_space.hpp"

/// What does a case allow its fragments to do?
namespace f2b
{

/// The rules of every fragment of a meshed case, in the mesh's order: `osteotomies[].movement` of
/// the case with its landmarks and splints read. Throws Error naming the key or the file.
std::vector<FragmentRules> movement_rules(const CaseSession& session, const MixedMesh& mesh);

} // namespace f2b
