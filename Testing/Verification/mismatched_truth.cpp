// How far is a plan off when the patient is not as it believes?
//
//   mismatched_truth CASE_FOLDER SEED RESULT.json
//
// CASE_FOLDER is meshed. A movement and a truth are drawn: another mesh of tetrahedra only, a
// neo-Hookean law, each tissue's stiffness by 0.5 to 2, Poisson's ratio 0.45, skin of 1 to 2 mm, a
// shift of 0.5 mm that registration left, and noise of 0.5 mm over 0, 5 and 15 mm. Each cause is
// also tried alone. Writes bone errors by cause, and of virtual-force on the same target.

#include "Bridge/json_file.hpp"
#include "Case/virtual_force_case.hpp"
#include "Case/virtual_truth.hpp"
#include "Core/error.hpp"
#include "Core/geometry/noise_field.hpp"
#include "Core/inverse/rigid_fit.hpp"
#include "Verification/bone_error.hpp"

#include <cstdio>
#include <iostream>

namespace f2b::verification
{
namespace
{

using nlohmann::json;

constexpr double noise_mm = 0.5, registration_mm = 0.5;
constexpr double noise_lengths_mm[] = {0, 5, 15};

/// What is drawn for one seed.
struct DrawnCase
{
  std::vector<RigidMotion> motions;
  TruthOptions truth;
  Vec3 registration;
  std::uint64_t seed;
};

/// As mid-faces go: forwards, up or down, turned a little.
RigidMotion drawn_motion(RandomNumbers& random, const Vec3& reference_point)
{
  const double degree = std::acos(-1.0) / 180;
  RigidMotion motion;
  motion.reference_point = reference_point;
  motion.translation = {random.between(-2, 2), random.between(2, 10), random.between(-5, 3)};
  motion.rotation = rotation_from({random.between(-5, 5) * degree, random.between(-3, 3) * degree,
                                   random.between(-3, 3) * degree});
  return motion;
}

DrawnCase drawn(const LoadedFace& face, std::uint64_t seed)
{
  RandomNumbers random(seed);
  DrawnCase one;
  one.seed = seed;
  for (const Vec3& c : face.reference_points)
    one.motions.push_back(drawn_motion(random, c));
  for (double& factor : one.truth.stiffness)
    factor = std::exp(random.between(-std::log(2.0), std::log(2.0)));
  one.truth.skin_thickness_mm = random.between(1, 2);
  one.registration = registration_mm * random.direction();
  return one;
}

/// A tenth of a per mille of the errors that are measured.
RigidFitOptions fit_options()
{
  RigidFitOptions options;
  options.translation_tolerance_mm = 1e-3;
  options.rotation_tolerance_rad = 1e-5;
  options.equilibrium.step_tolerance_mm = 1e-5;
  return options;
}

/// One seed's study.
class Study
{
public:
  Study(const CaseSession& session, const LoadedFace& face, const DrawnCase& one)
      : m_session(session), m_face(face), m_model(face.model()), m_case(one),
        m_surfaces(session.folder, face.mesh.fragments)
  {
  }

  json told();

private:
  SkinTarget target_of(const TruthMesh& mesh, const TruthOptions& options);
  RigidFitResult plan(const SkinTarget& target, const RigidFitResult* start) const
  {
    return fit_fragments(m_model, target, fit_options(), no_progress, start);
  }
  double between(const RigidFitResult& a, const RigidFitResult& b) const
  {
    return m_surfaces.mean_mm(a.motions, b.motions);
  }
  double error(const RigidFitResult& plan) const
  {
    return m_surfaces.mean_mm(plan.motions, m_case.motions);
  }
  SkinTarget noisy(const SkinTarget& target, double correlation_mm) const;
  SkinTarget shifted(SkinTarget target, bool is_doubted) const;

