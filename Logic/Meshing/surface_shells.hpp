#pragma once

#include "Core/geometry/vectors.hpp"

/// Which connected surfaces is a triangulation made of?
namespace f2b
{

struct SurfaceShells
{
  std::vector<int> of;        ///< per triangle
  std::vector<double> volume; ///< per shell, signed [mm^3]
};

/// Triangles that share a point belong together.
SurfaceShells surface_shells(const TriangleMesh& mesh);

/// The wanted triangles with their points only.
TriangleMesh submesh(const TriangleMesh& mesh, const std::vector<char>& wanted);

/// One mesh after the other.
void append(TriangleMesh& mesh, const TriangleMesh& more);

/// Positive where the triangles face outwards [mm^3].
double signed_volume(const TriangleMesh& mesh);

} // namespace f2b
