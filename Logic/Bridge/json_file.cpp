#include "Bridge/json_file.hpp"

#include "Core/error.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace f2b
{

nlohmann::json read_json(const std::filesystem::path& path)
{
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path))
    throw Error(path.string(), "it cannot be read", "check the path and its permissions");
  std::stringstream text;
  text << file.rdbuf();
  const std::string content = text.str();
  try
  {
    nlohmann::json document = nlohmann::json::parse(content);
    if (!document.is_object())
      throw Error(path.string(),
                  std::string("it holds ") + document.type_name() + ", not an object",
                  "give a file that begins with '{', as FaceToBone and Slicer write it");
    return document;
  }
  catch (const nlohmann::json::out_of_range&)
  {
    throw Error(path.string(), "it holds a number that is too large", "correct the number");
  }
  catch (const nlohmann::json::parse_error& error)
  {
    const auto byte =
        static_cast<std::ptrdiff_t>(std::min<std::size_t>(error.byte, content.size()));
    const auto line = 1 + std::count(content.begin(), content.begin() + byte, '\n');
    throw Error(path.string(), "it is not valid JSON near line " + std::to_string(line),
                "correct that line: a missing comma, quote or bracket is the usual cause");
  }
}

void write_json(const std::filesystem::path& path, const nlohmann::json& document)
{
  std::ofstream file(path);
  file << document.dump(2) << '\n';
  file.close();
  if (!file)
    throw Error(path.string(), "it cannot be written",
                "check the folder's permissions and free space");
}

} // namespace f2b
