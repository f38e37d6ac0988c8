#pragma once

#include "Core/geometry/osteotomy.hpp"

/// Which solid does the saw take away? Positions in mm, RAS.
namespace f2b
{

/// A saw of no width parts nothing exactly: a narrower kerf than this is cut with this width.
constexpr double thinnest_kerf_mm = 0.01;

/// The closed, outward-facing surface of the space that the saw sweeps: kerf_mm across the plane.
TriangleMesh blade_of(const BoundedPlane& plane, double kerf_mm);
/// The same along a curve. Throws Error as `require_swept` does.
TriangleMesh blade_of(const SweptCurve& curve, double kerf_mm);

/// A curve as rectangles, one a segment, for questions that are asked on a lattice.
std::vector<BoundedPlane> facets_of(const SweptCurve& curve);

/// A rectangle of a cut: a plane, or a segment of a curve.
struct SawFacet
{
  BoundedPlane plane;
  std::size_t osteotomy = 0, cut = 0; ///< cut: counted through all osteotomies, planes then curves
  double kerf_mm = 0;
};

std::vector<SawFacet> saw_facets(const std::vector<Osteotomy>& osteotomies);

} // namespace f2b
