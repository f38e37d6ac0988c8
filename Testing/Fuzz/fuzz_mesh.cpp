#include "Fuzz/fuzzed_file.hpp"

#include <Bridge/mesh_file.hpp>

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>

/// A whole .vtu whose cells and arrays are any bytes: the XML around them is VTK's to read.
namespace
{

/// The next byte as a small number, mostly from -3; some are no whole numbers.
class Numbers
{
public:
  Numbers(const std::uint8_t* data, std::size_t size) : m_data(data), m_size(size) {}
  bool left() const { return m_at < m_size; }
  int next() { return left() ? static_cast<int>(m_data[m_at++]) - 3 : 0; }
  double next_real()
  {
    const int value = next();
    return value > 200 ? value / 0.0 : value > 150 ? value / 7.0 : value;
  }

private:
  const std::uint8_t* m_data;
  std::size_t m_size, m_at = 0;
};

void add_array(vtkFieldData* data, const char* name, vtkIdType tuples, Numbers& numbers)
{
  const int components = numbers.next();
  if (components > 100)
    return;
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(std::clamp(components, 1, 4));
  array->SetNumberOfTuples(tuples);
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
    array->SetValue(i, numbers.next_real());
  data->AddArray(array);
}

vtkSmartPointer<vtkUnstructuredGrid> grid_of(Numbers numbers)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  const int count = std::clamp(numbers.next(), 1, 30);
  for (int i = 0; i < count; ++i)
    points->InsertNextPoint(numbers.next_real(), numbers.next(), numbers.next());
  grid->SetPoints(points);
  for (int cells = std::clamp(numbers.next(), 0, 20); cells > 0; --cells)
  {
    static constexpr int types[] = {VTK_WEDGE, VTK_TETRA, VTK_HEXAHEDRON, VTK_VERTEX};
    vtkIdType corners[8];
    const int length = std::clamp(numbers.next(), 0, 8);
    for (int i = 0; i < length; ++i)
      corners[i] = numbers.next();
    grid->InsertNextCell(types[numbers.next() & 3], length, corners);
  }
  vtkNew<vtkStringArray> names;
  names->SetName("fragments");
  for (int fragments = numbers.next(); fragments > 0 && fragments < 5; --fragments)
    names->InsertNextValue("fragment");
  grid->GetFieldData()->AddArray(names);
  add_array(grid->GetPointData(), "boundary", count, numbers);
  add_array(grid->GetPointData(), "fragment", count, numbers);
  add_array(grid->GetCellData(), "tissue", grid->GetNumberOfCells(), numbers);
  return grid;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const auto file = f2b::fuzz::file_of(data, 0, ".vtu");
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(grid_of({data, size}));
  writer->Write();
  return f2b::fuzz::expect_orderly([&] { (void)f2b::read_mesh(file); });
}
