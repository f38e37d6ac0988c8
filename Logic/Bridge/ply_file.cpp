#include "Bridge/ply_file.hpp"

#include "Core/error.hpp"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <vector>

namespace f2b
{
namespace
{

enum class Kind
{
  natural,
  integer,
  real
};

struct Type
{
  Kind kind;
  std::size_t bytes;
};

struct Property
{
  std::string name;
  Type type;
  std::optional<Type> length; ///< of a list
};

struct Element
{
  std::string name;
  long count = 0;
  std::vector<Property> properties;
};

struct Header
{
  std::string format, comments;
  std::vector<Element> elements;
};

std::optional<Type> type_of(const std::string& name)
{
  static const std::map<std::string, Type> known = {
      {"char", {Kind::integer, 1}},   {"int8", {Kind::integer, 1}},
      {"uchar", {Kind::natural, 1}},  {"uint8", {Kind::natural, 1}},
      {"short", {Kind::integer, 2}},  {"int16", {Kind::integer, 2}},
      {"ushort", {Kind::natural, 2}}, {"uint16", {Kind::natural, 2}},
      {"int", {Kind::integer, 4}},    {"int32", {Kind::integer, 4}},
      {"uint", {Kind::natural, 4}},   {"uint32", {Kind::natural, 4}},
      {"float", {Kind::real, 4}},     {"float32", {Kind::real, 4}},
      {"double", {Kind::real, 8}},    {"float64", {Kind::real, 8}}};
  const auto found = known.find(name);
  return found == known.end() ? std::nullopt : std::optional(found->second);
}

/// `property float x` and `property list uchar int vertex_indices`; false if it is neither.
bool take_property(std::istringstream& words, Header& header)
{
  std::string type, length, name;
  words >> type;
  if (type == "list")
    words >> length >> type;
  words >> name;
  const std::optional<Type> stated = type_of(type), counted = type_of(length);
  if (header.elements.empty() || name.empty() || !stated || (!length.empty() && !counted) ||
      (counted && counted->kind == Kind::real))
    return false;
  header.elements.back().properties.push_back({name, *stated, counted});
  return true;
}

/// What a header line says; false if it cannot be understood.
bool take_line(const std::string& line, Header& header)
{
  std::istringstream words(line);
  std::string keyword;
  words >> keyword;
  if (keyword == "format")
    return words >> header.format &&
           (header.format == "ascii" || header.format == "binary_little_endian" ||
            header.format == "binary_big_endian");
  if (keyword == "element")
  {
    Element& element = header.elements.emplace_back();
    return words >> element.name >> element.count && element.count >= 0;
  }
  if (keyword == "property")
    return take_property(words, header);
  if (keyword == "comment")
    header.comments += line + "\n";
  return keyword.empty() || keyword == "comment" || keyword == "obj_info";
}

/// Nothing if the lines are not a header.
std::optional<Header> read_header(std::istream& file)
{
  Header header;
  std::string line;
  if (!std::getline(file, line) || line.substr(0, 3) != "ply")
    return std::nullopt;
  while (std::getline(file, line))
  {
    if (line.substr(0, 10) == "end_header")
      return header.format.empty() ? std::nullopt : std::optional(header);
    if (!take_line(line, header))
      return std::nullopt;
  }
  return std::nullopt;
}

template <class Value>
double value_of(const char* bytes)
{
  Value value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<double>(value);
}

/// The bytes of a number in this machine's order.
double number_of(const char* bytes, Type type)
{
  if (type.kind == Kind::real)
    return type.bytes == 4 ? value_of<float>(bytes) : value_of<double>(bytes);
  const bool natural = type.kind == Kind::natural;
  if (type.bytes == 1)
    return natural ? value_of<std::uint8_t>(bytes) : value_of<std::int8_t>(bytes);
  if (type.bytes == 2)
    return natural ? value_of<std::uint16_t>(bytes) : value_of<std::int16_t>(bytes);
  return natural ? value_of<std::uint32_t>(bytes) : value_of<std::int32_t>(bytes);
}

bool this_machine_is_big_endian()
{
  const std::uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 0;
}

/// The numbers behind the header, one after the other, and what is made of them.
class PlyReader
{
public:
  PlyReader(const std::filesystem::path& path, std::istream& file, const Header& header)
      : m_path(path), m_file(file), m_text(header.format == "ascii"),
        m_swapped((header.format == "binary_big_endian") != this_machine_is_big_endian())
  {
    m_points->SetDataTypeToDouble();
  }
  void read(const Element& element);
  vtkSmartPointer<vtkPolyData> surface() const;

private:
  double next(Type type);
  std::vector<double> next_list(const Property& property);
  void add_vertex(const Element& element);
  void add_face(const Element& element);
  [[noreturn]] void refuse(const std::string& problem) const
  {
    throw Error(m_path.string(), problem, "export the mesh again");
  }

