// Point-updates a second of moving points under the conditions of lattice_bench: 300 x 300 points, 2 x 2 a
// cell, damage and history on. Run alone on an idle machine: build/release/bin/moving_bench
#include <benchmark/benchmark.h>

#include <cstdio>
#include <string>

#include "apps/system/machine.hpp"
#include "libmpm/run/simulate.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace {

app::MachinePeak machine;

/// Additions and multiplications of one point-update of MUSL and FLIP, counted in moving_scatter.hpp,
/// moving_gather.hpp, moving_strain.hpp and moving_nodes.hpp for the tile of N x N nodes with four points in
/// it: weights in each of the three sweeps; mass, momentum and force to the nodes; the change of velocity and
/// the new momentum; the velocity gradient with stress and both tests, the new place; the sums at the nodes.
double operations(mpm::Shape shape) {
  const bool linear = shape == mpm::Shape::linear;
  const double n = linear ? 2 : 3;
  const double nodes = n * n;
  const double weights = linear ? 2 : 2 * 18;  // both axes
  const double value = linear ? 6 : nodes * 2 + n * 2;
  const double slopes = linear ? 4 : 2 * (nodes * 2 + n * 2);
  const double coefficients = linear ? 6 * 4 / 4.0 : 0;  // of six fields, for the points of a tile
  const double scatter = weights + n + nodes * 6 + 6 + n * 4 + nodes * 8;
  const double gather = weights + 2 * value + 2 + 3 + n + nodes * 5;
  const double follow = weights + 2 * slopes + 4 + 53 + 14 + 2 * value + 6;
  const double node_sums = (3 + 2 + 2) * nodes / 4 + 4;
  return scatter + gather + follow + coefficients + node_sums;
}

mpm::Scene scene_of(mpm::Shape shape, mpm::Scheme scheme, mpm::Transfer transfer, int size) {
  mpm::Scene scene = samples::small_concrete(size, size);
  scene.kinematics = mpm::Kinematics::moving;
  scene.motion.shape = shape;
  scene.motion.scheme = scheme;
  scene.motion.transfer = transfer;
  scene.loading.velocity = 0.05;
  // 270 steps at 300 x 300 points, and a row of the history every 10 steps as in the paper's tension test.
  scene.loading.stop_strain = size > 300 ? 1.6e-7 : 1e-5;
  scene.history_rows = size > 300 ? 10 : 27;
  scene.loading.ramp_time = 1e-5;
  return scene;
}

struct Case {
  mpm::Shape shape = mpm::Shape::linear;
  mpm::Scheme scheme = mpm::Scheme::musl;
  mpm::Transfer transfer = mpm::Transfer::flip;
  mpm::Precision precision = mpm::Precision::double_;
  int size = 300;
  int threads = 1;
};

void moving(benchmark::State& state, const Case& one) {
  mpm::Scene scene = scene_of(one.shape, one.scheme, one.transfer, one.size);
  scene.precision = one.precision;
  scene.threads = one.threads;
  double updates = 0;
  double seconds = 0;
  for (auto _ : state) {
    const mpm::Result result = mpm::simulate(scene);
    updates += static_cast<double>(result.points) * static_cast<double>(result.steps);
    seconds += result.wall_time;
    state.SetIterationTime(result.wall_time);
  }
  const double rate = updates / seconds;
  const double peak = one.precision == mpm::Precision::single ? machine.flops_single : machine.flops_double;
  state.counters["Mupdates/s"] = rate / 1e6;
  if (one.scheme == mpm::Scheme::musl && one.transfer == mpm::Transfer::flip)
    state.counters["%peak"] = 100 * rate * operations(one.shape) / (peak * one.threads);
}

void registered(const std::string& name, const Case& one) {
  benchmark::RegisterBenchmark(name.c_str(), moving, one)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond)
      ->Iterations(1)
      ->Repetitions(5)
      ->ReportAggregatesOnly(true);
}

}  // namespace

int main(int argc, char** argv) {
  machine = app::measure_machine_peak();
  std::printf("machine, one core: %.1f GFlop/s in 64 bits, %.1f in 32 bits (multiply-adds), copy %.1f GB/s\n",
              machine.flops_double / 1e9, machine.flops_single / 1e9, machine.copy_bandwidth / 1e9);
  using mpm::Shape;
  registered("linear", {});
  registered("gimp", {.shape = Shape::gimp});
  registered("bspline", {.shape = Shape::bspline});
  registered("linear/single", {.precision = mpm::Precision::single});
  registered("gimp/single", {.shape = Shape::gimp, .precision = mpm::Precision::single});
  registered("linear/usl", {.scheme = mpm::Scheme::usl});
  registered("linear/usf", {.scheme = mpm::Scheme::usf});
  registered("bspline/usl/apic",
             {.shape = Shape::bspline, .scheme = mpm::Scheme::usl, .transfer = mpm::Transfer::apic});
  registered("linear/2_threads", {.threads = 2});
  registered("gimp/2_threads", {.shape = Shape::gimp, .threads = 2});
  registered("linear/large", {.size = 1200});
  registered("linear/large/2_threads", {.size = 1200, .threads = 2});
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
