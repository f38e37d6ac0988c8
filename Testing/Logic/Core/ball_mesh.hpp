#pragma once

#include "Logic/Core/sphere_mesh.hpp"

/// A ball of soft tissue in a skin of prisms: curved skin all around.
namespace f2b::testing
{

/// Node 0 is the centre, then the nodes under the skin, then the face.
inline MixedMesh make_ball(int levels, double radius_mm, double skin_mm)
{
  const TriangleMesh sphere = icosphere(levels);
  const int n = static_cast<int>(sphere.points.size());
  MixedMesh mesh;
  mesh.X = {Vec3::Zero()};
  for (const double radius : {radius_mm - skin_mm, radius_mm})
    for (const Vec3& p : sphere.points)
      mesh.X.push_back(radius * p);
  for (const auto& [a, b, c] : sphere.triangles)
  {
    mesh.prisms.push_back({1 + n + a, 1 + n + b, 1 + n + c, 1 + a, 1 + b, 1 + c});
    mesh.tets.push_back({0, 1 + a, 1 + b, 1 + c});
  }
  mesh.tet_tissue.assign(mesh.tets.size(), Tissue::Fat);
  mesh.node_boundary.assign(mesh.X.size(), Boundary::Interior);
  mesh.node_fragment.assign(mesh.X.size(), -1);
  for (int node = 1 + n; node < mesh.node_count(); ++node)
    mesh.node_boundary[std::size_t(node)] = Boundary::Skin;
  return mesh;
}

} // namespace f2b::testing
