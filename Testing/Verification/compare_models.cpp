#include "Core/models/face_models.hpp"
#include "Verification/meshed_case.hpp"

#include <map>

/// What do the four models of Table 3 cost and predict on a meshed case, for Table 2's movement?
///
/// Prints JSON: per model its time and work; distances between the models' faces, RMS and largest
/// over the nodes, relative to the largest displacement of the second.

namespace
{

using namespace f2b;
using namespace f2b::verification;
using nlohmann::json;

json distance(const MixedMesh& mesh, const std::vector<Vec3>& a, const std::vector<Vec3>& b)
{
  double sum = 0, worst = 0, largest = 0;
  for (std::size_t n = 0; n < a.size(); ++n)
  {
    sum += (a[n] - b[n]).squaredNorm();
    worst = std::max(worst, (a[n] - b[n]).norm());
    largest = std::max(largest, (b[n] - mesh.X[n]).norm());
  }
  return {{"rms", std::sqrt(sum / double(a.size())) / largest}, {"max", worst / largest}};
}

json told(FaceModelKind model, const FaceModelResult& result, double seconds)
{
  json document = {{"seconds", seconds}, {"converged", result.equilibrium.converged()}};
  if (model != FaceModelKind::Mtm)
  {
    document["newton_iterations"] = result.equilibrium.newton_iterations;
    document["factorizations"] = result.equilibrium.effort.factorizations;
    document["load_reached"] = result.equilibrium.load_reached;
    return document;
  }
  document["converged"] = result.relaxation.converged;
  document["steps"] = result.relaxation.steps;
  document["residual"] = result.relaxation.residual;
  return document;
}

json compare(const CaseSession& session)
{
  const LoadedFace face(session);
  const std::vector<RigidMotion> motions = table_2_motions(face);
  FaceModelOptions options;
  options.equilibrium = equilibrium_options(session.settings);
  json document = {{"nodes", face.mesh.X.size()},
                   {"split_tets", face.mesh.tets.size() + 3 * face.mesh.prisms.size()}};
  std::map<FaceModelKind, FaceModelResult> results;
  for (const FaceModelKind model :
       {FaceModelKind::Lfem, FaceModelKind::Mtm, FaceModelKind::Nfem, FaceModelKind::NfmEm})
  {
    const Stopwatch watch;
    results[model] =
        predict_with(model, {face.mesh, face.materials, motions}, face.map, options, no_progress);
    document[name_of(model)] = told(model, results[model], watch.seconds());
  }
  const auto apart = [&](FaceModelKind one, FaceModelKind other)
  { return distance(face.mesh, results[one].x, results[other].x); };
  document["mtm_from_lfem"] = apart(FaceModelKind::Mtm, FaceModelKind::Lfem);
  document["nfem_from_lfem"] = apart(FaceModelKind::Nfem, FaceModelKind::Lfem);
  document["nfm-em_from_nfem"] = apart(FaceModelKind::NfmEm, FaceModelKind::Nfem);
  return document;
}

} // namespace

int main(int argc, char** argv)
{
  return f2b::verification::print_of_case("compare_models", argc, argv, compare);
}
