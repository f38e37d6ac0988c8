#include "Core/material/law_fit.hpp"

#include "Core/error.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <optional>

namespace f2b
{
namespace
{

using Eigen::MatrixXd;
using Eigen::VectorXd;

int coefficient_count(FittedLaw law)
{
  return law == FittedLaw::OneTermNeoHookean ? 1 : law == FittedLaw::TwoTermMooneyRivlin ? 2 : 3;
}

/// A law of these coefficients; the volumetric part is left empty.
Law shape_law(FittedLaw law, const VectorXd& c)
{
  if (law == FittedLaw::OneTermNeoHookean)
    return NeoHookean{{c[0]}, {}};
  if (law == FittedLaw::TwoTermMooneyRivlin)
    return MooneyRivlin{{c[0], c[1]}, {}};
  return Yeoh{{c[0], c[1], c[2]}, {}};
}

/// Column k is the stress of coefficient k alone, at 1 MPa.
MatrixXd unit_stresses(const StressCurve& data, FittedLaw law)
{
  const int n = coefficient_count(law);
  MatrixXd columns(static_cast<Eigen::Index>(data.deformation.size()), n);
  for (int k = 0; k < n; ++k)
  {
    const Law unit = shape_law(law, VectorXd::Unit(n, k));
    for (Eigen::Index i = 0; i < columns.rows(); ++i)
      columns(i, k) =
          incompressible_response(unit, data.loading, data.deformation[static_cast<std::size_t>(i)])
              .stress;
  }
  return columns;
}

/// The least-squares coefficients with those outside the set at zero; nothing where the points do
/// not tell the others apart.
std::optional<VectorXd> solve(const MatrixXd& A, const VectorXd& b, unsigned set)
{
  std::vector<Eigen::Index> used;
  for (Eigen::Index k = 0; k < A.cols(); ++k)
    if (set >> k & 1)
      used.push_back(k);
  MatrixXd columns(A.rows(), static_cast<Eigen::Index>(used.size()));
  VectorXd scale(columns.cols());
  for (Eigen::Index k = 0; k < columns.cols(); ++k)
  {
    scale[k] = A.col(used[static_cast<std::size_t>(k)]).norm();
    if (!(scale[k] > 0))
      return std::nullopt;
    columns.col(k) = A.col(used[static_cast<std::size_t>(k)]) / scale[k];
  }
  Eigen::ColPivHouseholderQR<MatrixXd> qr(columns);
  qr.setThreshold(1e-9);
  if (qr.rank() < columns.cols())
    return std::nullopt;
  const VectorXd scaled = qr.solve(b);
  VectorXd c = VectorXd::Zero(A.cols());
  for (Eigen::Index k = 0; k < columns.cols(); ++k)
    c[used[static_cast<std::size_t>(k)]] = scaled[k] / scale[k];
  return c;
}

/// With at most three coefficients every set that may be non-zero is tried.
std::optional<VectorXd> solve_not_negative(const MatrixXd& A, const VectorXd& b)
{
  std::optional<VectorXd> best;
  for (unsigned set = 1; set < 1u << A.cols(); ++set)
  {
    const auto c = solve(A, b, set);
    if (c && c->minCoeff() >= 0 &&
        (!best || (A * *c - b).squaredNorm() < (A * *best - b).squaredNorm()))
      best = c;
  }
  return best;
}

/// The law with the bulk modulus that its stiffness and Poisson's ratio give.
Law with_volume(Law law, const FitOptions& options)
{
  const VolumetricLaw volumetric{options.volumetric,
                                 bulk_from(shear_modulus(law), options.poisson_ratio)};
  std::visit(
      [&](auto& one)
      {
        if constexpr (!std::is_same_v<std::decay_t<decltype(one)>, LinearElastic>)
          one.volumetric = volumetric;
      },
      law);
  return law;
}

} // namespace

double StressCurve::largest_stress() const
{
  double largest = 0;
  for (const double s : stress)
    largest = std::max(largest, std::abs(s));
  return largest;
}

LawFit fit_law(const StressCurve& data, const FitOptions& options)
{
  const MatrixXd A = unit_stresses(data, options.law);
  const VectorXd b =
      Eigen::Map<const VectorXd>(data.stress.data(), static_cast<Eigen::Index>(data.stress.size()));
  const unsigned every = (1u << A.cols()) - 1;
  // the points must tell all coefficients apart even where the best set leaves one out
  std::optional<VectorXd> c = solve(A, b, every);
  if (!c)
    throw Error(data.source,
                "its points cannot tell the law's " + std::to_string(A.cols()) +
                    " coefficients apart",
                "give points at more deformations, or fit a law with fewer coefficients");
  if (options.stable && c->minCoeff() < 0)
    c = solve_not_negative(A, b);
  if (!c || !(shear_modulus(shape_law(options.law, *c)) > 0))
    throw Error(data.source, "the best fit has no positive stiffness at rest",
                "check the signs and the order of the columns, or fit another law");
  LawFit fit;
  fit.law = with_volume(shape_law(options.law, *c), options);
  fit.rms_residual = std::sqrt((A * *c - b).squaredNorm() / static_cast<double>(b.size()));
  return fit;
}

StressCurve sampled_curve(const Law& law, Loading loading, double first, double last, int points)
{
  StressCurve curve;
  curve.loading = loading;
  for (int i = 0; i < points; ++i)
  {
    const double s = first + (last - first) * i / (points - 1);
    curve.deformation.push_back(s);
    curve.stress.push_back(incompressible_response(law, loading, s).stress);
  }
  return curve;
}

} // namespace f2b
