#include "Bridge/obj_file.hpp"

#include "Core/error.hpp"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace f2b
{
namespace
{

/// A file that is being read, and where it is wrong if it is.
class ObjReader
{
public:
  explicit ObjReader(const std::filesystem::path& path) : m_path(path)
  {
    m_points->SetDataTypeToDouble();
  }
  ObjFile read();

private:
  void read_line(const std::string& line);
  void add_vertex(std::istringstream& words);
  void add_face(std::istringstream& words);
  vtkIdType vertex(const std::string& reference) const;
  [[noreturn]] void refuse(const std::string& problem) const
  {
    throw Error(m_path.string(), "line " + std::to_string(m_line) + " " + problem,
                "check that the file is whole and a Wavefront .obj");
  }

  std::filesystem::path m_path;
  long m_line = 0;
  vtkNew<vtkPoints> m_points;
  vtkNew<vtkCellArray> m_faces;
  std::string m_comments;
};

void ObjReader::add_vertex(std::istringstream& words)
{
  double p[3];
  for (double& coordinate : p)
  {
    std::string word;
    words >> word;
    char* end = nullptr; // unlike a stream, strtod understands "nan"
    coordinate = std::strtod(word.c_str(), &end);
    if (word.empty() || *end != '\0')
      refuse("has a vertex without three coordinates");
  }
  m_points->InsertNextPoint(p);
}

/// `7`, `7/1`, `7//3`, `7/1/3`; negative numbers count from the last vertex.
vtkIdType ObjReader::vertex(const std::string& reference) const
{
  const long number = std::strtol(reference.c_str(), nullptr, 10);
  const long index =
      number > 0 ? number - 1 : static_cast<long>(m_points->GetNumberOfPoints()) + number;
  if (number == 0 || index < 0 || index >= m_points->GetNumberOfPoints())
    refuse("uses the vertex '" + reference + "', which is not there");
  return index;
}

void ObjReader::add_face(std::istringstream& words)
{
  vtkNew<vtkIdList> corners;
  for (std::string word; words >> word;)
    corners->InsertNextId(vertex(word));
  if (corners->GetNumberOfIds() < 3)
    refuse("has a face with fewer than three corners");
  m_faces->InsertNextCell(corners);
}

void ObjReader::read_line(const std::string& line)
{
  ++m_line;
  std::istringstream words(line);
  std::string keyword;
  words >> keyword;
  if (keyword == "v")
    add_vertex(words);
  else if (keyword == "f")
    add_face(words);
  else if (!keyword.empty() && keyword[0] == '#')
    m_comments += line + "\n";
}

ObjFile ObjReader::read()
{
  std::ifstream file(m_path);
  if (!file)
    throw Error(m_path.string(), "it cannot be read", "check its permissions");
  for (std::string line; std::getline(file, line);)
    read_line(line);
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(m_points);
  surface->SetPolys(m_faces);
  return {surface, m_comments};
}

} // namespace

ObjFile read_obj(const std::filesystem::path& path)
{
  return ObjReader(path).read();
}

} // namespace f2b
