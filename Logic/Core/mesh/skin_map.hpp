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

/// One place per reference-skin vertex.
struct SkinMap
{
  std::vector<SkinPlace> places;
};

} // namespace f2b
