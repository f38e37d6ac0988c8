#include "Bridge/ply_file.hpp"

#include "Core/error.hpp"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace f2b
{
namespace
{

struct Property
{
  std::size_t count_bytes = 0; ///< of a list's length; 0: no list
  std::size_t bytes = 0;
};

struct Element
{
  long count = 0;
  std::vector<Property> properties;
};

struct Header
{
  std::string format;
  std::vector<Element> elements;
  bool complete = false;
};

std::size_t bytes_of(const std::string& type)
{
  static const std::map<std::string, std::size_t> known = {
      {"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},  {"short", 2}, {"ushort", 2},
      {"int16", 2}, {"uint16", 2},  {"int", 4},    {"uint", 4},   {"int32", 4}, {"uint32", 4},
      {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
  const auto found = known.find(type);
  return found == known.end() ? 0 : found->second;
}

/// What a header line says; false if it cannot be understood.
bool take_line(const std::string& line, Header& header)
{
  std::istringstream words(line);
  std::string keyword, type, count_type, name;
  words >> keyword;
  if (keyword == "format")
    return static_cast<bool>(words >> header.format);
  if (keyword == "element")
  {
    header.elements.emplace_back();
    return words >> name >> header.elements.back().count && header.elements.back().count >= 0;
  }
  if (keyword != "property")
    return true;
  words >> type;
  if (type == "list")
    words >> count_type >> type;
  if (header.elements.empty() || bytes_of(type) == 0)
    return false;
  header.elements.back().properties.push_back({bytes_of(count_type), bytes_of(type)});
  return count_type.empty() || bytes_of(count_type) > 0;
}

Header read_header(std::istream& file)
{
  Header header;
  std::string line;
  if (!std::getline(file, line) || line.substr(0, 3) != "ply")
    return header;
  while (std::getline(file, line))
  {
    if (line.substr(0, 10) == "end_header")
    {
      header.complete = !header.format.empty();
      return header;
    }
    if (!take_line(line, header))
      return header;
  }
  return header;
}

/// One number, of the size and byte order of a binary file's list length.
bool read_length(std::istream& file, std::size_t bytes, bool big_endian, std::uint64_t& length)
{
  char buffer[8] = {};
  if (!file.read(buffer, static_cast<std::streamsize>(bytes)))
    return false;
  length = 0;
  for (std::size_t i = 0; i < bytes; ++i)
    length = length << 8 | static_cast<unsigned char>(buffer[big_endian ? i : bytes - 1 - i]);
  return true;
}

bool binary_is_whole(std::istream& file, const Header& header)
{
  const bool big_endian = header.format == "binary_big_endian";
  for (const Element& element : header.elements)
    for (long i = 0; i < element.count; ++i)
      for (const Property& property : element.properties)
      {
        std::uint64_t length = 1;
        if (property.count_bytes && !read_length(file, property.count_bytes, big_endian, length))
          return false;
        if (!file.ignore(static_cast<std::streamsize>(length * property.bytes)) ||
            file.gcount() != static_cast<std::streamsize>(length * property.bytes))
          return false;
      }
  return true;
}

/// Whether a line holds as many numbers as its element needs.
bool row_is_whole(const std::string& line, const Element& element)
{
  std::istringstream words(line);
  std::string word;
  for (const Property& property : element.properties)
  {
    long length = 1;
    if (property.count_bytes && !(words >> length))
      return false;
    for (; length > 0; --length)
      if (!(words >> word))
        return false;
  }
  return true;
}

bool text_is_whole(std::istream& file, const Header& header)
{
  std::string line;
  for (const Element& element : header.elements)
    for (long i = 0; i < element.count; ++i)
    {
      do
        if (!std::getline(file, line))
          return false;
      while (
          std::all_of(line.begin(), line.end(), [](unsigned char c) { return std::isspace(c); }));
      if (!row_is_whole(line, element))
        return false;
    }
  return true;
}

} // namespace

void require_whole_ply(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  const Header header = read_header(file);
  if (!header.complete)
    throw Error(path.string(), "its header is not that of a .ply file",
                "check that the file is whole");
  if (!(header.format == "ascii" ? text_is_whole(file, header) : binary_is_whole(file, header)))
    throw Error(path.string(), "it ends before all of its vertices and faces",
                "export the mesh again");
}

} // namespace f2b
