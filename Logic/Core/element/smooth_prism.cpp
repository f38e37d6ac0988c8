#include "Core/element/smooth_prism.hpp"

#include "Core/element/triangle_rule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace f2b
{
namespace
{

using Gradients = SmoothPrism::Gradients;
using Positions = SmoothPrism::Positions;
constexpr int basis = FaceFunctions::count;

/// Face functions at one area coordinate, with derivatives by (r, s) where L = (r, s, 1 - r - s).
struct FacePoint
{
  Vec3 L;
  Eigen::Matrix<double, basis, 1> value;
  Eigen::Matrix<double, basis, 2> by_rs;
  double weight;
};

FacePoint face_point(const TrianglePoint& at)
{
  const FaceFunctions f = face_functions(at.L);
  FacePoint point{at.L, f.value, f.slope.leftCols<2>(), at.weight};
  point.by_rs.colwise() -= f.slope.col(2);
  return point;
}

std::vector<FacePoint> face_points(const std::vector<TrianglePoint>& rule)
{
  std::vector<FacePoint> points;
  std::transform(rule.begin(), rule.end(), std::back_inserter(points), face_point);
  return points;
}

/// The same control vectors about the first corner: rounding then goes with the element's size, not
/// with its place. Slopes do not change.
Positions about_first_corner(const Positions& Q)
{
  Positions local = Q;
  local.leftCols<3>().colwise() -= Q.col(0);
  local.rightCols<3>().colwise() -= Q.col(0);
  return local;
}

/// Derivatives of the 12 functions by (r, s, q).
Gradients parametric_gradients(const FacePoint& point, const FaceMap& map, double q)
{
  Gradients g;
  // lazy: products of these sizes are faster written out than handed to a matrix kernel
  g.topLeftCorner<9, 2>() = (1 - q) * map.lazyProduct(point.by_rs);
  g.topRightCorner<9, 1>() = -map.lazyProduct(point.value);
  g.bottomRows<3>() << q, 0, point.L[0], //
      0, q, point.L[1],                  //
      -q, -q, point.L[2];
  return g;
}

/// Integrals over the face of phi_a (phi_b,r phi_c,s - phi_b,s phi_c,r), one column per b < c: with
/// them the area vectors of any smooth face are exact, because its shape enters linearly.
using FaceMoments = Eigen::Matrix<double, basis, basis*(basis - 1) / 2>;

FaceMoments compute_face_moments()
{
  FaceMoments moments = FaceMoments::Zero();
  for (const FacePoint& point : face_points(corner_graded_rule(12)))
  {
    int pair = 0;
    for (int b = 0; b < basis; ++b)
      for (int c = b + 1; c < basis; ++c, ++pair)
      {
        const double area = point.by_rs(b, 0) * point.by_rs(c, 1) - //
                            point.by_rs(b, 1) * point.by_rs(c, 0);
        moments.col(pair) += 0.5 * point.weight * area * point.value;
      }
  }
  return moments;
}

/// Integral of N n dA over the face, one row per control vector of the face [mm^2].
Eigen::Matrix<double, 9, 3> face_area_vectors(const Positions& Q, const FaceMap& map)
{
  static const FaceMoments moments = compute_face_moments();
  const Eigen::Matrix<double, 3, basis> P = Q.leftCols<9>().lazyProduct(map);
  Eigen::Matrix<double, FaceMoments::ColsAtCompileTime, 3> areas;
  int pair = 0;
  for (int b = 0; b < basis; ++b)
    for (int c = b + 1; c < basis; ++c)
      areas.row(pair++) = P.col(b).cross(P.col(c));
  const Eigen::Matrix<double, basis, 3> of_basis = moments.lazyProduct(areas);
  return map.lazyProduct(of_basis);
}

/// Points along the edge opposite each corner, in the sense of the face's outline.
std::array<std::vector<FacePoint>, 3> edge_points()
{
  std::array<std::vector<FacePoint>, 3> points;
  for (int k = 0; k < 3; ++k)
    for (const LinePoint& at : gauss_rule(5))
    {
      const Vec3 L = (1 - at.at) * Vec3::Unit((k + 1) % 3) + at.at * Vec3::Unit((k + 2) % 3);
      points[static_cast<std::size_t>(k)].push_back(face_point({L, at.weight}));
    }
  return points;
}

/// Adds the integral of N n dA over the three sides: degree 8 along the edge and 2 across it, so
/// that 5 x 2 Gauss points are exact and both prisms of a side find the same.
void add_side_area_vectors(const Positions& Q, const FaceMap& map, Gradients& sums)
{
  static const auto points = edge_points();
  static const auto depths = gauss_rule(2);
  for (int k = 0; k < 3; ++k)
    for (const FacePoint& point : points[static_cast<std::size_t>(k)])
      for (const LinePoint& depth : depths)
      {
        const Gradients g = parametric_gradients(point, map, depth.at);
        Eigen::Matrix<double, 12, 1> N;
        N << (1 - depth.at) * map.lazyProduct(point.value), depth.at * point.L;
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        // from corner i to j the area coordinates change by e_j - e_i
        const Vec3 dL = Vec3::Unit(j) - Vec3::Unit(i);
        const Vec3 along = Q * (g.leftCols<2>() * dL.head<2>());
        const Vec3 down = Q * g.col(2);
        sums += point.weight * depth.weight * N * down.cross(along).transpose();
      }
}

template <int P>
std::array<FacePoint, P> quadrature_face_points()
{
  std::array<FacePoint, P> points;
  const auto computed = face_points(triangle_rule(P));
  std::copy(computed.begin(), computed.end(), points.begin());
  return points;
}

} // namespace

FaceMap face_map(const Mat3& corners, const FaceSlopes& slopes)
{
  Eigen::Matrix<double, 9, 9> degrees = Eigen::Matrix<double, 9, 9>::Zero();
  for (int i = 0; i < 3; ++i)
  {
    degrees(i, 3 * i) = 1;
    for (int step = 1; step < 3; ++step)
    {
      const EdgeSlope& slope = slopes[static_cast<std::size_t>(2 * i + step - 1)];
      auto column = degrees.col(3 * i + step);
      if (slope.straight)
      {
        column[(i + step) % 3] = 1;
        column[i] = -1;
      }
      else
      {
        column[3 + 2 * i] = slope.a;
        column[4 + 2 * i] = slope.b;
      }
    }
  }
  FaceMap map;
  map << degrees, degrees * edge_correction(corners).transpose();
  return map;
}

Gradients exact_gradient_integrals(const Positions& at, const FaceMap& map)
{
  const Positions Q = about_first_corner(at);
  Gradients sums = Gradients::Zero();
  sums.topRows<9>() = face_area_vectors(Q, map);
  const Vec3 bottom = (Q.col(11) - Q.col(9)).cross(Q.col(10) - Q.col(9)) / 6;
  sums.bottomRows<3>().rowwise() = bottom.transpose();
  add_side_area_vectors(Q, map, sums);
  return sums;
}

template <int P, int D>
SmoothPrismOf<P, D> make_plain_smooth_prism(const Positions& at, const FaceMap& map)
{
  const Positions Q = about_first_corner(at);
  static const auto points = quadrature_face_points<P>();
  static const auto depths = gauss_rule(D);
  SmoothPrismOf<P, D> element;
  std::size_t number = 0;
  for (const LinePoint& depth : depths)
    for (const FacePoint& point : points)
    {
      const Gradients local = parametric_gradients(point, map, depth.at);
      const Mat3 jacobian = Q.lazyProduct(local);
      element.gradients[number] = local * jacobian.inverse();
      // q points inwards: take the orientation out, as in `make_prism6`
      element.volumes[number] = -0.5 * point.weight * depth.weight * jacobian.determinant();
      ++number;
    }
  return element;
}

template <int P, int D>
SmoothPrismOf<P, D> make_smooth_prism(const Positions& Q, const FaceMap& map)
{
  SmoothPrismOf<P, D> element = make_plain_smooth_prism<P, D>(Q, map);
  const Gradients exact = exact_gradient_integrals(Q, map);
  const double volume = about_first_corner(Q).lazyProduct(exact).trace() / 3;
  double sum = 0;
  Gradients found = Gradients::Zero();
  for (std::size_t q = 0; q < element.volumes.size(); ++q)
  {
    sum += element.volumes[q];
    found += element.volumes[q] * element.gradients[q];
  }
  const Gradients shift = exact / volume - found / sum;
  for (Gradients& gradients : element.gradients)
    gradients += shift;
  for (double& part : element.volumes)
    part *= volume / sum;
  return element;
}

double least_relative_jacobian(const Positions& at, const FaceMap& map)
{
  const Positions Q = about_first_corner(at);
  static const auto points = []
  {
    std::vector<TrianglePoint> rule = triangle_rule(SmoothPrism().gradients.size() / 2);
    for (int k = 0; k < 3; ++k)
    {
      rule.push_back({Vec3::Unit(k), 0});
      rule.push_back({0.5 * (Vec3::Ones() - Vec3::Unit(k)), 0});
    }
    return face_points(rule);
  }();
  static const auto depths = gauss_rule(2);
  const Vec3 height = (Q.leftCols<3>() - Q.rightCols<3>()).rowwise().mean();
  const Vec3 area = (Q.col(1) + Q.col(10) - Q.col(0) - Q.col(9))
                        .cross(Q.col(2) + Q.col(11) - Q.col(0) - Q.col(9));
  const double mean = 0.25 * area.dot(height);
  double least = std::numeric_limits<double>::infinity();
  for (const FacePoint& point : points)
  {
    const bool inside = point.weight > 0;
    for (const double q : {inside ? depths[0].at : 0.0, inside ? depths[1].at : 1.0})
      least = std::min(least, -(Q * parametric_gradients(point, map, q)).determinant());
  }
  return least / std::abs(mean);
}

template SmoothPrismOf<3, 2> make_smooth_prism<3, 2>(const Positions&, const FaceMap&);
template SmoothPrismOf<3, 2> make_plain_smooth_prism<3, 2>(const Positions&, const FaceMap&);
template SmoothPrismOf<6, 2> make_smooth_prism<6, 2>(const Positions&, const FaceMap&);
template SmoothPrismOf<6, 2> make_plain_smooth_prism<6, 2>(const Positions&, const FaceMap&);
template SmoothPrismOf<7, 2> make_smooth_prism<7, 2>(const Positions&, const FaceMap&);
template SmoothPrismOf<7, 2> make_plain_smooth_prism<7, 2>(const Positions&, const FaceMap&);
template SmoothPrismOf<12, 2> make_smooth_prism<12, 2>(const Positions&, const FaceMap&);
template SmoothPrismOf<12, 2> make_plain_smooth_prism<12, 2>(const Positions&, const FaceMap&);
template SmoothPrismOf<96, 4> make_smooth_prism<96, 4>(const Positions&, const FaceMap&);
template SmoothPrismOf<96, 4> make_plain_smooth_prism<96, 4>(const Positions&, const FaceMap&);

} // namespace f2b
