#include "Core/material/positive_tangent.hpp"
#include "Core/solve/conjugate_gradients.hpp"
#include "Core/solve/symmetric_product.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <random>

namespace f2b
{
namespace
{

Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, unsigned seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> entry(-1, 1);
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return entry(generator); });
}

Eigen::MatrixXd random_definite(Eigen::Index n, unsigned seed)
{
  const Eigen::MatrixXd A = random_matrix(n, n, seed);
  return A * A.transpose() + Eigen::MatrixXd::Identity(n, n);
}

LinearMap times(const Eigen::MatrixXd& A)
{
  return [&A](const Eigen::MatrixXd& x) { return Eigen::MatrixXd(A * x); };
}

TEST(ConjugateGradients, SolveSeveralSystemsToTheTolerance)
{
  const Eigen::MatrixXd A = random_definite(40, 1);
  const Eigen::MatrixXd M = (A + 0.3 * random_definite(40, 2)).inverse();
  Eigen::MatrixXd b = random_matrix(40, 3, 3);
  b.col(1).setZero();
  const CgResult result = conjugate_gradients(times(A), times(M), b, {1e-12, 60});
  EXPECT_EQ(result.termination, CgTermination::Converged);
  EXPECT_LT((A * result.x - b).norm(), 1e-10 * b.norm());
  EXPECT_EQ(result.x.col(1).norm(), 0);
}

TEST(ConjugateGradients, TheRightFactorNeedsOneIteration)
{
  const Eigen::MatrixXd A = random_definite(30, 4);
  const Eigen::MatrixXd M = A.inverse(), b = random_matrix(30, 1, 5);
  EXPECT_EQ(conjugate_gradients(times(A), times(M), b, {1e-8, 10}).iterations, 1);
}

TEST(ConjugateGradients, FindNegativeCurvatureAndGiveUpWhenSlow)
{
  Eigen::MatrixXd A = random_definite(30, 6);
  const Eigen::MatrixXd M = Eigen::MatrixXd::Identity(30, 30), b = random_matrix(30, 1, 7);
  const CgResult slow = conjugate_gradients(times(A), times(M), b, {1e-12, 5});
  EXPECT_EQ(slow.termination, CgTermination::IterationLimit);
  EXPECT_LE(slow.iterations, 5);
  A -= 3 * Eigen::MatrixXd::Identity(30, 30);
  const CgResult bent = conjugate_gradients(times(A), times(M), b, {1e-12, 100});
  EXPECT_EQ(bent.termination, CgTermination::NegativeCurvature);
}

TEST(SymmetricProduct, IsThatOfTheFullMatrix)
{
  const Eigen::Index n = 24;
  Eigen::MatrixXd A = random_definite(n, 8);
  SymmetricMatrix sparse;
  sparse.size = n;
  sparse.column_start.push_back(0);
  for (Eigen::Index c = 0; c < n; ++c)
  {
    for (Eigen::Index r = c; r < n; ++r)
    {
      if (r / 3 != c / 3 && (r / 3 + 2 * (c / 3)) % 3)
      {
        A(r, c) = A(c, r) = 0;
        continue;
      }
      sparse.row.push_back(r);
      sparse.value.push_back(A(r, c));
    }
    sparse.column_start.push_back(long(sparse.row.size()));
  }
  SymmetricProduct product;
  product.analyze(sparse);
  const Eigen::MatrixXd x = random_matrix(n, 4, 9);
  EXPECT_LT((product(sparse, x) - A * x).norm(), 1e-13 * (A * x).norm());
}

TEST(PositiveTangent, LosesItsNegativeEigenvaluesOnly)
{
  using Mat9 = Eigen::Matrix<double, 9, 9>;
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    const Mat9 A = random_matrix(9, 9, seed);
    const Mat9 symmetric = A + A.transpose();
    Mat9 positive = symmetric;
    make_positive(positive);
    const Eigen::SelfAdjointEigenSolver<Mat9> before(symmetric), after(positive);
    EXPECT_LT((after.eigenvalues() - before.eigenvalues().cwiseMax(0)).norm(), 1e-13);
    EXPECT_LT((positive * symmetric - symmetric * positive).norm(), 1e-12);
    Mat9 definite = A * A.transpose();
    const Mat9 kept = definite;
    make_positive(definite);
    EXPECT_EQ(definite, kept);
  }
}

} // namespace
} // namespace f2b
