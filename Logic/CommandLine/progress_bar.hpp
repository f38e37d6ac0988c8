#pragma once

#include "Core/progress.hpp"

#include <string>

namespace f2b
{

/// A bar on the terminal's error stream; silent where that is no terminal.
class ProgressBar
{
public:
  explicit ProgressBar(bool quiet);
  ~ProgressBar(); ///< clears the line

  Progress callback();

private:
  void draw(std::string_view what, double fraction);

  bool m_shown;
  int m_last_percent = -1;
  std::string m_last_what;
};

} // namespace f2b