  std::filesystem::path m_path;
  std::istream& m_file;
  bool m_text, m_swapped;
  vtkNew<vtkPoints> m_points;
  vtkNew<vtkCellArray> m_faces;
};

double PlyReader::next(Type type)
{
  constexpr const char* cut_short = "it ends before all of its vertices and faces";
  if (m_text)
  {
    std::string word;
    if (!(m_file >> word))
      refuse(cut_short);
    char* end = nullptr; // unlike a stream, strtod understands "nan"
    const double value = std::strtod(word.c_str(), &end);
    if (*end != '\0')
      refuse("it holds '" + word.substr(0, 20) + "' where a number belongs");
    return value;
  }
  std::array<char, 8> bytes{};
  if (!m_file.read(bytes.data(), static_cast<std::streamsize>(type.bytes)))
    refuse(cut_short);
  if (m_swapped)
    std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(type.bytes));
  return number_of(bytes.data(), type);
}

/// A list, or the one number of a property that is none.
std::vector<double> PlyReader::next_list(const Property& property)
{
  const double length = property.length ? next(*property.length) : 1;
  if (!(length >= 0 && length <= 1e9))
    refuse("it has a list of impossible length");
  std::vector<double> values; // grows with what is there, not with what is announced
  for (long i = 0; i < static_cast<long>(length); ++i)
    values.push_back(next(property.type));
  return values;
}

void PlyReader::add_vertex(const Element& element)
{
  double p[3] = {};
  int found = 0;
  for (const Property& property : element.properties)
  {
    const std::vector<double> values = next_list(property);
    for (int axis = 0; axis < 3; ++axis)
      if (property.name == std::string(1, "xyz"[axis]) && !property.length)
      {
        p[axis] = values.front();
        found |= 1 << axis;
      }
  }
  if (found != 7)
    refuse("its vertices have no x, y and z");
  m_points->InsertNextPoint(p);
}

void PlyReader::add_face(const Element& element)
{
  vtkNew<vtkIdList> corners;
  for (const Property& property : element.properties)
  {
    const std::vector<double> values = next_list(property);
    if (!property.length || (property.name != "vertex_indices" && property.name != "vertex_index"))
      continue;
    for (const double corner : values)
      if (corner >= 0 && corner < static_cast<double>(m_points->GetNumberOfPoints()))
        corners->InsertNextId(static_cast<vtkIdType>(corner));
      else
        refuse("face " + std::to_string(m_faces->GetNumberOfCells() + 1) +
               " has a vertex that is not there");
  }
  if (corners->GetNumberOfIds() < 3)
    refuse("it has a face with fewer than three corners");
  m_faces->InsertNextCell(corners);
}

void PlyReader::read(const Element& element)
{
  if (element.properties.empty() && element.count > 0)
    refuse("its element '" + element.name.substr(0, 40) + "' has no properties");
  for (long i = 0; i < element.count; ++i)
    if (element.name == "vertex")
      add_vertex(element);
    else if (element.name == "face")
      add_face(element);
    else
      for (const Property& property : element.properties)
        next_list(property);
}

vtkSmartPointer<vtkPolyData> PlyReader::surface() const
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(m_points);
  surface->SetPolys(m_faces);
  return surface;
}

} // namespace

PlyFile read_ply(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  const std::optional<Header> header = read_header(file);
  if (!header)
    throw Error(path.string(), "its header is not that of a .ply file",
                "check that the file is whole");
  PlyReader reader(path, file, *header);
  for (const Element& element : header->elements)
    reader.read(element);
  return {reader.surface(), header->comments};
}

} // namespace f2b
