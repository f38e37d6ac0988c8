#pragma once

#include "Core/mesh/skin_map.hpp"

/// Where does the reference skin lie on the finite-element skin?
namespace f2b
{

/// Maps every reference vertex to the nearest point of the prisms' top faces.
/// \param reach_mm  vertices farther from them get no place: they lie outside the meshed face
SkinMap map_skin(const MixedMesh& mesh, const std::vector<Vec3>& reference_skin,
                 double reach_mm = 2.0);

} // namespace f2b
