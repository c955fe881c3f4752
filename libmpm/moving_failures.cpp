// Failure of moving points, and the energies that they hold.
#include <cmath>

#include "libmpm/failure.hpp"
#include "libmpm/lattice_points.hpp"
#include "libmpm/moving_solver.hpp"
#include "libmpm/strength.hpp"

namespace mpm {

template <class Real>
Stress<double> MovingSolver<Real>::stress_at(const Slot& slot) const {
  const auto value = [&](int field) { return static_cast<double>(points_.value(slot, field)); };
  return {value(moving::sxx), value(moving::syy), value(moving::sxy)};
}

/// Without platens the strain is nominal: what the flight of the specimen would have made of its height.
template <class Real>
double MovingSolver<Real>::nominal_strain() const {
  if (scene_.loading.direction != Direction::none) return std::abs(clock_.displacement) / scene_.height();
  return clock_.time * std::hypot(scene_.loading.initial_velocity_x, scene_.loading.initial_velocity_y) /
         scene_.height();
}

template <class Real>
void MovingSolver<Real>::fail_suspects(Band& band, int row) {
  for (int block = 0; block < points_.blocks(); ++block)
    if (band.flags[static_cast<std::size_t>(block)] != 0)
      points_.for_each_of_block(row, block, [&](const Slot& slot) { fail_point(band, slot); });
}

/// Ends or cracks the point if its phase says so.
template <class Real>
void MovingSolver<Real>::fail_point(Band& band, const Slot& slot) {
  const auto unreachable = static_cast<Real>(kernels::unreachable);
  const moving::RecordLayout& layout = points_.layout();
  const auto reachable = [&](int field) { return field >= 0 && points_.value(slot, field) < unreachable; };
  if (!reachable(layout.tension) && !reachable(layout.crush)) return;
  const PointOrigin origin = origin_of(scene_, points_.id(slot));
  const Phase& phase = *origin.phase;
  const int crack_field = layout.cracked;
  const bool cracked = crack_field >= 0 && points_.value(slot, crack_field) > 0;
  const double factor = strength_factor(origin.random, phase.weibull_modulus);
  const PointState state{&phase, factor, cracked ? scene_.damage.crack_closure : CrackClosure::off};
  const Stress<double> elastic = stress_at(slot);
  const FailureMode mode = judge(state, elastic, scene_.plane);
  if (mode == FailureMode::none) return;

  const bool closes = plan_.features.crack_closure && mode == FailureMode::tension;
  PointState after = state;
  after.crack = closes ? scene_.damage.crack_closure : CrackClosure::off;
  const double kept = closes ? 1.0 : scene_.damage.residual_stiffness;
  const auto power = [&](const PointState& point) {
    return stress_power(phase, scene_.plane, carried_stress(point, elastic, scene_.plane), elastic);
  };
  band.tally.released +=
      0.5 * (power(state) - kept * power(after)) * static_cast<double>(points_.value(slot, moving::volume));
  ++(mode == FailureMode::tension ? band.tally.tension_failures : band.tally.shear_failures);
  for (const int threshold : {layout.tension, layout.crush})
    if (threshold >= 0) points_.value(slot, threshold) = unreachable;
  if (closes) {
    points_.value(slot, crack_field) = 1;
    points_.value(slot, layout.crush) = static_cast<Real>(stored_threshold(shear_onset(phase, factor, 0), 1));
  } else {
    for (const int field : {moving::sxx, moving::syy, moving::sxy, moving::lame, moving::shear})
      points_.value(slot, field) *= static_cast<Real>(kept);
    if (crack_field >= 0) points_.value(slot, crack_field) = 0;
    if (kept == 0) ++band.failed[origin.label];
  }
  record_failure(origin, cracked, mode);
}

template <class Real>
void MovingSolver<Real>::record_failure(const PointOrigin& origin, bool cracked, FailureMode mode) {
  const auto strain = static_cast<float>(nominal_strain());
  if (origin.row < 0) {
    if (cracked) return;
    maps_.extra_failure_strain[origin.extra] = strain;
    maps_.extra_failure_mode[origin.extra] = static_cast<std::uint8_t>(mode);
  } else if (cracked) {
    maps_.crush_strain(origin.row, origin.col) = strain;
  } else {
    maps_.failure_strain(origin.row, origin.col) = strain;
    maps_.failure_mode(origin.row, origin.col) = static_cast<std::uint8_t>(mode);
  }
}

template <class Real>
Ledger MovingSolver<Real>::balance() {
  Ledger ledger;
  ledger.time = reported_time_;
  ledger.platen_displacement = std::abs(reported_displacement_);
  ledger.force_top = force_top_;
  ledger.force_bottom = force_bottom_;
  ledger.platen_work = sums_.platen_work;
  ledger.released = sums_.released;
  ledger.damped = start_.damped;
  for (const double damped : row_damped_) ledger.damped += damped;
  ledger.left = left_energy_;
  ledger.left_points = left_;
  ledger.tension_failures = sums_.tension_failures;
  ledger.shear_failures = sums_.shear_failures;
  for (int row = 0; row < points_.rows(); ++row) {
    const moving::Energies energies = sweeps_.measure_energies(tiles(row), step_);
    ledger.kinetic += energies.kinetic;
    ledger.elastic += energies.elastic;
  }
  if (!std::isfinite(ledger.kinetic + ledger.elastic + force_top_ + force_bottom_))
    ledger.diverged_at = clock_.step;
  ledger.trouble = failure_;
  return ledger;
}

template class MovingSolver<float>;
template class MovingSolver<double>;

}  // namespace mpm
