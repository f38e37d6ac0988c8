#include "Core/element/hermite_triangle.hpp"

namespace f2b
{
namespace
{

/// p = L_i^2 / (L_i + L_k) and its derivatives; both vanish where numerator and denominator do.
struct Blend
{
  double value, by_i, by_k;
};

Blend blend(double Li, double Lk)
{
  const double sum = Li + Lk;
  const double share = sum > 0 ? Li / sum : 0;
  return {Li * share, share * (2 - share), -share * share};
}

void add_edge_function(FaceFunctions& f, const Vec3& L, int k)
{
  const int i = (k + 1) % 3, j = (k + 2) % 3, row = 9 + k;
  const Blend p = blend(L[i], L[k]), q = blend(L[j], L[k]);
  f.value[row] = L[k] * p.value * q.value;
  f.slope(row, k) = p.value * q.value + L[k] * (p.by_k * q.value + p.value * q.by_k);
  f.slope(row, i) = L[k] * p.by_i * q.value;
  f.slope(row, j) = L[k] * p.value * q.by_i;
}

} // namespace

FaceFunctions face_functions(const Vec3& L)
{
  FaceFunctions f;
  const double B = L[0] * L[1] * L[2];
  const Eigen::RowVector3d dB(L[1] * L[2], L[2] * L[0], L[0] * L[1]);
  for (int i = 0; i < 3; ++i)
  {
    f.value[3 * i] = L[i] * L[i] * (3 - 2 * L[i]) + 2 * B;
    f.slope.row(3 * i) = 2 * dB;
    f.slope(3 * i, i) += 6 * L[i] * (1 - L[i]);
    for (int step = 1; step < 3; ++step)
    {
      const int j = (i + step) % 3;
      f.value[3 * i + step] = L[i] * L[i] * L[j] + 0.5 * B;
      f.slope.row(3 * i + step) = 0.5 * dB;
      f.slope(3 * i + step, i) += 2 * L[i] * L[j];
      f.slope(3 * i + step, j) += L[i] * L[i];
    }
  }
  for (int k = 0; k < 3; ++k)
    add_edge_function(f, L, k);
  return f;
}

EdgeCorrection edge_correction(const Mat3& corners)
{
  EdgeCorrection correction;
  for (int k = 0; k < 3; ++k)
  {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const Vec3 edge = corners.col(j) - corners.col(i);
    const double foot = edge.dot(corners.col(k) - corners.col(i)) / edge.squaredNorm();
    // grad L_k / |grad L_k|^2 runs from the foot of corner k's altitude to corner k
    Vec3 across;
    across[k] = 1;
    across[i] = foot - 1;
    across[j] = -foot;
    const Vec3 middle = 0.5 * (Vec3::Unit(i) + Vec3::Unit(j));
    correction.row(k) = -4 * (face_functions(middle).slope.topRows<9>() * across).transpose();
    for (const int end : {i, j})
      for (int step = 1; step < 3; ++step)
        correction(k, 3 * end + step) += 2 * across[(end + step) % 3];
  }
  return correction;
}

HermiteFunctions hermite_functions(const EdgeCorrection& correction, const Vec3& L)
{
  const FaceFunctions f = face_functions(L);
  return {f.value.head<9>() + correction.transpose() * f.value.tail<3>(),
          f.slope.topRows<9>() + correction.transpose() * f.slope.bottomRows<3>()};
}

} // namespace f2b
