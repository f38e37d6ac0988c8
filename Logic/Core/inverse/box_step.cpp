#include "Core/inverse/box_step.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <vector>

namespace f2b
{
namespace
{

/// The minimum over the free components, the others as they are.
Eigen::VectorXd minimum_over_free(const Eigen::MatrixXd& H, const Eigen::VectorXd& g,
                                  const Eigen::VectorXd& s, const std::vector<char>& is_free)
{
  std::vector<Eigen::Index> free;
  Eigen::VectorXd held = s;
  for (Eigen::Index i = 0; i < s.size(); ++i)
    if (is_free[static_cast<std::size_t>(i)])
    {
      free.push_back(i);
      held[i] = 0;
    }
  const Eigen::VectorXd slope = (H * held + g)(free);
  Eigen::VectorXd result = s;
  result(free) = -H(free, free).ldlt().solve(slope);
  return result;
}

} // namespace

Eigen::VectorXd box_step(const Eigen::MatrixXd& H, const Eigen::VectorXd& g,
                         const Eigen::VectorXd& least, const Eigen::VectorXd& most)
{
  const Eigen::Index n = g.size();
  Eigen::VectorXd s = Eigen::VectorXd::Zero(n);
  std::vector<char> is_free(static_cast<std::size_t>(n), 1);
  // every round adds or frees one bound; rounding could make it go round in circles
  for (Eigen::Index round = 0; round < 20 * (n + 1); ++round)
  {
    const Eigen::VectorXd best = minimum_over_free(H, g, s, is_free);
    double share = 1;
    Eigen::Index blocking = -1;
    for (Eigen::Index i = 0; i < n; ++i)
    {
      const double way = best[i] - s[i];
      if (!is_free[static_cast<std::size_t>(i)] || way == 0)
        continue;
      const double room = ((way > 0 ? most[i] : least[i]) - s[i]) / way;
      if (room < share)
      {
        share = std::max(0.0, room);
        blocking = i;
      }
    }
    s += share * (best - s);
    if (blocking >= 0)
    {
      s[blocking] = best[blocking] > s[blocking] ? most[blocking] : least[blocking];
      is_free[static_cast<std::size_t>(blocking)] = 0;
      continue;
    }
    // free the bound that most keeps the quadratic from falling
    const Eigen::VectorXd slope = H * s + g;
    double most_gained = 0;
    Eigen::Index freed = -1;
    for (Eigen::Index i = 0; i < n; ++i)
    {
      if (is_free[static_cast<std::size_t>(i)] || least[i] == most[i])
        continue;
      const double inwards = s[i] >= most[i] ? slope[i] : -slope[i];
      const double gained = inwards > 0 ? inwards * inwards / H(i, i) : 0;
      if (gained > most_gained)
      {
        most_gained = gained;
        freed = i;
      }
    }
    if (freed < 0)
      break;
    is_free[static_cast<std::size_t>(freed)] = 1;
  }
  return s;
}

void hold_coordinate(Eigen::MatrixXd& H, Eigen::Index k)
{
  const double largest = H.diagonal().maxCoeff();
  H.row(k).setZero();
  H.col(k).setZero();
  H(k, k) = largest > 0 ? largest : 1;
}

} // namespace f2b
