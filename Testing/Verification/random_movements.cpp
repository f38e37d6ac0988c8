// Does the face follow any movement that a surgeon could make?
//
//   random_movements CASE_FOLDER COUNT RESULT.json [PART PARTS]
//
// CASE_FOLDER is meshed and has one fragment. Prints one line a movement and writes RESULT.json.
// With PART of PARTS, only movements PART, PART + PARTS, ... are tried: one process a core is faster
// than one process with all cores.

#include "Bridge/grid_file.hpp"
#include "Bridge/json_file.hpp"
#include "Case/case_session.hpp"
#include "Core/error.hpp"
#include "Core/geometry/osteotomy.hpp"
#include "Verification/movement_sampler.hpp"

#include <cmath>
#include <cstdio>

namespace f2b::verification
{
namespace
{

using nlohmann::json;

/// The sentence that a user reads if a solve stopped; empty if it converged.
std::string sentence(const EquilibriumSummary& summary)
{
  try
  {
    require_converged(summary, "movement", {});
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return "";
}

/// Of the state that is handed back: all numbers, no inverted element, and its unbalanced force as
/// a share of what one of its larger nodes carries.
json judged_state(const ElasticModel& model, const Prediction& prediction)
{
  bool finite = true;
  for (const std::vector<Vec3>* field : {&prediction.x, &prediction.skin_displacement})
    for (const Vec3& v : *field)
      finite = finite && v.allFinite();
  const double dilatation = finite ? model.smallest_dilatation(prediction.x) : std::nan("");
  return {{"finite", finite},
          {"smallest_dilatation", dilatation},
          {"unbalanced_force_n", finite ? model.forces(prediction.x).norm() : std::nan("")}};
}

json effort_of(const EquilibriumSummary& summary)
{
  const SolveEffort& e = summary.effort;
  return {{"seconds", e.total},
          {"load_steps", summary.load_steps},
          {"newton_iterations", summary.newton_iterations},
          {"factorizations", e.factorizations},
          {"cg_iterations", e.cg_iterations}};
}

json tried(const LoadedFace& face, const ElasticModel& model, const SampledMovement& movement,
           const EquilibriumOptions& options)
{
  const Prediction prediction = predict_face(face.model(), {movement.motion}, options, no_progress);
  json row = judged_state(model, prediction);
  row.update(effort_of(prediction.summary));
  row.update({{"translation_mm", movement.translation_mm},
              {"rotation_deg", movement.rotation_deg},
              {"direction", to_json(movement.motion.translation)},
              {"overlap_depth_mm", movement.overlap_depth_mm},
              {"converged", prediction.summary.converged()},
              {"load_reached", prediction.summary.load_reached},
              {"sentence", sentence(prediction.summary)}});
  return row;
}

void print_row(int index, const json& row)
{
  std::printf(
      "%4d %6.2f mm %6.2f deg  %-9s %5.0f %%  min J %7.4f  %2d factors %3d CG %6.2f s  %s\n", index,
      row.at("translation_mm").get<double>(), row.at("rotation_deg").get<double>(),
      row.at("converged").get<bool>() ? "converged" : "stopped",
      100 * row.at("load_reached").get<double>(), row.at("smallest_dilatation").get<double>(),
      row.at("factorizations").get<int>(), row.at("cg_iterations").get<int>(),
      row.at("seconds").get<double>(), row.at("sentence").get<std::string>().c_str());
  std::fflush(stdout);
}

/// Which of all movements this process tries.
struct Part
{
  int index = 0, count = 1;
};

int run(const Path& folder, int count, const Path& result, const Part& part)
{
  constexpr std::uint64_t seed = 20261122;
  const CaseSession session = CaseSession::open(folder);
  const LoadedFace face(session);
  const ScalarGrid bone = read_scalar_grid(session.folder.require("bone_distance.nrrd", "segment"));
  const LabelGrid parts = read_label_grid(session.folder.require("bone_parts.nrrd", "cut"));
  const ElasticModel model(face.tissue, face.materials,
                           held_controls(face.tissue, Held::BoneAndFragments));
  MovementSampler sampler({bone, parts}, BonePartition::first_fragment,
                          face.reference_points.front(), seed);
  json rows = json::array();
  for (int i = 0; i < count; ++i)
  {
    const SampledMovement movement = sampler.next();
    if (i % part.count != part.index)
      continue;
    rows.push_back(tried(face, model, movement, equilibrium_options(session.settings)));
    print_row(i, rows.back());
  }
  write_json(result, {{"seed", seed},
                      {"left_out_into_uncut_bone", sampler.left_out()},
                      {"materials", face.materials.name},
                      {"tets", face.mesh.tets.size()},
                      {"movements", rows}});
  return 0;
}

} // namespace
} // namespace f2b::verification

int main(int argc, char** argv)
{
  if (argc != 4 && argc != 6)
  {
    std::fprintf(stderr, "usage: random_movements CASE_FOLDER COUNT RESULT.json [PART PARTS]\n");
    return 2;
  }
  try
  {
    f2b::verification::Part part;
    if (argc == 6)
      part = {std::stoi(argv[4]), std::stoi(argv[5])};
    return f2b::verification::run(argv[1], std::stoi(argv[2]), argv[3], part);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "random_movements: %s\n", error.what());
    return 1;
  }
}
