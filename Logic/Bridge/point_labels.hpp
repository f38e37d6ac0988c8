#pragma once

#include <vtkPolyData.h>

#include <string>
#include <vector>

/// How does a surface carry whole numbers, such as the regions of a face?
namespace f2b
{

/// Adds or replaces an integer point array.
void add_point_labels(vtkPolyData* surface, const std::string& name,
                      const std::vector<int>& values);
bool has_point_array(vtkPolyData* surface, const std::string& name);

} // namespace f2b