  const CaseSession& m_session;
  const LoadedFace& m_face;
  FaceModel m_model;
  const DrawnCase& m_case;
  FragmentSurfaces m_surfaces;
};

SkinTarget Study::target_of(const TruthMesh& mesh, const TruthOptions& options)
{
  const MaterialSet materials = truth_materials(m_face.materials, options);
  const FaceModel truth = mesh.model(materials, m_face);
  const Prediction face =
      predict_face(truth, m_case.motions, fit_options().equilibrium, no_progress);
  require_converged(face.summary, "the truth", {});
  SkinTarget target{face.skin_displacement, {}, {}};
  for (const double area : truth.skin_area)
    target.weight.push_back(area > 0 ? 1 : 0);
  return target;
}

SkinTarget Study::noisy(const SkinTarget& target, double correlation_mm) const
{
  SkinTarget noisy = target;
  const auto noise = correlated_noise(m_face.reference_skin.points,
                                      {noise_mm, correlation_mm, m_case.seed + 1000});
  for (std::size_t v = 0; v < noise.size(); ++v)
    noisy.displacement[v] += noise[v];
  return noisy;
}

/// \param is_doubted  the plan looks for the shift too
SkinTarget Study::shifted(SkinTarget target, bool is_doubted) const
{
  for (Vec3& d : target.displacement)
    d += m_case.registration;
  target.registration_sd_mm = is_doubted ? registration_mm / std::sqrt(3.0) : 0;
  return target;
}

json Study::told()
{
  TruthOptions like_plan;
  like_plan.skin_thickness_mm = m_session.settings.skin_thickness_mm;
  like_plan.is_neo_hookean = false;
  like_plan.stiffness = {1, 1, 1};
  like_plan.poisson_ratio.reset();
  json causes;
  RigidFitResult base;
  {
    const TruthMesh mesh(m_session, like_plan, no_progress);
    base = plan(target_of(mesh, like_plan), nullptr);
    causes["mesh"] = error(base);
    auto alone = [&](const char* cause, const TruthOptions& options)
    { causes[cause] = between(plan(target_of(mesh, options), &base), base); };
    TruthOptions other = like_plan;
    other.is_neo_hookean = true;
    alone("law", other);
    other = like_plan;
    other.stiffness = m_case.truth.stiffness;
    alone("stiffness", other);
    other = like_plan;
    other.poisson_ratio = m_case.truth.poisson_ratio;
    alone("poisson_ratio", other);
  }
  const TruthMesh mesh(m_session, m_case.truth, no_progress);
  TruthOptions thickness = like_plan;
  thickness.skin_thickness_mm = m_case.truth.skin_thickness_mm;
  causes["skin_thickness"] = between(plan(target_of(mesh, thickness), &base), base);

  const SkinTarget exact = target_of(mesh, m_case.truth);
  const RigidFitResult tissue = plan(exact, &base);
  causes["all_of_the_tissue"] = error(tissue);
  causes["registration"] = between(plan(shifted(exact, true), &tissue), tissue);
  causes["registration_not_doubted"] = between(plan(shifted(exact, false), &tissue), tissue);
  json totals = json::object();
  double sum = 0;
  for (const double length : noise_lengths_mm)
  {
    const std::string name = std::to_string(static_cast<int>(length)) + "_mm";
    const SkinTarget measured = noisy(exact, length);
    causes["noise_" + name] = between(plan(measured, &tissue), tissue);
    totals["noise_" + name] = error(plan(shifted(measured, true), &tissue));
    sum += totals["noise_" + name].get<double>();
  }
  const double rigid_fit = sum / static_cast<double>(std::size(noise_lengths_mm));
  const VirtualForceResult dragged = drag_skin(m_model, shifted(noisy(exact, 5), true),
                                               virtual_force_options(m_session), no_progress);
  return {{"seed", m_case.seed},
          {"causes_mm", causes},
          {"totals_mm", totals},
          {"rigid_fit_mm", rigid_fit},
          {"virtual_force_mm", m_surfaces.mean_mm(dragged.motions, m_case.motions)},
          {"bone_travel_mm", m_surfaces.mean_mm(rest_motions(m_model), m_case.motions)},
          {"stiffness_factors", m_case.truth.stiffness},
          {"skin_thickness_mm", m_case.truth.skin_thickness_mm},
          {"tetrahedra", {{"plan", m_face.mesh.tets.size()}, {"truth", mesh.tets()}}}};
}

int run(int argc, char** argv)
{
  if (argc != 4)
  {
    std::cerr << "usage: mismatched_truth CASE_FOLDER SEED RESULT.json\n";
    return 2;
  }
  const Stopwatch watch;
  const CaseSession session = CaseSession::open(argv[1]);
  const LoadedFace face(session);
  const DrawnCase one = drawn(face, std::stoul(argv[2]));
  json told = Study(session, face, one).told();
  told["seconds"] = watch.seconds();
  std::cout << told.dump() << std::endl;
  write_json(argv[3], told);
  return 0;
}

} // namespace
} // namespace f2b::verification

int main(int argc, char** argv)
{
  try
  {
    return f2b::verification::run(argc, argv);
  }
  catch (const std::exception& error)
  {
    std::cerr << "mismatched_truth: " << error.what() << "\n";
    return 1;
  }
}
