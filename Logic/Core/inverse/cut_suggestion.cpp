#include "Core/inverse/cut_suggestion.hpp"

#include "Core/error.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>

namespace f2b
{
namespace
{

constexpr double degree = 3.14159265358979323846 / 180;
constexpr double least_target_mm = 0.01;

std::vector<double> vertex_weights(const SkinTarget& target, const std::vector<double>& skin_area)
{
  std::vector<double> weight(skin_area.size());
  for (std::size_t v = 0; v < weight.size(); ++v)
    weight[v] = skin_area[v] * target.weight[v];
  return weight;
}

/// Weighted sums of squares, and what they are over.
struct Sums
{
  double squares = 0, weight = 0, under_1mm = 0;
  double rms() const { return weight > 0 ? std::sqrt(squares / weight) : 0; }
};

Sums sums_of(const std::vector<Vec3>& difference, const std::vector<double>& weight)
{
  Sums sums;
  for (std::size_t v = 0; v < weight.size(); ++v)
  {
    sums.squares += weight[v] * difference[v].squaredNorm();
    sums.weight += weight[v];
    sums.under_1mm += difference[v].norm() < 1 ? weight[v] : 0;
  }
  return sums;
}

struct NormalEquations
{
  Eigen::MatrixXd H;
  Eigen::VectorXd g;
};

NormalEquations normal_equations(const std::vector<std::vector<Vec3>>& columns,
                                 const std::vector<Vec3>& target, const std::vector<double>& weight)
{
  const auto n = static_cast<Eigen::Index>(columns.size());
  NormalEquations equations{Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd::Zero(n)};
  Eigen::Matrix3Xd rows(3, n);
  for (std::size_t v = 0; v < weight.size(); ++v)
  {
    if (weight[v] <= 0)
      continue;
    for (Eigen::Index j = 0; j < n; ++j)
      rows.col(j) = columns[static_cast<std::size_t>(j)][v];
    equations.H.noalias() += weight[v] * rows.transpose() * rows;
    equations.g.noalias() += weight[v] * rows.transpose() * target[v];
  }
  return equations;
}

/// Per unknown: the largest value that is proposed, and the value that costs `cost_of_movement`.
struct Scales
{
  Eigen::VectorXd limit, costly;
};

Scales scales_of(std::size_t unknowns, const CutSuggestionOptions& options)
{
  const auto n = static_cast<Eigen::Index>(unknowns);
  Scales scales{Eigen::VectorXd(n), Eigen::VectorXd(n)};
  for (Eigen::Index i = 0; i < n; ++i)
  {
    const bool turn = i % 6 < 3;
    scales.limit[i] = turn ? options.largest_turn_rad : options.largest_shift_mm;
    scales.costly[i] = turn ? 10 * degree : 10;
  }
  return scales;
}

/// Pulls every three unknowns that left the unit ball back to it.
void project(Eigen::VectorXd& q)
{
  for (Eigen::Index i = 0; i < q.size(); i += 3)
  {
    auto block = q.segment<3>(i);
    if (const double length = block.norm(); length > 1)
      block /= length;
  }
}

} // namespace

Eigen::VectorXd minimum_in_unit_balls(const Eigen::MatrixXd& H, const Eigen::VectorXd& g)
{
  assert(H.rows() == g.size() && g.size() % 3 == 0);
  Eigen::VectorXd q = H.ldlt().solve(g);
  const Eigen::VectorXd free = q;
  project(q);
  if (q == free)
    return q;
  // Projected gradients with Nesterov's momentum, dropped where it would lead uphill (O'Donoghue
  // and Candes 2015): a dozen unknowns, so a step costs next to nothing.
  const double step =
      1 / Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(H).eigenvalues().maxCoeff();
  constexpr int most_steps = 200000;
  Eigen::VectorXd ahead = q;
  double momentum = 1;
  for (int i = 0; i < most_steps; ++i)
  {
    Eigen::VectorXd next = ahead - step * (H * ahead - g);
    project(next);
    const Eigen::VectorXd change = next - q;
    const bool uphill = (ahead - next).dot(change) > 0;
    const double grown = uphill ? 1 : 0.5 * (1 + std::sqrt(1 + 4 * momentum * momentum));
    ahead = uphill ? next : Eigen::VectorXd(next + (momentum - 1) / grown * change);
    momentum = grown;
    q = next;
    if (change.norm() < 1e-13)
      break;
  }
  return q;
}

double target_rms_mm(const SkinTarget& target, const std::vector<double>& skin_area)
{
  return sums_of(target.displacement, vertex_weights(target, skin_area)).rms();
}

Attainment attained(const std::vector<Vec3>& skin_displacement, const SkinTarget& target,
                    const std::vector<double>& skin_area)
{
  const std::vector<double> weight = vertex_weights(target, skin_area);
  const Sums asked = sums_of(target.displacement, weight);
  if (!(asked.rms() >= least_target_mm))
    throw Error("target", "it asks for no change of the meshed face: less than 0.01 mm (RMS)",
                "move the face where it should change, or widen the target's mask "
                "(target.mask_mm) or the region of interest");
  std::vector<Vec3> left = target.displacement;
  for (std::size_t v = 0; v < left.size(); ++v)
    left[v] -= skin_displacement[v];
  const Sums sums = sums_of(left, weight);
  return {1 - sums.rms() / asked.rms(), sums.rms(), sums.under_1mm / sums.weight};
}

namespace
{

std::vector<Vec3> combined(const std::vector<std::vector<Vec3>>& columns, const Eigen::VectorXd& q)
{
  std::vector<Vec3> sum(columns.front().size(), Vec3::Zero());
  for (std::size_t j = 0; j < columns.size(); ++j)
    for (std::size_t v = 0; v < sum.size(); ++v)
      sum[v] += q[static_cast<Eigen::Index>(j)] * columns[j][v];
  return sum;
}

} // namespace

CutReach reach_of(const CutEffect& effect, const SkinTarget& target,
                  const std::vector<double>& skin_area, const CutSuggestionOptions& options)
{
  assert(!effect.columns.empty() && effect.columns.size() == 6 * effect.fragments.size());
  const std::vector<double> weight = vertex_weights(target, skin_area);
  const Sums asked = sums_of(target.displacement, weight);
  NormalEquations equations = normal_equations(effect.columns, target.displacement, weight);
  const Scales scales = scales_of(effect.columns.size(), options);
  equations.H.diagonal() +=
      options.cost_of_movement * asked.squares * scales.costly.cwiseAbs2().cwiseInverse();
  const auto scale = scales.limit.asDiagonal();
  const Eigen::VectorXd unit =
      minimum_in_unit_balls(scale * equations.H * scale, scale * equations.g);
  const Eigen::VectorXd q = scale * unit;

  CutReach reach;
  reach.cuts = effect.cuts;
  reach.fragments = effect.fragments;
  reach.bone_volume_mm3 = effect.bone_volume_mm3;
  for (std::size_t f = 0; f < effect.fragments.size(); ++f)
  {
    const auto i = static_cast<Eigen::Index>(6 * f);
    RigidMotion rest;
    rest.reference_point = effect.reference_points[f];
    reach.motions.push_back(rest.followed_by(q.segment<3>(i), q.segment<3>(i + 3)));
    reach.at_limit.push_back(std::max(unit.segment<3>(i).norm(), unit.segment<3>(i + 3).norm()) >
                             1 - 1e-9);
  }
  reach.face = attained(combined(effect.columns, q), target, skin_area);
  reach.score =
      reach.face.reached - options.cost_of_cut * (static_cast<double>(effect.cuts.size()) - 1);
  return reach;
}

void rank(std::vector<CutReach>& reaches)
{
  auto key = [](const CutReach& r) {
    return std::make_tuple(-std::lround(100 * r.score), r.cuts.size(), r.bone_volume_mm3, r.cuts);
  };
  std::sort(reaches.begin(), reaches.end(),
            [&](const CutReach& a, const CutReach& b) { return key(a) < key(b); });
}

} // namespace f2b
