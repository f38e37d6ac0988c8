#include "Core/material/positive_tangent.hpp"
#include "Core/solve/conjugate_gradients.hpp"
#include "Core/solve/symmetric_product.hpp"

#include <gtest/gtest.h>
#include <omp.h>

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

/// Springs between the neighbours of a cube of n^3 points, each held a little.
SymmetricMatrix springs_of_a_cube(long n)
{
  SymmetricMatrix matrix;
  matrix.size = 3 * n * n * n;
  matrix.column_start.push_back(0);
  std::mt19937 generator(10);
  std::uniform_real_distribution<double> stiffness(0.5, 2);
  for (long u = 0; u < n * n * n; ++u)
  {
    std::vector<long> neighbours = {u};
    if (u % n + 1 < n)
      neighbours.push_back(u + 1);
    if (u / n % n + 1 < n)
      neighbours.push_back(u + n);
    if (u / (n * n) + 1 < n)
      neighbours.push_back(u + n * n);
    for (int c = 0; c < 3; ++c)
    {
      for (const long v : neighbours)
        for (int r = v == u ? c : 0; r < 3; ++r)
        {
          matrix.row.push_back(3 * v + r);
          matrix.value.push_back(v != u   ? (r == c ? -stiffness(generator) : 0.1)
                                 : r == c ? 13
                                          : 0.2);
        }
      matrix.column_start.push_back(long(matrix.row.size()));
    }
  }
  return matrix;
}

TEST(Cholesky, SolvesAndPreconditionsInAnyOrderOfBlocks)
{
  const SymmetricMatrix matrix = springs_of_a_cube(14);
  SymmetricProduct product;
  product.analyze(matrix);
  const Eigen::MatrixXd x = random_matrix(matrix.size, 3, 11);
  const Eigen::MatrixXd b = product(matrix, x);
  for (const int block : {1, 3})
  {
    Cholesky cholesky;
    cholesky.analyze(matrix, block);
    for (const double scale : {1.0, 1e-3}) // new numbers in the old structure
    {
      SymmetricMatrix scaled = matrix;
      for (double& value : scaled.value)
        value *= scale;
      ASSERT_TRUE(cholesky.factorize(scaled));
      EXPECT_LT((cholesky.solve(b) - x / scale).norm(), 1e-12 * x.norm() / scale);
      const Eigen::MatrixXd near = cholesky.precondition(b);
      EXPECT_LT((near - x / scale).norm(), 1e-5 * x.norm() / scale);
      EXPECT_LT((cholesky.precondition(b.col(1)) - near.col(1)).norm(), 1e-5 * near.norm());
    }
  }
}

TEST(Cholesky, SaysThatAMatrixIsNotPositiveDefiniteAndTakesTheNext)
{
  const SymmetricMatrix matrix = springs_of_a_cube(6);
  SymmetricMatrix bent = matrix;
  bent.value[std::size_t(matrix.column_start[300])] = -1;
  Cholesky cholesky;
  cholesky.analyze(matrix, 3);
  EXPECT_FALSE(cholesky.factorize(bent));
  ASSERT_TRUE(cholesky.factorize(matrix));
  SymmetricProduct product;
  product.analyze(matrix);
  const Eigen::MatrixXd x = random_matrix(matrix.size, 1, 12);
  EXPECT_LT((cholesky.solve(product(matrix, x)) - x).norm(), 1e-12 * x.norm());
}

TEST(Cholesky, PreconditionsTheSameWithAnyNumberOfThreads)
{
  const SymmetricMatrix matrix = springs_of_a_cube(14);
  Cholesky cholesky;
  cholesky.analyze(matrix, 3);
  ASSERT_TRUE(cholesky.factorize(matrix));
  const Eigen::MatrixXd b = random_matrix(matrix.size, 2, 13);
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const Eigen::MatrixXd one = cholesky.precondition(b);
  for (const int count : {2, 3})
  {
    omp_set_num_threads(count);
    EXPECT_EQ(cholesky.precondition(b), one);
  }
  omp_set_num_threads(threads);
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
