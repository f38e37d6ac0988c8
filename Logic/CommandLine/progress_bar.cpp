#include "CommandLine/progress_bar.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

#include <unistd.h>

namespace f2b
{

ProgressBar::ProgressBar(bool quiet) : m_shown(!quiet && ::isatty(STDERR_FILENO)) {}

ProgressBar::~ProgressBar()
{
  if (m_shown && m_last_percent >= 0)
    std::fprintf(stderr, "\r\033[K");
}

Progress ProgressBar::callback()
{
  return [this](std::string_view what, double fraction) { draw(what, fraction); };
}

void ProgressBar::draw(std::string_view what, double fraction)
{
  const int percent = static_cast<int>(100 * std::clamp(fraction, 0.0, 1.0));
  if (!m_shown || (percent == m_last_percent && what == m_last_what))
    return;
  m_last_percent = percent;
  m_last_what = what;
  const int width = 30, filled = percent * width / 100;
  std::fprintf(stderr, "\r\033[K[%s%s] %3d %%  %s",
               std::string(static_cast<std::size_t>(filled), '#').c_str(),
               std::string(static_cast<std::size_t>(width - filled), '.').c_str(), percent,
               m_last_what.c_str());
  std::fflush(stderr);
}

} // namespace f2b
