#include "libmpm/simulate.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "libmpm/instruction_set.hpp"
#include "libmpm/lattice_solver.hpp"
#include "libmpm/plan.hpp"

namespace mpm {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::int64_t count_points(const Scene& scene) {
  const auto solid = [&](std::uint8_t label) { return scene.phases[label].has_value(); };
  std::int64_t points = 0;
  for (const auto label : scene.labels.reshaped()) points += solid(label) ? 1 : 0;
  for (const auto& point : scene.extra_points) points += solid(point.phase) ? 1 : 0;
  return points;
}

HistoryRow history_row(const Scene& scene, double time, const Ledger& ledger) {
  const double sign = scene.loading.direction == Direction::tension ? 1.0 : -1.0;
  HistoryRow row;
  row.time = time;
  row.strain = ledger.platen_displacement / scene.height();
  row.stress_top = sign * ledger.force_top / scene.width();
  row.stress_bottom = -sign * ledger.force_bottom / scene.width();
  row.stress = 0.5 * (row.stress_top + row.stress_bottom);
  row.platen_work = ledger.platen_work;
  row.kinetic = ledger.kinetic;
  row.elastic = ledger.elastic;
  row.released = ledger.released;
  row.damped = ledger.damped;
  row.tension_failures = ledger.tension_failures;
  row.shear_failures = ledger.shear_failures;
  return row;
}

double imbalance(const HistoryRow& row) {
  return std::abs(row.platen_work - row.kinetic - row.elastic - row.released - row.damped);
}

/// Kinetic, elastic and damped energy are none of them negative, and together no more than the work of the
/// platens. In an unstable step they still add up, but with both signs and without bound: nodes that turn
/// round at every step have a negative kinetic energy (the product of two successive velocities) beside an
/// elastic one that grows as fast. The factor leaves room for rounding, for the first order of the damped
/// energy, and for clipped cracks, which make energy (more than the work in what is released, so that this is
/// no part of the sum).
bool makes_energy(const HistoryRow& row) {
  const double energy = std::abs(row.kinetic) + std::abs(row.elastic) + std::abs(row.damped);
  return !(energy <= 10 * std::abs(row.platen_work) + 1e-30);  // not-a-number is no energy either
}

void add_row(Result& result, const HistoryRow& row) {
  result.history.push_back(row);
  if (row.stress > result.peak_stress) {
    result.peak_stress = row.stress;
    result.peak_strain = row.strain;
  }
  result.tension_failures = row.tension_failures;
  result.shear_failures = row.shear_failures;
}

void close_ledger(Result& result) {
  double largest_work = 0;
  double largest_imbalance = 0;
  for (const HistoryRow& row : result.history) {
    largest_work = std::max(largest_work, std::abs(row.platen_work));
    largest_imbalance = std::max(largest_imbalance, imbalance(row));
  }
  result.energy_error = largest_work > 0 ? largest_imbalance / largest_work : 0;
}

std::string divergence_message(const Plan& plan, std::int64_t step, const char* what) {
  char text[256];
  std::snprintf(text, sizeof text,
                "%s at step %lld (time %.4g s): the time step of %.4g s is too long for this specimen; "
                "try a smaller solver.cfl",
                what, static_cast<long long>(step), static_cast<double>(step) * plan.dt, plan.dt);
  return text;
}

template <class Real>
Result run(const Scene& scene, const Plan& plan, const Observer& observer) {
  LatticeSolver<Real> solver(scene, plan);
  Result result;
  result.points = count_points(scene);
  result.dt = plan.dt;
  result.instruction_set = chosen_kernels(scene.instruction_set).name;
  result.history.reserve(static_cast<std::size_t>(plan.steps / plan.steps_per_row + 2));
  add_row(result, HistoryRow{});

  const auto start = Clock::now();
  const auto finish = [&] {
    result.wall_time = seconds_since(start);
    solver.take_maps(result);
    close_ledger(result);
  };
  // The state that a step begins with is the one it reports, so the last step is one past the strain asked
  // for.
  while (result.steps <= plan.steps) {
    const std::int64_t steps = std::min(plan.steps_per_row, plan.steps + 1 - result.steps);
    const Ledger ledger = solver.advance(steps);
    result.steps += steps;
    const HistoryRow row = history_row(scene, static_cast<double>(result.steps - 1) * plan.dt, ledger);
    if (ledger.diverged_at >= 0 || makes_energy(row)) {
      finish();
      throw Diverged(ledger.diverged_at >= 0
                         ? divergence_message(plan, ledger.diverged_at, "stress is not a number")
                         : divergence_message(plan, result.steps, "energy grows without work"),
                     std::move(result));
    }
    add_row(result, row);
    // Before the ramp ends the waves of the start are no peak.
    if (scene.loading.stop_drop && row.time > plan.ramp_time &&
        row.stress < *scene.loading.stop_drop * result.peak_stress) {
      result.stop = StopReason::drop;
      break;
    }
    if (observer &&
        !observer({row, std::min(1.0, row.strain / scene.loading.stop_strain), seconds_since(start)})) {
      result.stop = StopReason::interrupted;
      break;
    }
  }
  finish();
  return result;
}

}  // namespace

Result simulate(const Scene& scene, const Observer& observer) {
  const Plan decided = plan(scene);
  return scene.precision == Precision::single ? run<float>(scene, decided, observer)
                                              : run<double>(scene, decided, observer);
}

}  // namespace mpm
