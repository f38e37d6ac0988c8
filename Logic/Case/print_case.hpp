#pragma once

#include "Case/case_session.hpp"

namespace f2b
{

/// The fragments at rest and where rigid-fit puts them, for printing: print/NAME_{rest,planned}.stl
/// or .ply in the case, or NAME_... in a folder elsewhere.
/// \param format  stl or ply
/// \param folder  empty: in the case
void export_fragments(CaseSession& session, const std::string& format, const Path& folder);

} // namespace f2b
