#pragma once

#include "Case/case_folder.hpp"
#include "Rendering/texts.hpp"

namespace f2b
{

/// The program's English texts; those of a translation, a file of the same keys, take their place.
/// Throws Error for a key that English does not have.
Texts case_texts(const Path& translation = {});

} // namespace f2b
