#include "libmpm/run/run_history.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "libmpm/solver/lattice/cell_limit.hpp"
#include "libmpm/solver/moving_start.hpp"

namespace mpm {
namespace {

std::string rounded(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

/// Rounded down, so that what is said to be safe is.
double two_digits_below(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::floor(value / unit + 1e-9) * unit;
}

std::string cure(const Scene& scene, const Plan& plan, const Divergence& divergence) {
  const std::string text =
      "the time step of " + rounded(divergence.dt, 4) + " s is too long for this specimen; ";
  const double limit = divergence.moving ? Phase::unbreakable : cell_limit(scene, plan);
  if (divergence.dt < limit) return text + "try a smaller solver.cfl";
  return text + "try a smaller solver.cfl: " + rounded(two_digits_below(scene.cfl * limit / plan.dt), 2) +
         " is safe for each of its cells";
}

}  // namespace

std::string divergence_text(const Scene& scene, const Plan& plan, const Divergence& divergence) {
  std::string text = divergence.what + " at step " + std::to_string(divergence.step) + " (time " +
                     rounded(divergence.time, 4) + " s)";
  if (!divergence.point.empty()) text += ", worst at " + divergence.point;
  return text + ": " + cure(scene, plan, divergence);
}

namespace {

/// Without platens the strain is nominal: what the flight of the specimen would have made of its height.
double strain_of(const Scene& scene, const Ledger& ledger) {
  const Loading& loading = scene.loading;
  const double shortening =
      loading.direction == Direction::none
          ? ledger.time * std::hypot(loading.initial_velocity_x, loading.initial_velocity_y)
          : ledger.platen_displacement;
  return shortening / scene.height();
}

/// Kinetic energy of a specimen in flight [J/m].
double kinetic_energy_at_start(const Scene& scene) {
  double energy = 0;
  for_each_start_point(scene, [&](const StartPoint& point) {
    energy += 0.5 * point.mass * (point.vx * point.vx + point.vy * point.vy);
  });
  return energy;
}

/// Energy that came in from outside, at the start and since [J/m].
double energy_put_in(const HistoryRow& row, const HistoryRow& first) {
  return row.platen_work + first.kinetic;
}

double imbalance(const HistoryRow& row, const HistoryRow& first) {
  return std::abs(energy_put_in(row, first) - row.kinetic - row.elastic - row.released - row.damped -
                  row.left);
}

}  // namespace

HistoryRow first_row(const Scene& scene) {
  HistoryRow rest;
  if (scene.loading.direction == Direction::none) rest.kinetic = kinetic_energy_at_start(scene);
  return rest;
}

HistoryRow history_row(const Scene& scene, const Ledger& ledger) {
  const double sign = scene.loading.direction == Direction::tension ? 1.0 : -1.0;
  HistoryRow row;
  row.time = ledger.time;
  row.strain = strain_of(scene, ledger);
  row.stress_top = sign * ledger.force_top / scene.width();
  row.stress_bottom = -sign * ledger.force_bottom / scene.width();
  const bool flies = scene.loading.direction == Direction::none;  // then one wall is hit at a time
  row.stress = (flies ? 1.0 : 0.5) * (row.stress_top + row.stress_bottom);
  row.platen_work = ledger.platen_work;
  row.kinetic = ledger.kinetic;
  row.elastic = ledger.elastic;
  row.released = ledger.released;
  row.damped = ledger.damped;
  row.left = ledger.left;
  row.left_points = ledger.left_points;
  row.tension_failures = ledger.tension_failures;
  row.shear_failures = ledger.shear_failures;
  return row;
}

namespace {

/// What counts of a row for the peak [Pa]. A specimen that flies hits one wall at a time.
double stress_for_peak(const HistoryRow& row, Direction direction) {
  const bool counts_whole = direction == Direction::none || platen_imbalance(row) <= balanced;
  return counts_whole ? row.stress : std::min(row.stress_top, row.stress_bottom);
}

}  // namespace

void add_row(Result& result, const HistoryRow& row, Direction direction) {
  result.history.push_back(row);
  if (const double stress = stress_for_peak(row, direction); stress > result.peak_stress) {
    result.peak_stress = stress;
    result.peak_strain = row.strain;
  }
  result.tension_failures = row.tension_failures;
  result.shear_failures = row.shear_failures;
}

namespace {

/// Strain of the platens at which a phase alone would fail, but for the scatter of strengths [-].
double failure_strain_of(const Phase& phase, Direction direction) {
  const bool crushes = direction == Direction::compression && phase.can_shear();
  return (crushes ? phase.cohesion : phase.tensile_scale) / phase.young;
}

constexpr double least_share = 1.0 / 9;  ///< of that strain at which specimens reach their peak [-]
constexpr double rows_to_peak = 0.2;     ///< of the rows of the history [-]

}  // namespace

double early_strain(const Scene& scene) {
  if (scene.loading.direction == Direction::none) return 0;
  double least = Phase::unbreakable;
  for (const auto& phase : scene.phases)
    if (phase && phase->can_fail())
      least = std::min(least, failure_strain_of(*phase, scene.loading.direction));
  return std::isfinite(least) ? least_share * least : 0;
}

std::int64_t steps_to_next_row(const Scene& scene, const Plan& plan, double early, double strain) {
  if (early <= 0 || plan.steps_per_row == 1) return plan.steps_per_row;
  const double increment = std::max(early, strain) / (rows_to_peak * scene.history_rows);
  const double steps = increment * scene.height() / (scene.loading.velocity * plan.dt);
  return steps < static_cast<double>(plan.steps_per_row)
             ? std::max<std::int64_t>(1, static_cast<std::int64_t>(steps))
             : plan.steps_per_row;
}

double next_frame(int count, double early, double done) {
  const double closer = std::max(early, done) / rows_to_peak;
  return early > 0 && closer < 1 ? done * count + closer : std::floor(done * count) + 1;
}

double share_done(const Scene& scene, const HistoryRow& row) {
  return scene.loading.direction == Direction::none ? row.time / scene.loading.duration
                                                    : row.strain / scene.loading.stop_strain;
}

/// Kinetic, elastic and damped energy are none of them negative, and together no more than the work of the
/// platens. In an unstable step they still add up, but with both signs and without bound: nodes that turn
/// round at every step have a negative kinetic energy (the product of two successive velocities) beside an
/// elastic one that grows as fast. The factor leaves room for rounding, for the first order of the damped
/// energy, and for clipped cracks, which make energy (more than the work in what is released, so that this is
/// no part of the sum).
bool makes_energy(const HistoryRow& row, const HistoryRow& first) {
  const double energy = std::abs(row.kinetic) + std::abs(row.elastic) + std::abs(row.damped);
  return !(energy <= 10 * std::abs(energy_put_in(row, first)) + 1e-30);  // not-a-number is no energy either
}

void close_ledger(Result& result) {
  double largest_work = 0;
  double largest_imbalance = 0;
  for (const HistoryRow& row : result.history) {
    largest_work = std::max(largest_work, std::abs(energy_put_in(row, result.history.front())));
    largest_imbalance = std::max(largest_imbalance, imbalance(row, result.history.front()));
  }
  result.energy_error = largest_work > 0 ? largest_imbalance / largest_work : 0;
}

}  // namespace mpm
