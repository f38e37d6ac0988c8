#pragma once

#include <cstdlib>

namespace f2b::testing
{

/// How many random events something is tried with; FACETOBONE_RANDOM_EVENTS sets another number.
inline int random_event_count(int quick = 1500)
{
  const char* wanted = std::getenv("FACETOBONE_RANDOM_EVENTS");
  return wanted ? std::atoi(wanted) : quick;
}

} // namespace f2b::testing
