#pragma once

#include "Core/element/hermite_triangle.hpp"
#include "Core/element/quadrature_element.hpp"

/// What is a prism whose face is smooth (paper eq. 6): N12 = [N9*(1 - q), r q, s q, t q]?
///
/// Its 12 control vectors are x0 x1 x2, s0a s0b s1a s1b s2a s2b, x3 x4 x5: positions of the face's
/// corners, two slope vectors of each (derivatives along the node's two rest tangents [mm]), and
/// positions of the lower corners. The same functions carry rest and current positions
/// (isoparametric), so affine fields are exact on any skin.
namespace f2b
{

/// How an edge of a face leaves one of its corners.
struct EdgeSlope
{
  bool straight = false; ///< the slope is the difference of the edge's end points
  double a = 0, b = 0;   ///< else it is a s_a + b s_b of the corner's slope vectors
};

/// The six slopes of a face: number 2 i is corner i's towards corner i + 1, 2 i + 1 towards i + 2.
using FaceSlopes = std::array<EdgeSlope, 6>;

/// The functions of a face's nine control vectors are `map * face_functions(L)`.
using FaceMap = Eigen::Matrix<double, 9, FaceFunctions::count>;

/// \param corners  rest positions of the face's corners, one per column [mm]
FaceMap face_map(const Mat3& corners, const FaceSlopes& slopes);

/// With P points of `triangle_rule` at each of D Gauss points through the thickness. Compiled for
/// P = 3, 6, 7, 12 with D = 2, and for P = 96 with D = 4: the reference of the quadrature study.
template <int P, int D = 2>
using SmoothPrismOf = QuadratureElement<12, P * D>;
using SmoothPrism = SmoothPrismOf<6>;

/// A rest position that folds has volumes <= 0: ask `least_relative_jacobian` before use.
///
/// No rule integrates the rational N9* exactly, so the plain gradients would leave forces of a
/// constant stress out of balance at a shared face. Therefore each function's gradient is shifted,
/// by the same vector at all points of the element, to the mean that the divergence theorem gives
/// (`exact_mean_gradients`), and the volumes are scaled to the exact sum. This is the uniform
/// gradient of Flanagan & Belytschko (1981) kept as the mean, and the integration constraint of
/// Chen, Wu, Yoon & You (2001); F of an affine field is not changed.
/// \param Q  rest values of the control vectors [mm]
template <int P, int D = 2>
SmoothPrismOf<P, D> make_smooth_prism(const SmoothPrism::Positions& Q, const FaceMap& map);
/// As above without shift and scaling, for the study of what they do.
template <int P, int D = 2>
SmoothPrismOf<P, D> make_plain_smooth_prism(const SmoothPrism::Positions& Q, const FaceMap& map);

/// Row a: integral of dN_a/dX over the element [mm^2], exact but for rounding; `Q * rows` is the
/// volume times the identity.
SmoothPrism::Gradients exact_gradient_integrals(const SmoothPrism::Positions& Q,
                                                const FaceMap& map);

/// Smallest det dX/d(r, s, q), over the quadrature points of `SmoothPrism` and the corners and
/// mid-edges of face and bottom, relative to the straight-sided prism's mean; <= 0: it folds.
double least_relative_jacobian(const SmoothPrism::Positions& Q, const FaceMap& map);

} // namespace f2b
