#include <Rendering/texts.hpp>

#include <Core/error.hpp>

namespace f2b
{

const std::string& Texts::operator()(const std::string& key) const
{
  const auto found = m_table.find(key);
  if (found == m_table.end())
  {
    throw Error("texts", "there is none for '" + key + "'", "add it to the file of texts");
  }
  return found->second;
}

std::string Texts::operator()(const std::string& key, const Table& values) const
{
  const std::string& pattern = (*this)(key);
  std::string text;
  for (std::size_t at = 0; at < pattern.size();)
  {
    const std::size_t end = pattern[at] == '{' ? pattern.find('}', at) : std::string::npos;
    const auto value =
        end == std::string::npos ? values.end() : values.find(pattern.substr(at + 1, end - at - 1));
    if (value == values.end())
    {
      text += pattern[at++];
      continue;
    }
    text += value->second; // never looked through for places: it may be a user's text
    at = end + 1;
  }
  return text;
}

} // namespace f2b
