#include "Core/inverse/forward_search.hpp"

#include "Core/error.hpp"
#include "Core/inverse/skin_sensitivity.hpp"

#include <unsupported/Eigen/NonLinearOptimization>

#include <cassert>
#include <cmath>

namespace f2b
{
namespace
{

/// Weighted distances at corresponding vertices as a function of the coordinates in mm, angles by
/// their lever; in the form that Eigen's minimiser asks for.
class Distances
{
public:
  Distances(const FaceModel& face, const SkinTarget& target, const ForwardSearchOptions& options,
            const Progress& progress)
      : m_face(face), m_target(target), m_options(options), m_progress(progress),
        m_space(movement_space(face, {})),
        m_model(face.tissue, face.materials, held_controls(face.tissue, Held::BoneAndFragments)),
        m_solver(m_model, options.equilibrium), m_x(face.tissue.rest())
  {
    const std::vector<double> weight = fit_weights(face, target);
    for (std::size_t v = 0; v < weight.size(); ++v)
      if (weight[v] > 0)
      {
        m_vertex.push_back(v);
        m_root.push_back(std::sqrt(weight[v]));
      }
  }

  int inputs() const { return static_cast<int>(m_space.size()); }
  int values() const { return static_cast<int>(3 * m_vertex.size()); }

  int operator()(const Eigen::VectorXd& s, Eigen::VectorXd& distances)
  {
    constexpr double far_mm = 1000; // a movement that the tissue cannot follow is no good one
    if (!evaluate(s, m_x, distances))
      distances.setConstant(far_mm);
    return 0;
  }

  int df(const Eigen::VectorXd& s, Eigen::MatrixXd& slopes)
  {
    Eigen::VectorXd beyond(values()), before(values());
    for (Eigen::Index k = 0; k < s.size(); ++k)
    {
      const Eigen::VectorXd step = m_options.difference_mm * Eigen::VectorXd::Unit(s.size(), k);
      std::vector<Vec3> x = m_x; // every trial starts from the same equilibrium
      if (!evaluate(s + step, x, beyond))
        return -1;
      x = m_x;
      if (!evaluate(s - step, x, before))
        return -1;
      slopes.col(k) = (beyond - before) / (2 * m_options.difference_mm);
    }
    return 0;
  }

  /// Angles in radians.
  Eigen::VectorXd coordinates(Eigen::VectorXd s) const
  {
    for (Eigen::Index k = 0; k < s.size(); ++k)
      if (m_space.coordinates()[static_cast<std::size_t>(k)].is_angle())
        s[k] /= m_options.lever_mm;
    return s;
  }
  const MovementSpace& space() const { return m_space; }
  int predictions() const { return m_predictions; }

private:
  bool evaluate(const Eigen::VectorXd& s, std::vector<Vec3>& x, Eigen::VectorXd& distances)
  {
    m_progress("searching by forward solves", 1 - 1 / (1 + 0.02 * m_predictions));
    ++m_predictions;
    std::vector<Vec3> moved = x;
    const auto motions = m_space.motions(coordinates(s));
    if (!m_solver.move_to(moved, with_fragments_moved(m_face.tissue, motions)).converged())
      return false;
    x = std::move(moved);
    const std::vector<Vec3> u = m_face.skin.displacement(x);
    for (std::size_t i = 0; i < m_vertex.size(); ++i)
      distances.segment<3>(3 * static_cast<Eigen::Index>(i)) =
          m_root[i] * (u[m_vertex[i]] - m_target.displacement[m_vertex[i]]);
    return true;
  }

  const FaceModel& m_face;
  const SkinTarget& m_target;
  const ForwardSearchOptions& m_options;
  const Progress& m_progress;
  MovementSpace m_space;
  ElasticModel m_model;
  EquilibriumSolver m_solver;
  std::vector<Vec3> m_x; ///< where the last trial ended
  std::vector<std::size_t> m_vertex;
  std::vector<double> m_root; ///< of each vertex' weight [mm]
  int m_predictions = 0;
};

} // namespace

double weighted_rms_mm(const FaceModel& face, const SkinTarget& target,
                       const std::vector<Vec3>& skin_displacement)
{
  const std::vector<double> weight = fit_weights(face, target);
  double sum = 0, total = 0;
  for (std::size_t v = 0; v < weight.size(); ++v)
    if (weight[v] > 0)
    {
      sum += weight[v] * (skin_displacement[v] - target.displacement[v]).squaredNorm();
      total += weight[v];
    }
  return total > 0 ? std::sqrt(sum / total) : 0;
}

ForwardSearchResult search_by_predictions(const FaceModel& face, const SkinTarget& target,
                                          const ForwardSearchOptions& options,
                                          const Progress& progress)
{
  assert(!target.nearest);
  Distances distances(face, target, options, progress);
  Eigen::LevenbergMarquardt<Distances> search(distances);
  search.parameters.ftol = search.parameters.xtol = options.tolerance;
  search.useExternalScaling = true; // all coordinates are lengths
  search.diag = Eigen::VectorXd::Ones(distances.inputs());
  search.parameters.factor = 15; // length of the first step [mm]
  Eigen::VectorXd s = Eigen::VectorXd::Zero(distances.inputs());
  auto status = search.minimizeInit(s);
  while (status == Eigen::LevenbergMarquardtSpace::NotStarted ||
         (status == Eigen::LevenbergMarquardtSpace::Running &&
          distances.predictions() < options.max_predictions))
    status = search.minimizeOneStep(s);
  if (status == Eigen::LevenbergMarquardtSpace::UserAsked)
    throw Error("searching by forward solves", "the tissue cannot follow a movement that was tried",
                "bring the target nearer to the face", ErrorKind::Numerical);
  ForwardSearchResult result;
  result.converged = status != Eigen::LevenbergMarquardtSpace::Running;
  result.predictions = distances.predictions();
  result.q = distances.coordinates(s);
  result.motions = distances.space().motions(result.q);
  const Prediction face_there = predict_face(face, result.motions, options.equilibrium, progress);
  result.rms_mm = weighted_rms_mm(face, target, face_there.skin_displacement);
  return result;
}

} // namespace f2b
