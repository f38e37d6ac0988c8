#include "Core/inverse/virtual_force.hpp"

#include "Core/error.hpp"
#include "Core/inverse/stiffness_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace f2b
{
namespace
{

constexpr const char* what = "pulling the skin by virtual forces";

/// Where the search for K_e begins [N/mm^3]. A dead load of the same K_e does not die away as the
/// skin follows, and goes ten times as far.
constexpr double first_following = 0.02, first_dead = 0.002;

/// Equilibria on the way to K_e are good enough to this share of the residual that it is for.
constexpr double search_tolerance = 1e-3;

std::string number(double value)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

void require_in_range(const VirtualForceOptions& options)
{
  auto require = [](bool valid, const char* key, double value, const char* remedy)
  {
    if (!valid)
      throw Error(std::string("virtual-force: ") + key, "it is " + number(value), remedy);
  };
  if (options.stiffness_n_per_mm3)
    require(*options.stiffness_n_per_mm3 > 0 && std::isfinite(*options.stiffness_n_per_mm3),
            "stiffness", *options.stiffness_n_per_mm3, "give N/mm^3 above zero, or none");
  require(options.residual_mm > 0 && std::isfinite(options.residual_mm), "residual",
          options.residual_mm, "give mm above zero");
  require(options.rest_length_mm >= 0 && std::isfinite(options.rest_length_mm), "rest length",
          options.rest_length_mm, "give zero or more mm");
  require(options.stiffness_n_per_mm3 || options.load == VirtualLoad::Dead ||
              options.residual_mm > options.rest_length_mm,
          "residual", options.residual_mm,
          "give more than the rest length, at which the springs hold the skin off its target");
}

/// One run of the method: the loaded skin, and the equilibria found so far.
class Drag
{
public:
  Drag(const FaceModel& face, const SkinTarget& target, const VirtualForceOptions& options,
       const Progress& progress);

  VirtualForceResult run();

private:
  struct State
  {
    double stiffness = 0;
    std::vector<Vec3> x; ///< an equilibrium with the whole target
  };

  double residual(const std::vector<Vec3>& skin_displacement) const;
  bool relax(std::vector<Vec3>& x, double stiffness, double share);
  double walk_to_target(std::vector<Vec3>& x, double stiffness, double shortest_share);
  void pull_with_given();
  void choose_stiffness();
  bool try_stiffness(double stiffness);
  const State& nearest(double stiffness) const;

  const FaceModel& m_face;
  const SkinTarget& m_target;
  const VirtualForceOptions& m_options;
  const Progress& m_progress;
  ContactSurfaces m_contacts;
  std::vector<double> m_area; ///< loaded area per reference-skin vertex [mm^2]
  ElasticModel m_model;
  EquilibriumSolver m_solver;
  std::vector<State> m_states; ///< the first at rest
  VirtualForceResult m_result;
};

Drag::Drag(const FaceModel& face, const SkinTarget& target, const VirtualForceOptions& options,
           const Progress& progress)
    : m_face(face), m_target(target), m_options(options), m_progress(progress),
      m_contacts(face.tissue.mesh(), face.reference_points, options.landmarks),
      m_area(face.skin_area.size(), 0.0),
      m_model(face.tissue, face.materials, held_controls(face.tissue, Held::BoneOnly)),
      m_solver(m_model, options.equilibrium)
{
  double total = 0;
  for (std::size_t v = 0; v < m_area.size(); ++v)
    if (face.skin.vertices[v].prism >= 0)
      total += m_area[v] = face.skin_area[v] * target.weight[v];
  if (!(total > 0))
    throw Error("target", "no weighted part of it lies on the meshed face",
                "widen the target's mask or the region of interest");
  m_states.push_back({0, face.tissue.rest()});
  m_result.residual_at_rest_mm =
      residual(std::vector<Vec3>(target.displacement.size(), Vec3::Zero()));
}

double Drag::residual(const std::vector<Vec3>& skin_displacement) const
{
  double sum = 0, total = 0;
  for (std::size_t v = 0; v < m_area.size(); ++v)
    if (m_area[v] > 0)
    {
      sum += m_area[v] * (m_target.displacement[v] - skin_displacement[v]).norm();
      total += m_area[v];
    }
  return sum / total;
}

/// From x to equilibrium with springs that pull towards a share of the target; x stays if there is
/// none. The rest length shrinks with the way, so that the pull at rest grows with the share.
bool Drag::relax(std::vector<Vec3>& x, double stiffness, double share)
{
  std::vector<Vec3> displacement = m_target.displacement;
  for (Vec3& d : displacement)
    d *= share;
  m_model.set_springs(make_skin_springs(m_face.skin, displacement, m_area),
                      {stiffness, share * m_options.rest_length_mm, m_options.load});
  const EquilibriumSummary solve = m_solver.relax(x);
  m_result.equilibrium.add(solve);
  ++m_result.solves;
  return solve.converged();
}

/// Goes to the target in shares: a first pull over the whole way may invert elements. Returns the
/// share reached.
double Drag::walk_to_target(std::vector<Vec3>& x, double stiffness, double shortest_share)
{
  double reached = 0, step = 0.5;
  while (reached < 1 && step >= shortest_share)
  {
    const double share = std::min(1.0, reached + step);
    const bool found = relax(x, stiffness, share);
    reached = found ? share : reached;
    step = found ? 2 * step : step / 2;
    m_progress(what, reached);
  }
  return reached;
}

void Drag::pull_with_given()
{
  State state{*m_options.stiffness_n_per_mm3, m_face.tissue.rest()};
  const double reached =
      walk_to_target(state.x, state.stiffness, m_options.equilibrium.smallest_load_step);
  m_result.equilibrium.load_reached = reached;
  m_result.stiffness_n_per_mm3 = state.stiffness;
  m_result.x = std::move(state.x);
}

const Drag::State& Drag::nearest(double stiffness) const
{
  auto distance = [&](const State& state)
  {
    return state.stiffness > 0 ? std::abs(std::log(stiffness / state.stiffness))
                               : std::numeric_limits<double>::infinity();
  };
  return *std::min_element(m_states.begin(), m_states.end(),
                           [&](const State& a, const State& b)
                           { return distance(a) < distance(b); });
}

/// Finds the equilibrium with the whole target, from the nearest one that is known or else from
/// rest.
bool Drag::try_stiffness(double stiffness)
{
  constexpr double shortest_share = 1.0 / 8; // where that is too long, softer springs may do
  State state{stiffness, nearest(stiffness).x};
  const bool warm = nearest(stiffness).stiffness > 0;
  if (!warm || !relax(state.x, stiffness, 1))
  {
    state.x = m_face.tissue.rest();
    if (walk_to_target(state.x, stiffness, shortest_share) < 1)
      return false;
  }
  m_states.push_back(std::move(state));
  return true;
}

void Drag::choose_stiffness()
{
  const double first = m_options.load == VirtualLoad::Dead ? first_dead : first_following;
  StiffnessSearch search(m_result.residual_at_rest_mm, m_options.residual_mm, first);
  m_solver.set_step_tolerance(std::max(m_options.equilibrium.step_tolerance_mm,
                                       search_tolerance * std::min(1.0, m_options.residual_mm)));
  while (m_result.solves < m_options.max_solves)
  {
    const auto stiffness = search.next();
    if (!stiffness)
      break;
    const bool found = try_stiffness(*stiffness);
    const double left = found ? residual(m_face.skin.displacement(m_states.back().x))
                              : std::numeric_limits<double>::infinity();
    search.tell({*stiffness, left});
    m_progress(what, 1 - 1 / (1 + 0.25 * m_result.solves));
  }
  m_result.choice = search.met() ? StiffnessChoice::Met : StiffnessChoice::NotMet;
  m_result.stiffness_n_per_mm3 = search.best().stiffness;
  m_result.x = nearest(search.best().stiffness).x;
  if (search.best().stiffness > 0)
  {
    m_solver.set_step_tolerance(m_options.equilibrium.step_tolerance_mm);
    (void)relax(m_result.x, search.best().stiffness, 1);
  }
  m_result.equilibrium.load_reached = search.best().stiffness > 0 ? 1 : 0;
}

VirtualForceResult Drag::run()
{
  m_progress(what, 0);
  if (m_options.stiffness_n_per_mm3)
    pull_with_given();
  else if (m_result.residual_at_rest_mm > m_options.residual_mm)
    choose_stiffness();
  else
  {
    m_result.choice = StiffnessChoice::NoneNeeded;
    m_result.equilibrium.load_reached = 1;
    m_result.x = m_face.tissue.rest();
  }
  if (m_result.equilibrium.load_reached == 0)
    throw Error("virtual-force",
                "the tissue cannot follow even a weak pull towards the target, which is " +
                    number(m_result.residual_at_rest_mm) + " mm away on average",
                "check the target for skin that crosses bone, or bring it nearer to the face",
                ErrorKind::Numerical);
  m_result.skin_displacement = m_face.skin.displacement(m_result.x);
  m_result.residual_mm = residual(m_result.skin_displacement);
  m_result.registrations = m_contacts.register_to(m_result.x);
  for (const FragmentRegistration& registration : m_result.registrations)
    m_result.motions.push_back(registration.motion());
  return std::move(m_result);
}

} // namespace

std::vector<std::string> VirtualForceResult::warnings(const VirtualForceOptions& options) const
{
  std::vector<std::string> texts;
  if (equilibrium.load_reached < 1)
    texts.push_back("the skin could be pulled only " +
                    std::to_string(std::lround(100 * equilibrium.load_reached)) +
                    " % of the way to the target");
  else if (choice == StiffnessChoice::Given &&
           residual_mm > std::max(1.0, 0.5 * residual_at_rest_mm))
    texts.push_back("K_e = " + number(stiffness_n_per_mm3) + " N/mm3 leaves the skin " +
                    number(residual_mm) + " of " + number(residual_at_rest_mm) +
                    " mm from its target on average: it is too soft, or the target out of reach");
  if (choice == StiffnessChoice::NotMet)
    texts.push_back("no K_e that was tried leaves the skin within " + number(options.residual_mm) +
                    " mm of its target on average; the nearest is " + number(residual_mm) +
                    " mm, with K_e = " + number(stiffness_n_per_mm3) + " N/mm3");
  if (choice == StiffnessChoice::NoneNeeded && residual_at_rest_mm > 0)
    texts.push_back("the face at rest is " + number(residual_at_rest_mm) +
                    " mm from its target on average, within the " + number(options.residual_mm) +
                    " mm that K_e is chosen for, so nothing was moved; ask for a smaller residual "
                    "or give K_e");
  return texts;
}

VirtualForceResult drag_skin(const FaceModel& face, const SkinTarget& target,
                             const VirtualForceOptions& options, const Progress& progress)
{
  require_in_range(options);
  return Drag(face, target, options, progress).run();
}

} // namespace f2b
