#include "Benchmarks/growth_report.hpp"
#include "Core/inverse/face_model.hpp"
#include "Logic/Core/slab_mesh.hpp"

#include <Eigen/SparseCholesky>

/// What do the parts of a solve cost on slabs of the face's proportions?
namespace f2b::benchmarks
{
namespace
{

using namespace testing;

/// Slabs of about 30 000, 110 000 and 400 000 tetrahedra: cells along a side, layers of tissue.
void sizes(benchmark::internal::Benchmark* b)
{
  b->Args({36, 4})->Args({55, 6})->Args({86, 9})->UseRealTime()->Unit(benchmark::kMillisecond);
}

SlabOptions slab_of(const benchmark::State& state)
{
  SlabOptions options;
  options.cells = static_cast<int>(state.range(0));
  options.layers = static_cast<int>(state.range(1));
  options.size_mm = 180;
  options.tissue_mm = 18;
  return options;
}

struct Problem
{
  explicit Problem(const benchmark::State& state)
      : mesh(make_slab(slab_of(state))), materials(soft_material()), tissue(mesh),
        model(tissue, materials, held_controls(tissue, Held::BoneAndFragments))
  {
  }
  RigidMotion movement() const
  {
    RigidMotion motion;
    motion.translation = {2, -3, 4};
    return motion;
  }
  MixedMesh mesh;
  MaterialSet materials;
  Discretization tissue;
  ElasticModel model;
};

void note_size(benchmark::State& state, const Problem& problem)
{
  state.counters["tets"] = static_cast<double>(problem.mesh.tets.size());
  state.counters["prisms"] = static_cast<double>(problem.mesh.prisms.size());
  state.counters["peak_MiB"] = peak_memory_mib();
}

void setup(benchmark::State& state)
{
  reset_peak_memory();
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(Problem(state).model.unknown_count());
  note_size(state, Problem(state));
}
BENCHMARK(setup)->Apply(sizes);

void assembly(benchmark::State& state)
{
  reset_peak_memory();
  Problem problem(state);
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(problem.model.linearize(problem.tissue.rest()));
  note_size(state, problem);
}
BENCHMARK(assembly)->Apply(sizes);

void factorization(benchmark::State& state)
{
  reset_peak_memory();
  Problem problem(state);
  (void)problem.model.linearize(problem.tissue.rest());
  Cholesky cholesky;
  cholesky.analyze(problem.model.stiffness(), 3);
  for ([[maybe_unused]] auto _ : state)
    if (!cholesky.factorize(problem.model.stiffness()))
      state.SkipWithError("not positive definite");
  note_size(state, problem);
}
BENCHMARK(factorization)->Apply(sizes);

void full_solve(benchmark::State& state)
{
  reset_peak_memory();
  Problem problem(state);
  const std::vector<Vec3> target = with_fragments_moved(problem.tissue, {problem.movement()});
  for ([[maybe_unused]] auto _ : state)
  {
    std::vector<Vec3> x = problem.tissue.rest();
    if (!EquilibriumSolver(problem.model, {}).move_to(x, target).converged())
      state.SkipWithError("did not converge");
  }
  note_size(state, problem);
}
BENCHMARK(full_solve)->Apply(sizes)->Iterations(1);

/// The same tangent by Eigen's own sparse factorisation, the peer of ours, on the smallest slab.
void factorization_by_eigen_ldlt(benchmark::State& state)
{
  Problem problem(state);
  (void)problem.model.linearize(problem.tissue.rest());
  const SymmetricMatrix& K = problem.model.stiffness();
  const Eigen::Map<const Eigen::SparseMatrix<double, Eigen::ColMajor, long>> matrix(
      K.size, K.size, static_cast<long>(K.value.size()), K.column_start.data(), K.row.data(),
      K.value.data());
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double, Eigen::ColMajor, long>> ldlt;
  ldlt.analyzePattern(matrix);
  for ([[maybe_unused]] auto _ : state)
    ldlt.factorize(matrix);
  note_size(state, problem);
}
BENCHMARK(factorization_by_eigen_ldlt)
    ->Args({36, 4})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

} // namespace
} // namespace f2b::benchmarks

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 2;
  f2b::benchmarks::GrowthReport report;
  benchmark::RunSpecifiedBenchmarks(&report);
  return 0;
}
