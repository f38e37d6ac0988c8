#include "Case/bone_part_surface.hpp"

#include "Meshing/isosurface.hpp"

namespace f2b
{

vtkSmartPointer<vtkPolyData> bone_part_surface(const ScalarGrid& bone,
                                               const BonePartition& partition, unsigned char label)
{
  SurfaceOptions options;
  options.smoothing_iterations =
      0; // cut faces stay flat, and fragments fit to the bone that they came from
  return watertight_isosurface(part_field(bone, partition, label), 0, options);
}

} // namespace f2b
