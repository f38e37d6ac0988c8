#include "Bridge/point_labels.hpp"

#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>

namespace f2b
{

void add_point_labels(vtkPolyData* surface, const std::string& name, const std::vector<int>& values)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name.c_str());
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  surface->GetPointData()->AddArray(array);
}

bool has_point_array(vtkPolyData* surface, const std::string& name)
{
  return surface->GetPointData()->HasArray(name.c_str()) == 1;
}

} // namespace f2b
