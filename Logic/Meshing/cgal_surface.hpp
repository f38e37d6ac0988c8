#pragma once

#include "Core/geometry/vectors.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

/// How does a triangulation travel to CGAL and back? For this room's sources only.
namespace f2b
{

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalPoint = CgalKernel::Point_3;
using CgalSurface = CGAL::Surface_mesh<CgalPoint>;

/// \param refused  triangles that are left out, because a manifold does not have them
/// \param number   if given: per face of the result, its triangle
CgalSurface to_cgal(const TriangleMesh& mesh, std::size_t& refused,
                    std::vector<int>* number = nullptr);
TriangleMesh from_cgal(const CgalSurface& surface);

} // namespace f2b
