#include "Core/inverse/virtual_force.hpp"
#include "Verification/meshed_case.hpp"

/// What does virtual-force find on a meshed case, by how K_e is chosen, and what does that cost?
///
/// The target is the face of Table 2's movement, so that the truth is known. Prints JSON: one entry
/// for each way of choosing K_e, over the whole face and over the skin that the target moves.

namespace
{

using namespace f2b;
using namespace f2b::verification;
using nlohmann::json;

/// Mean distance between where two movements take a fragment's contact nodes [mm].
double miss_mm(const MixedMesh& mesh, const RigidMotion& found, const RigidMotion& truth)
{
  double sum = 0;
  int count = 0;
  for (std::size_t n = 0; n < mesh.X.size(); ++n)
    if (mesh.node_boundary[n] == Boundary::Fragment && mesh.node_fragment[n] == 0)
    {
      sum += (found.apply(mesh.X[n]) - truth.apply(mesh.X[n])).norm();
      ++count;
    }
  return sum / std::max(count, 1);
}

json pull(const FaceModel& face, const SkinTarget& target, const VirtualForceOptions& options,
          const RigidMotion& truth)
{
  const Stopwatch watch;
  const VirtualForceResult found = drag_skin(face, target, options, no_progress);
  const double seconds = watch.seconds();
  return {{"k_e_asked_for",
           options.stiffness_n_per_mm3 ? json(*options.stiffness_n_per_mm3) : json("auto")},
          {"residual_asked_for_mm", options.residual_mm},
          {"k_e_n_per_mm3", found.stiffness_n_per_mm3},
          {"residual_mm", found.residual_mm},
          {"residual_at_rest_mm", found.residual_at_rest_mm},
          {"miss_mm", miss_mm(face.tissue.mesh(), found.motions[0], truth)},
          {"registration_rms_mm", found.registrations[0].surface.rms_mm},
          {"solves", found.solves},
          {"newton_iterations", found.equilibrium.newton_iterations},
          {"factorizations", found.equilibrium.effort.factorizations},
          {"seconds", seconds},
          {"warnings", found.warnings(options)}};
}

json measure(const CaseSession& session)
{
  const LoadedFace face(session);
  const FaceModel model = face.model();
  const RigidMotion truth = table_2_motions(face).front();
  VirtualForceOptions given, chosen;
  given.equilibrium = chosen.equilibrium = equilibrium_options(session.settings);
  given.stiffness_n_per_mm3 = 0.02;
  SkinTarget target;
  target.displacement =
      predict_face(model, table_2_motions(face), given.equilibrium, no_progress).skin_displacement;
  json document;
  for (const double mask_mm : {0.0, 1.0})
  {
    target.weight.clear();
    for (const Vec3& d : target.displacement)
      target.weight.push_back(d.norm() >= mask_mm);
    json& told = document[mask_mm > 0 ? "skin_that_moves" : "whole_face"];
    told.push_back(pull(model, target, given, truth));
    told.push_back(pull(model, target, chosen, truth));
  }
  return document;
}

} // namespace

int main(int argc, char** argv)
{
  return f2b::verification::print_of_case("pull_skin", argc, argv, measure);
}
