#include "Core/element/positive_blocks.hpp"

#include "Core/element/quadrature_element.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace f2b
{

void make_positive(double* stiffness, int n)
{
  auto block = [&](int a, int b) { return Eigen::Map<Mat3>(stiffness + 9 * block_index(n, a, b)); };
  Eigen::MatrixXd K(3 * n, 3 * n);
  for (int b = 0; b < n; ++b)
    for (int a = b; a < n; ++a)
      K.block<3, 3>(3 * a, 3 * b) = block(a, b);
  // rigid motions have no stiffness: what counts as negative is below their rounding
  Eigen::MatrixXd shifted = K;
  shifted.diagonal().array() += 1e-10 * K.diagonal().cwiseAbs().maxCoeff();
  if (Eigen::LLT<Eigen::MatrixXd>(shifted).info() == Eigen::Success)
    return;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(K);
  const Eigen::MatrixXd positive = modes.eigenvectors() *
                                   modes.eigenvalues().cwiseMax(0.0).asDiagonal() *
                                   modes.eigenvectors().transpose();
  for (int b = 0; b < n; ++b)
    for (int a = b; a < n; ++a)
      block(a, b) = positive.block<3, 3>(3 * a, 3 * b);
}

} // namespace f2b
