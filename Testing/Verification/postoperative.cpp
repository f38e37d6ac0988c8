// Is the outcome of an operation found again in a post-operative CT?
//
//   postoperative CASE_FOLDER WORK_FOLDER [VOXEL_MM]
//
// CASE_FOLDER is meshed. The face that the movement of the paper's Table 2 gives is taken for what
// happened: the post-operative CT is made of it, resliced by known motions of up to 30 mm and 20
// degrees, with noise. Each is then registered and the fragment's movement measured, from rest and
// without knowledge of it. Prints a line a reslice and writes WORK_FOLDER/postoperative.json.

#include "Case/postoperative.hpp"
#include "Bridge/grid_file.hpp"
#include "Bridge/json_file.hpp"
#include "Case/fragment_json.hpp"
#include "Imaging/write_ct.hpp"
#include "Verification/meshed_case.hpp"

#include <cmath>
#include <cstdio>
#include <iostream>

namespace f2b::verification
{
namespace
{

using nlohmann::json;

const double degree = std::acos(-1.0) / 180;

/// What happened to the patient.
struct Outcome
{
  std::vector<RigidMotion> motions;
  std::vector<Vec3> x; ///< of the mesh's nodes
  Prediction face;
};

Outcome operated(const CaseSession& session, const LoadedFace& face)
{
  Outcome outcome;
  outcome.motions = table_2_motions(face);
  outcome.face = predict_face(face.model(), outcome.motions, equilibrium_options(session.settings),
                              no_progress);
  require_converged(outcome.face.summary, "Table 2", {});
  outcome.x.assign(outcome.face.x.begin(), outcome.face.x.begin() + face.mesh.node_count());
  return outcome;
}

struct Reslice
{
  Vec3 translation, angles_deg;
};

/// A copy of the case that knows nothing of plans.
CaseSession cut_case_in(const Path& folder, const CaseFolder& from)
{
  std::filesystem::create_directories(folder);
  for (const char* name :
       {"case.json", "segment.json", "cut.json", "landmarks.mrk.json", "bone_parts.nrrd",
        "bone_distance.nrrd", "closed_bone_distance.nrrd", "skin_distance.nrrd", "skin.vtp"})
    if (from.has(name))
      std::filesystem::copy_file(from.file(name), folder / name,
                                 std::filesystem::copy_options::overwrite_existing);
  return CaseSession::open(folder);
}

/// Errors of the movements over the fragments' surfaces.
json fragment_errors(const CaseFolder& folder, const PostoperativeFindings& found,
                     const std::vector<RigidMotion>& truth)
{
  const ScalarGrid bone = read_scalar_grid(folder.file("bone_distance.nrrd"));
  BonePartition partition;
  partition.labels = read_label_grid(folder.file("bone_parts.nrrd"));
  json errors = json::array();
  for (std::size_t f = 0; f < truth.size(); ++f)
  {
    const auto label = static_cast<unsigned char>(BonePartition::first_fragment + f);
    const auto surface = fragment_surface(bone, partition, label);
    const RigidMotion& motion = found.movements[f].fit.motion;
    errors.push_back({{"largest_mm", largest_difference(motion, truth[f], surface)},
                      {"deg", angle_between(motion, truth[f]) / degree}});
  }
  return errors;
}

json tried(const CaseSession& session, const LoadedFace& face, const Outcome& outcome,
           const PostoperativeCtOptions& options)
{
  const Path file = session.folder.file("after.nrrd");
  write_ct(*synthetic_postoperative_ct(session, outcome.motions, face.mesh, outcome.x, options),
           file);
  const PostoperativeFindings found = postoperative_findings(session, file);
  const RigidMotion& r = found.registration.to_postoperative;
  const auto head = surface_points(
      read_scalar_grid(session.folder.file("bone_distance.nrrd")), [](const Vec3&) { return true; },
      5000);
  std::vector<Vec3> skin = face.reference_skin.points;
  for (std::size_t v = 0; v < skin.size(); ++v)
    skin[v] += outcome.face.skin_displacement[v];
  return {{"reslice", motion_json("head", options.reslice)},
          {"registration_largest_mm", largest_difference(r, options.reslice, head)},
          {"registration_deg", angle_between(r, options.reslice) / degree},
          {"fragments", fragment_errors(session.folder, found, outcome.motions)},
          {"skin_mm", error_json(distance_to_postoperative(found, skin, face.skin_area))},
          {"findings", found.document}};
}

void print(const json& told)
{
  std::cout << "reslice " << told["reslice"]["translation_mm"] << " "
            << told["reslice"]["rotation_deg"] << ": registration "
            << told["registration_largest_mm"] << " mm " << told["registration_deg"]
            << " deg; fragments " << told["fragments"] << "; skin mean " << told["skin_mm"]["mean"]
            << " p95 " << told["skin_mm"]["p95"] << " mm; " << told["findings"]["seconds"] << " s"
            << std::endl;
}

int run(int argc, char** argv)
{
  if (argc != 3 && argc != 4)
  {
    std::cerr << "usage: postoperative CASE_FOLDER WORK_FOLDER [VOXEL_MM]\n";
    return 2;
  }
  const CaseSession meshed = CaseSession::open(argv[1]);
  const LoadedFace face(meshed);
  const Outcome outcome = operated(meshed, face);
  const CaseSession session = cut_case_in(argv[2], meshed.folder);
  PostoperativeCtOptions options;
  options.spacing_mm = Vec3::Constant(argc == 4 ? std::stod(argv[3]) : 1);
  options.reslice.reference_point = outcome.motions.front().reference_point;
  json told = json::array();
  for (const Reslice& reslice :
       {Reslice{{0, 0, 0}, {0, 0, 0}}, Reslice{{3, -5, 4}, {4, -3, 5}},
        Reslice{{-20, 15, 18}, {12, -9, 10}}, Reslice{{17, 17, -18}, {-20, 0, 0}}})
  {
    options.reslice.translation = reslice.translation;
    const Vec3 angles = degree * reslice.angles_deg;
    options.reslice.rotation = rotation_from({angles.x(), angles.y(), angles.z()});
    told.push_back(tried(session, face, outcome, options));
    print(told.back());
  }
  write_json(session.folder.file("postoperative.json"), told);
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
    std::cerr << "postoperative: " << error.what() << "\n";
    return 1;
  }
}
