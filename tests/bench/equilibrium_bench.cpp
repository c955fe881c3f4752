// Speed of equilibrium without inertia on the paper's size, 300 x 300 points: the elastic solve, and the
// whole tension test until 30 % of the peak are left, beside the explicit one. Repetitions are interleaved.
// Run alone on an idle machine: build/release/bin/equilibrium_bench
// --benchmark_enable_random_interleaving=true
#include <benchmark/benchmark.h>

#include <chrono>

#include "libmpm/run/simulate.hpp"
#include "libmpm/solver/quasi_static/equilibrium.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace {

mpm::Scene scene_of(mpm::SolverMethod method, bool pixel_cells, int size, int threads) {
  mpm::Scene scene = samples::small_concrete(size, size);
  scene.method = method;
  scene.pixel_cells = pixel_cells;
  scene.points_per_cell = pixel_cells ? 1 : 2;
  scene.threads = threads;
  return scene;
}

/// Displacements of intact points, from nothing.
void elastic(benchmark::State& state, bool pixel_cells, int threads) {
  const mpm::Scene scene = samples::unbreakable(
      scene_of(mpm::SolverMethod::quasi_static, pixel_cells, static_cast<int>(state.range(0)), threads));
  const mpm::Plan plan = mpm::plan(scene);
  double iterations = 0;
  for (auto _ : state) {
    mpm::Equilibrium equilibrium(scene, plan, mpm::StrengthFactors(scene, false));
    const auto start = std::chrono::steady_clock::now();
    if (!equilibrium.solve(0)) state.SkipWithError("no equilibrium was found");
    state.SetIterationTime(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    iterations = static_cast<double>(equilibrium.iterations());
  }
  state.counters["iterations"] = iterations;
}

/// The tension test until 30 % of the peak are left; without inertia with failures within 2 % at once.
void tension(benchmark::State& state, mpm::SolverMethod method, bool pixel_cells) {
  mpm::Scene scene = scene_of(method, pixel_cells, static_cast<int>(state.range(0)), 1);
  scene.loading.velocity = 0.05;
  scene.loading.stop_strain = 1e-3;
  scene.loading.stop_drop = 0.3;
  scene.event_tolerance = 0.02;
  mpm::Result result;
  for (auto _ : state) {
    result = mpm::simulate(scene);
    state.SetIterationTime(result.wall_time);
  }
  state.counters["states"] = static_cast<double>(result.steps);
  state.counters["failures"] = static_cast<double>(result.tension_failures + result.shear_failures);
}

template <class Function, class... Arguments>
void registered(const char* name, int size, int repetitions, Function function, Arguments... arguments) {
  benchmark::RegisterBenchmark(name, function, arguments...)
      ->Arg(size)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond)
      ->Iterations(1)
      ->Repetitions(repetitions)
      ->ReportAggregatesOnly(true);
}

}  // namespace

int main(int argc, char** argv) {
  using M = mpm::SolverMethod;
  registered("elastic/2x2", 300, 9, elastic, false, 1);
  registered("elastic/pixel", 300, 9, elastic, true, 1);
  registered("elastic/pixel/2_threads", 300, 9, elastic, true, 2);
  registered("elastic/pixel/large", 1200, 3, elastic, true, 1);
  registered("elastic/pixel/large/2_threads", 1200, 3, elastic, true, 2);
  registered("tension/explicit/2x2", 300, 3, tension, M::explicit_, false);
  registered("tension/quasi_static/2x2", 300, 3, tension, M::quasi_static, false);
  registered("tension/explicit/pixel", 300, 3, tension, M::explicit_, true);
  registered("tension/quasi_static/pixel", 300, 3, tension, M::quasi_static, true);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
