#pragma once

#include <string>
#include <vector>

namespace f2b
{

/// What to tell someone who wrote a word that is not known: `did you mean 'x'?` where one known
/// word is within three letters of it, else `known LABEL: a, b, c`.
std::string hint_for(const std::string& unknown, const std::vector<std::string>& known,
                     const std::string& label = "keys here");

} // namespace f2b
