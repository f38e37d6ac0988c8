#include "Bridge/key_hint.hpp"

#include <algorithm>

namespace f2b
{
namespace
{

/// Number of single-letter edits between two words (Levenshtein).
std::size_t edits(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j)
    row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j)
    {
      const std::size_t change = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, change});
    }
  }
  return row[b.size()];
}

} // namespace

std::string hint_for(const std::string& unknown, const std::vector<std::string>& known,
                     const std::string& label)
{
  std::string nearest, all;
  std::size_t distance = 4;
  for (const std::string& word : known)
  {
    all += (all.empty() ? "" : ", ") + word;
    // a short word is not "near" another that shares none of its letters
    const std::size_t needed = edits(word, unknown);
    if (needed < distance && needed < word.size())
    {
      distance = needed;
      nearest = word;
    }
  }
  return nearest.empty() ? "known " + label + ": " + all : "did you mean '" + nearest + "'?";
}

} // namespace f2b
