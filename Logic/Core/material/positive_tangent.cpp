#include "Core/material/positive_tangent.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace f2b
{

using Mat9 = Eigen::Matrix<double, 9, 9>;

void make_positive(Mat9& tangent)
{
  // most points are positive, and a factorisation tells so ten times sooner than eigenvalues do
  if (Eigen::LLT<Mat9>(tangent).info() == Eigen::Success)
    return;
  const Eigen::SelfAdjointEigenSolver<Mat9> spectrum(tangent);
  const double rounding = 1e-12 * spectrum.eigenvalues().cwiseAbs().maxCoeff();
  if (spectrum.eigenvalues().minCoeff() >= -rounding)
    return;
  const auto& modes = spectrum.eigenvectors();
  tangent = modes * spectrum.eigenvalues().cwiseMax(0).asDiagonal() * modes.transpose();
}

} // namespace f2b
