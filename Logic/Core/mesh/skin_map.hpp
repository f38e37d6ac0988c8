#pragma once

#include "Core/mesh/mixed_mesh.hpp"

/// Where does each vertex of the reference skin lie on the finite-element skin?
namespace f2b
{

/// Place of one reference-skin vertex on the prisms' top faces.
struct SkinPlace
{
  int prism = -1;              ///< -1: the vertex has no finite-element skin near it
  Vec3 weights = Vec3::Zero(); ///< area coordinates on corners 0-2 of the prism, sum 1
};

/// One place per reference-skin vertex; interpolates nodal fields to the reference skin.
struct SkinMap
{
  std::vector<SkinPlace> places;

  /// Displacement of every reference-skin vertex [mm]; zero where the vertex has no place.
  std::vector<Vec3> displacement(const MixedMesh& mesh, const std::vector<Vec3>& x) const;
};

} // namespace f2b
