#include <Core/sculpting/sculpting_session.hpp>
#include <Logic/Core/flat_sheet.hpp>

#include <benchmark/benchmark.h>

#include <cmath>

/// What does a dab cost on skins of 100 000 and 400 000 vertices, finding the place included?
namespace f2b::benchmarks
{
namespace
{

/// A bumpy sheet of cells of 1 mm, as the reference skin's; `cells` along a side.
TriangleMesh bumpy_skin(int cells)
{
  return testing::make_sheet(cells, 1.0 * cells,
                             [](double r, double s)
                             { return 20 * std::cos(r / 40) * std::cos(s / 50); });
}

void dab(benchmark::State& state, BrushKind kind)
{
  SculptingSession session(bumpy_skin(static_cast<int>(state.range(0))));
  Brush brush;
  brush.kind = kind;
  brush.radius_mm = static_cast<double>(state.range(1));
  brush.strength = 0.5;
  brush.symmetry = SymmetryPlane{};
  const Vec3 view(0, -1, 0);
  int k = 0;
  for ([[maybe_unused]] auto _ : state)
  {
    const Vec3 eye(25 + 10 * std::sin(0.1 * k), 300, 10 * std::cos(0.1 * k));
    ++k;
    brush.inverted = k % 2;
    const auto place = session.skin().tree().first_hit(eye, view);
    session.begin_stroke(brush, *place, view);
    if (brush.drags())
      session.drag({0, k % 2 ? 0.5 : -0.5, 0});
    session.end_stroke();
  }
  state.counters["vertices"] = static_cast<double>(session.skin().size());
}

void drag_on(benchmark::State& state)
{
  SculptingSession session(bumpy_skin(static_cast<int>(state.range(0))));
  Brush brush;
  brush.kind = BrushKind::ElasticGrab;
  brush.radius_mm = static_cast<double>(state.range(1));
  brush.symmetry = SymmetryPlane{};
  const Vec3 view(0, -1, 0);
  session.begin_stroke(brush, *session.skin().tree().first_hit({25, 300, 0}, view), view);
  int k = 0;
  for ([[maybe_unused]] auto _ : state)
    session.drag(Vec3(0, std::sin(0.1 * k++), 0.2));
}

void sizes(benchmark::internal::Benchmark* b)
{
  b->Args({316, 15})->Args({316, 30})->Args({632, 15})->Unit(benchmark::kMillisecond);
}

BENCHMARK_CAPTURE(dab, grab, BrushKind::Grab)->Apply(sizes);
BENCHMARK_CAPTURE(dab, elastic_grab, BrushKind::ElasticGrab)->Apply(sizes);
BENCHMARK_CAPTURE(dab, draw, BrushKind::Draw)->Apply(sizes);
BENCHMARK_CAPTURE(dab, smooth, BrushKind::Smooth)->Apply(sizes);
BENCHMARK_CAPTURE(dab, flatten, BrushKind::Flatten)->Apply(sizes);
BENCHMARK_CAPTURE(dab, mask, BrushKind::Mask)->Apply(sizes);
BENCHMARK(drag_on)->Apply(sizes);

} // namespace
} // namespace f2b::benchmarks

BENCHMARK_MAIN();
