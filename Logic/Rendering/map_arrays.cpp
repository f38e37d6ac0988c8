#include <Rendering/map_arrays.hpp>

#include <Core/error.hpp>

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>

namespace f2b
{

namespace
{

double tuple_length(vtkDataArray* array, vtkIdType i)
{
  double squares = 0;
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
  {
    squares += array->GetComponent(i, c) * array->GetComponent(i, c);
  }
  return std::sqrt(squares);
}

double moved_length(const Surface& from, const Surface& to, vtkIdType i)
{
  std::array<double, 3> a{}, b{};
  from->GetPoint(i, a.data());
  to->GetPoint(i, b.data());
  return std::sqrt(vtkMath::Distance2BetweenPoints(a.data(), b.data()));
}

} // namespace

std::vector<double> point_values(const Surface& surface, const std::string& array)
{
  vtkDataArray* data = surface->GetPointData()->GetArray(array.c_str());
  std::vector<double> values(static_cast<std::size_t>(surface->GetNumberOfPoints()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = data->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  return values;
}

bool has_unknown_values(const Surface& surface, const std::string& array)
{
  if (!surface->GetPointData()->HasArray(array.c_str()))
  {
    return false;
  }
  const std::vector<double> values = point_values(surface, array);
  return std::any_of(values.begin(), values.end(), [](double v) { return !std::isfinite(v); });
}

Surface known_part(const Surface& surface, const std::string& array)
{
  const std::vector<double> values = point_values(surface, array);
  auto part = Surface::New();
  part->SetPoints(surface->GetPoints());
  part->GetPointData()->ShallowCopy(surface->GetPointData());
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    surface->GetCellPoints(cell, corners);
    const vtkIdType* begin = corners->GetPointer(0);
    if (std::all_of(begin, begin + corners->GetNumberOfIds(),
                    [&](vtkIdType id)
                    { return std::isfinite(values[static_cast<std::size_t>(id)]); }))
    {
      cells->InsertNextCell(corners);
    }
  }
  part->SetPolys(cells);
  return part;
}

Surface with_target_length(const PlanScene& scene)
{
  const PlanPictures& pictures = scene.pictures();
  vtkDataArray* given = pictures.skin->GetPointData()->GetArray(target_displacement_array);
  if (!given && !pictures.target)
  {
    throw Error("target", "neither a target face nor its displacement is there",
                "run 'target' first");
  }
  vtkNew<vtkFloatArray> lengths;
  lengths->SetName(target_length_array);
  for (vtkIdType i = 0; i < pictures.skin->GetNumberOfPoints(); ++i)
  {
    lengths->InsertNextValue(static_cast<float>(
        given ? tuple_length(given, i) : moved_length(pictures.skin, pictures.target, i)));
  }
  auto skin = Surface::New();
  skin->ShallowCopy(pictures.skin);
  skin->GetPointData()->AddArray(lengths);
  return skin;
}

} // namespace f2b
