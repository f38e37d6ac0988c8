#pragma once

#include <functional>
#include <string_view>

namespace f2b
{

/// Is told what is being done and how far it has come, in [0, 1]. May throw to cancel.
using Progress = std::function<void(std::string_view what, double fraction)>;

/// A progress that nobody looks at.
inline void no_progress(std::string_view, double) {}

} // namespace f2b
