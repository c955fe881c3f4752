// Point-updates a second of the small-strain solver on the paper's size, 300 x 300 points, history on, beside
// what the machine can do at most. Run alone on an idle machine: build/release/bin/lattice_bench
#include <benchmark/benchmark.h>

#include <cstdio>

#include "apps/system/machine.hpp"
#include "libmpm/run/simulate.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace {

app::MachinePeak machine;

enum class Case { elastic, tension, tension_closure, tension_several_ratios };

mpm::Scene scene_of(Case kind, int size) {
  mpm::Scene scene = samples::small_concrete(size, size);
  scene.loading.velocity = 0.05;
  // 1,000 steps at 300 x 300 points, a tenth of the paper's tension test, and a row of the history every 10
  // steps as there; 16 times fewer for 16 times the points.
  scene.history_rows = size > 300 ? 10 : 100;
  scene.loading.stop_strain = size > 300 ? 6.4e-7 : 4e-5;
  scene.loading.ramp_time = 1e-5;
  switch (kind) {
    case Case::elastic:
      return samples::unbreakable(scene);
    case Case::tension:
      break;
    case Case::tension_closure:
      scene.damage.crack_closure = mpm::CrackClosure::unilateral;
      break;
    case Case::tension_several_ratios:
      scene.phases[samples::itz]->poisson = 0.22;
      break;
  }
  return scene;
}

void lattice(benchmark::State& state, Case kind, mpm::Precision precision, int threads) {
  mpm::Scene scene = scene_of(kind, static_cast<int>(state.range(0)));
  scene.precision = precision;
  scene.threads = threads;
  double updates = 0;
  double seconds = 0;
  for (auto _ : state) {
    const mpm::Result result = mpm::simulate(scene);
    updates += static_cast<double>(result.points) * static_cast<double>(result.steps);
    seconds += result.wall_time;
    state.SetIterationTime(result.wall_time);
  }
  const double rate = updates / seconds;
  const double peak = precision == mpm::Precision::single ? machine.flops_single : machine.flops_double;
  state.counters["Mupdates/s"] = rate / 1e6;
  state.counters["%peak"] = 100 * rate * app::lattice_operations / (peak * threads);
}

void registered(const char* name, Case kind, mpm::Precision precision, int size, int threads = 1) {
  benchmark::RegisterBenchmark(name, lattice, kind, precision, threads)
      ->Arg(size)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond)
      ->Iterations(size > 300 ? 1 : 4)
      ->Repetitions(5)
      ->ReportAggregatesOnly(true);
}

}  // namespace

int main(int argc, char** argv) {
  machine = app::measure_machine_peak();
  std::printf("machine, one core: %.1f GFlop/s in 64 bits, %.1f in 32 bits (multiply-adds), copy %.1f GB/s\n",
              machine.flops_double / 1e9, machine.flops_single / 1e9, machine.copy_bandwidth / 1e9);
  using P = mpm::Precision;
  registered("tension/double", Case::tension, P::double_, 300);
  registered("tension/single", Case::tension, P::single, 300);
  registered("elastic/double", Case::elastic, P::double_, 300);
  registered("elastic/single", Case::elastic, P::single, 300);
  registered("several_poisson_ratios/double", Case::tension_several_ratios, P::double_, 300);
  registered("crack_closure/double", Case::tension_closure, P::double_, 300);
  registered("tension/double/large", Case::tension, P::double_, 1200);
  registered("tension/double/large/2_threads", Case::tension, P::double_, 1200, 2);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
