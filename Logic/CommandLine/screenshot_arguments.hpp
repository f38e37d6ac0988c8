#pragma once

#include "Case/verbs.hpp"

#include <CLI/CLI.hpp>

/// How does a user say on the command line which picture to draw?
namespace f2b
{

void add_screenshot_options(CLI::App& verb, ScreenshotOptions& options);

/// A case folder may be named by a file that lies in it.
Path folder_of_case(const Path& named);

} // namespace f2b
