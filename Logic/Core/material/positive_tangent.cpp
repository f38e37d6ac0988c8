#include "Core/material/positive_tangent.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace f2b
{

using Mat9 = Eigen::Matrix<double, 9, 9>;

void make_positive(Mat9& tangent)
{
  // Most points are positive, and a factorisation tells so ten times sooner than eigenvalues do.
  // Rotations have no stiffness where there is no stress: what counts as negative is below their
  // rounding.
  Mat9 shifted = tangent;
  shifted.diagonal().array() += 1e-10 * tangent.diagonal().cwiseAbs().maxCoeff();
  if (Eigen::LLT<Mat9>(shifted).info() == Eigen::Success)
    return;
  const Eigen::SelfAdjointEigenSolver<Mat9> spectrum(tangent);
  const auto& modes = spectrum.eigenvectors();
  tangent = modes * spectrum.eigenvalues().cwiseMax(0).asDiagonal() * modes.transpose();
}

} // namespace f2b
