// Is a movement found back from the face that it gives?
//
//   recovery CASE_FOLDER SEED COUNT RESULT.json
//
// CASE_FOLDER is meshed and has any number of fragments. Movements of 0 to 22 mm and 0 to 15 degrees
// are drawn: all fragments together by one part, and each by up to 6 mm and 5 degrees of its own
// where there are several. The face of each is predicted by the plan's own model (a self-test: it
// shows that the inverse is solved), and the movement looked for from it, and from it with 0.5 mm
// of noise. A movement that the tissue cannot follow is counted and another one drawn.

#include "Bridge/json_file.hpp"
#include "Core/geometry/noise_field.hpp"
#include "Core/geometry/surface_fit.hpp"
#include "Core/inverse/rigid_fit.hpp"
#include "Verification/bone_error.hpp"

#include <iostream>

namespace f2b::verification
{
namespace
{

using nlohmann::json;

const double degree = std::acos(-1.0) / 180;

/// Not backwards, where bone is.
Vec3 forwards(RandomNumbers& random)
{
  Vec3 direction = random.direction();
  direction.y() = std::abs(direction.y());
  return direction;
}

Mat3 drawn_rotation(RandomNumbers& random, double widest_deg)
{
  const double angle = random.between(0, widest_deg) * degree;
  return rotation_from_vector(angle * random.direction());
}

/// Up to 22 mm and 15 degrees for each fragment.
std::vector<RigidMotion> drawn_motions(RandomNumbers& random, const LoadedFace& face)
{
  const bool several = face.reference_points.size() > 1;
  const double longest = several ? 16 : 22, widest = several ? 10 : 15;
  const Vec3 shift = random.between(0, longest) * forwards(random);
  const Mat3 rotation = drawn_rotation(random, widest);
  std::vector<RigidMotion> motions;
  for (const Vec3& c : face.reference_points)
  {
    RigidMotion motion{rotation, shift, c};
    if (several)
    {
      motion.translation += random.between(0, 6) * random.direction();
      motion.rotation = drawn_rotation(random, 5) * rotation;
    }
    motions.push_back(motion);
  }
  return motions;
}

struct Errors
{
  double mm = 0, deg = 0; ///< largest over fragments, of the reference point and the rotation
};

Errors errors(const std::vector<RigidMotion>& found, const std::vector<RigidMotion>& truth)
{
  Errors e;
  for (std::size_t f = 0; f < truth.size(); ++f)
  {
    e.mm = std::max(e.mm, (found[f].translation - truth[f].translation).norm());
    e.deg = std::max(e.deg, angle_between(found[f], truth[f]) / degree);
  }
  return e;
}

/// One movement; nothing if the tissue cannot follow it.
json tried(const LoadedFace& face, const FragmentSurfaces& bones,
           const std::vector<RigidMotion>& truth, std::uint64_t seed)
{
  EquilibriumOptions forward;
  forward.max_total_iterations = 60; // another movement is cheaper than a hard one
  const FaceModel model = face.model();
  const Prediction target = predict_face(model, truth, forward, no_progress);
  if (!target.summary.converged())
    return {};
  const std::vector<double> weight(target.skin_displacement.size(), 1.0);
  const RigidFitResult exact =
      fit_fragments(model, {target.skin_displacement, weight, {}}, {}, no_progress);
  const Errors e = errors(exact.motions, truth);
  json row = {{"exact", {{"mm", e.mm}, {"deg", e.deg}}},
              {"converged", exact.termination == RigidFitTermination::Converged},
              {"iterations", exact.iterations.size()}};
  for (const double length : {0.0, 5.0})
  {
    SkinTarget noisy{target.skin_displacement, weight, {}};
    const auto noise = correlated_noise(face.reference_skin.points, {0.5, length, seed});
    for (std::size_t v = 0; v < noise.size(); ++v)
      noisy.displacement[v] += noise[v];
    const RigidFitResult found = fit_fragments(model, noisy, {}, no_progress, &exact);
    row[length > 0 ? "noise_over_5_mm" : "noise"] = {
        {"bone_mm", bones.mean_mm(found.motions, truth)}, {"mm", errors(found.motions, truth).mm}};
  }
  double longest = 0, widest = 0;
  for (const RigidMotion& m : truth)
  {
    longest = std::max(longest, m.translation.norm());
    widest = std::max(widest, angle_between(m, RigidMotion{}) / degree);
  }
  row["longest_mm"] = longest;
  row["widest_deg"] = widest;
  return row;
}

int run(int argc, char** argv)
{
  if (argc != 5)
  {
    std::cerr << "usage: recovery CASE_FOLDER SEED COUNT RESULT.json\n";
    return 2;
  }
  const Stopwatch watch;
  const CaseSession session = CaseSession::open(argv[1]);
  const LoadedFace face(session);
  const FragmentSurfaces bones(session.folder, face.mesh.fragments);
  const std::uint64_t seed = std::stoul(argv[2]);
  const auto count = std::stoul(argv[3]);
  RandomNumbers random(seed);
  json rows = json::array();
  int not_followed = 0;
  while (rows.size() < count)
  {
    const std::vector<RigidMotion> truth = drawn_motions(random, face);
    json row = tried(face, bones, truth, seed + rows.size());
    if (row.is_null() && ++not_followed > 10 * static_cast<int>(count))
      throw std::runtime_error("the tissue follows hardly any of the movements");
    if (row.is_null())
      continue;
    std::cout << row.dump() << std::endl;
    rows.push_back(std::move(row));
  }
  write_json(argv[4], {{"fragments", face.mesh.fragments},
                       {"tetrahedra", face.mesh.tets.size()},
                       {"not_followed", not_followed},
                       {"movements", rows},
                       {"seconds", watch.seconds()}});
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
    std::cerr << "recovery: " << error.what() << "\n";
    return 1;
  }
}
