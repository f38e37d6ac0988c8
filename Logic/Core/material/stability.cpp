#include "Core/material/stability.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace f2b
{
namespace
{

/// The smaller eigenvalue of diag(d) + w v v^T on the plane e_1 + e_2 + e_3 = 0.
double smallest_on_plane(const Vec3& d, double w, const Vec3& v)
{
  const Vec3 across = Vec3(1, -1, 0) / std::sqrt(2.0), along = Vec3(1, 1, -2) / std::sqrt(6.0);
  const double a = v.dot(across), b = v.dot(along);
  const double aa = d.dot(across.cwiseAbs2()) + w * a * a;
  const double bb = d.dot(along.cwiseAbs2()) + w * b * b;
  const double ab = d.dot(across.cwiseProduct(along)) + w * a * b;
  return 0.5 * (aa + bb) - std::hypot(0.5 * (aa - bb), ab);
}

double margin(const LinearElastic&, const Mat3&)
{
  return 1;
}

template <class Isochoric>
double margin(const Hyperelastic<Isochoric>& law, const Mat3& F)
{
  const double J = F.determinant();
  if (!(J > 0))
    return -std::numeric_limits<double>::infinity();
  Eigen::SelfAdjointEigenSolver<Mat3> C;
  C.compute(F.transpose() * F, Eigen::EigenvaluesOnly);
  const Vec3 a = C.eigenvalues() / std::cbrt(J * J), b = a.cwiseInverse();
  const double I1 = a.sum(), I2 = b.sum();
  const Isochoric& W = law.isochoric;
  // on the plane, lambda_i lambda_j d2/d lambda_i d lambda_j is 2 a_i + 2/3 I1 on the diagonal for
  // I1b and 6 b_i - 2/3 I2 for I2b; what couples the directions drops out
  const Vec3 d = W.slope1(I1) * (2 * a.array() + (2.0 / 3.0) * I1) +
                 W.slope2() * (6 * b.array() - (2.0 / 3.0) * I2);
  return smallest_on_plane(d, W.curvature1(I1), 2 * a) / (2 * W.shear_modulus());
}

Mat3 isochoric_deformation(Loading loading, double s)
{
  Mat3 F = Mat3::Identity();
  if (loading == Loading::SimpleShear)
    F(0, 1) = s;
  else if (loading == Loading::Uniaxial)
    F.diagonal() << s, 1 / std::sqrt(s), 1 / std::sqrt(s);
  else
    F.diagonal() << s, s, 1 / (s * s);
  return F;
}

} // namespace

double stability_margin(const Law& law, const Mat3& F)
{
  return std::visit([&](const auto& l) { return margin(l, F); }, law);
}

DeformationRange guarded_range(const Law& law, Loading loading)
{
  return range_around_rest(
      loading,
      [&](double s) { return stability_margin(law, isochoric_deformation(loading, s)) > 0; });
}

void StabilityReport::add(const MaterialPoint& point)
{
  TissueStability& tissue = m_tissues[index(point.tissue)];
  const double m = stability_margin(m_materials->of(point.tissue), point.F);
  ++tissue.points;
  tissue.volume += point.volume;
  if (!(m > 0))
  {
    ++tissue.points_outside;
    tissue.volume_outside += point.volume;
  }
  if (tissue.points == 1 || m < tissue.worst_margin)
  {
    tissue.worst_margin = m;
    tissue.worst_place = point.X;
  }
}

bool StabilityReport::all_inside() const
{
  return std::all_of(m_tissues.begin(), m_tissues.end(),
                     [](const TissueStability& t) { return t.points_outside == 0; });
}

std::vector<std::string> StabilityReport::warnings() const
{
  std::vector<std::string> sentences;
  for (const Tissue tissue : {Tissue::Skin, Tissue::Fat, Tissue::Muscle})
  {
    const TissueStability& t = of(tissue);
    if (t.points_outside == 0)
      continue;
    char text[300];
    std::snprintf(text, sizeof text,
                  "%s is stretched beyond the stable range of its law in %.3g %% of its volume "
                  "(%ld of %ld points), worst at R %.1f A %.1f S %.1f mm, where its resistance to "
                  "a change of shape is %.2f of that at rest",
                  name_of(tissue), 100 * t.share_outside(), t.points_outside, t.points,
                  t.worst_place.x(), t.worst_place.y(), t.worst_place.z(), t.worst_margin);
    sentences.push_back(text);
  }
  return sentences;
}

} // namespace f2b
