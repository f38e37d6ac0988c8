#include "Core/mesh/skin_crease.hpp"
#include "Verification/meshed_case.hpp"

#include <cblas.h>
#include <sys/resource.h>

/// What does one prediction of the face cost on a meshed case, and how smooth is its skin?
///
/// Prints JSON: sizes, time split of the solve, flop rate of the factorisation beside that of a
/// dense product on the same machine, peak memory, crease of the face by both shape functions.

namespace
{

using namespace f2b;
using namespace f2b::verification;
using nlohmann::json;

/// Of a product of two 2000 x 2000 matrices, the best of three [1/s].
double dgemm_flop_rate()
{
  const int n = 2000;
  const std::vector<double> a(std::size_t(n) * n, 1.5), b(a);
  std::vector<double> c(a.size(), 0.0);
  double best = 0;
  for (int i = 0; i < 3; ++i)
  {
    const Stopwatch watch;
    cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, n, n, n, 1.0, a.data(), n, b.data(), n,
                0.0, c.data(), n);
    best = std::max(best, 2.0 * n * n * n / watch.seconds());
  }
  return best;
}

json creases(const MixedMesh& mesh, const std::vector<Vec3>& x)
{
  const SmoothSkin skin(mesh);
  json told;
  const auto add = [&](const char* name, const SkinCrease& crease) {
    told[name] = {{"mean_deg", crease.mean_deg}, {"max_deg", crease.max_deg}};
  };
  add("linear_at_rest", linear_skin_crease(mesh, mesh.X));
  add("linear_deformed", linear_skin_crease(mesh, x));
  add("smooth_at_rest", smooth_skin_crease(skin, skin.rest()));
  add("smooth_deformed", smooth_skin_crease(skin, x));
  told["folded_prisms"] = skin.folded_prisms().size();
  return told;
}

double peak_memory_gib()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / (1024 * 1024);
}

json measure(const CaseSession& session)
{
  const LoadedFace face(session);
  const FaceModel model = face.model();
  const std::vector<RigidMotion> motions = table_2_motions(face);
  const Stopwatch watch;
  const Prediction prediction =
      predict_face(model, motions, equilibrium_options(session.settings), no_progress);
  const double seconds = watch.seconds();
  const double memory = peak_memory_gib();
  const EquilibriumSummary& solve = prediction.summary;
  json document = to_json(solve);
  document.update({{"prisms", face.mesh.prisms.size()},
                   {"tets", face.mesh.tets.size()},
                   {"control_vectors", face.tissue.control_count()},
                   {"seconds", seconds},
                   {"peak_gib", memory},
                   {"residuals_n", solve.residuals_n},
                   {"time_s", time_split(solve.effort)},
                   {"factorization_gflops", 1e-9 * solve.effort.flop_rate()},
                   {"dgemm_gflops", 1e-9 * dgemm_flop_rate()},
                   {"crease", creases(face.mesh, prediction.x)}});
  return document;
}

} // namespace

int main(int argc, char** argv)
{
  return f2b::verification::print_of_case("forward_solve", argc, argv, measure);
}
