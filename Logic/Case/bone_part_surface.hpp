#pragma once

#include "Bridge/vtk_surface.hpp"
#include "Core/geometry/osteotomy.hpp"

/// Which closed surface has a piece of the cut bone?
namespace f2b
{

/// The surface of one part without the kerf [mm, RAS].
/// \param label  BonePartition::uncut or first_fragment + index
vtkSmartPointer<vtkPolyData> bone_part_surface(const ScalarGrid& bone,
                                               const BonePartition& partition, unsigned char label);

} // namespace f2b
