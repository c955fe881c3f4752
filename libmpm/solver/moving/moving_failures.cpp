// Failure of moving points, and the energies that they hold.
#include <cmath>
#include <numeric>

#include "libmpm/material/failure.hpp"
#include "libmpm/material/strength.hpp"
#include "libmpm/solver/moving/moving_solver.hpp"
#include "libmpm/solver/threshold.hpp"

namespace mpm {

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
    if ((band.flags[static_cast<std::size_t>(block)] & moving::may_fail) != 0)
      points_.for_each_of_block(row, block, [&](const Slot& slot) { fail_point(band, slot); });
}

template <class Real>
PointState MovingSolver<Real>::read_state(const Slot& slot, const PointOrigin& origin) const {
  const moving::RecordLayout& layout = points_.layout();
  const auto value = [&](int field) { return static_cast<double>(points_.value(slot, field)); };
  const Real intact = static_cast<Real>(stiffness(*origin.phase, scene_.plane)(2, 2));
  PointState point = intact_point(*origin.phase, factor_of(factors_, origin));
  point.kept = value(moving::shear) / static_cast<double>(intact);
  point.cracked = layout.cracked >= 0 ? value(layout.cracked) : 0;
  if (layout.tension < 0 || !(value(layout.tension) < static_cast<double>(kernels::unreachable)))
    point.strength = Phase::unbreakable;
  else if (point.kept < 1 || point.cracked > 0)
    point.strength = value(layout.tension);
  return point;
}

/// Does to the point what its phase says.
template <class Real>
void MovingSolver<Real>::fail_point(Band& band, const Slot& slot) {
  const auto unreachable = static_cast<Real>(kernels::unreachable);
  const moving::RecordLayout& layout = points_.layout();
  const auto reachable = [&](int field) { return field >= 0 && points_.value(slot, field) < unreachable; };
  if (!reachable(layout.tension) && !reachable(layout.crush)) return;
  const PointOrigin origin = origin_of(scene_, points_.id(slot));
  const PointState before = read_state(slot, origin);
  const auto intact_stress = [&](int field) {
    return static_cast<double>(points_.value(slot, field)) / before.kept;
  };
  const Stress<double> elastic{intact_stress(moving::sxx), intact_stress(moving::syy),
                               intact_stress(moving::sxy)};
  const Response response = respond(before, elastic, law_);
  if (!response.changed) return;

  write_state(response.point, &points_.value(slot, 0), points_.lanes());
  const double share = response.point.kept / before.kept;
  for (const int field : {moving::sxx, moving::syy, moving::sxy, moving::lame, moving::shear})
    points_.value(slot, field) *= static_cast<Real>(share);
  const auto power = [&](const PointState& point) {
    return stress_power(*point.phase, scene_.plane, carried_stress(point, elastic, law_), elastic);
  };
  row_released_[static_cast<std::size_t>(slot.row)] +=
      0.5 * (power(before) - power(read_state(slot, origin))) *
      static_cast<double>(points_.value(slot, moving::volume));
  if (response.point.kept == 0) ++band.failed[origin.label];
  if (response.failure == FailureMode::none) return;
  ++(response.failure == FailureMode::tension ? band.tension_failures : band.shear_failures);
  record_failure(origin, response.failure);
}

/// A point that failed before can only be crushed.
template <class Real>
void MovingSolver<Real>::record_failure(const PointOrigin& origin, FailureMode mode) {
  const auto strain = static_cast<float>(nominal_strain());
  const auto code = static_cast<std::uint8_t>(mode);
  if (origin.row < 0) {
    if (maps_.extra_failure_mode[origin.extra] != 0) return;
    maps_.extra_failure_strain[origin.extra] = strain;
    maps_.extra_failure_mode[origin.extra] = code;
  } else if (maps_.failure_mode(origin.row, origin.col) == 0) {
    maps_.failure_strain(origin.row, origin.col) = strain;
    maps_.failure_mode(origin.row, origin.col) = code;
  } else if (maps_.crush_strain.size() > 0) {
    maps_.crush_strain(origin.row, origin.col) = strain;
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
  ledger.released = start_.released;
  for (const double released : row_released_) ledger.released += released;
  ledger.damped = start_.damped;
  for (const double damped : row_damped_) ledger.damped += damped;
  ledger.left = left_energy_;
  ledger.left_points = left_;
  ledger.carrying_points = std::accumulate(live_.begin(), live_.end(), std::int64_t{0});
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

template <class Real>
std::string MovingSolver<Real>::worst_point() const {
  double most = 0;
  std::uint32_t worst = 0;
  for (const PointView& point : points()) {
    const PointOrigin origin = origin_of(scene_, point.id);
    const double speed = point.vx * point.vx + point.vy * point.vy;
    const double energy =
        speed + stress_power(*origin.phase, scene_.plane, point.stress, point.stress) / origin.phase->density;
    if (energy <= most) continue;
    worst = point.id;
    if (!std::isfinite(energy)) return name_of_point(scene_, worst);
    most = energy;
  }
  return most > 0 ? name_of_point(scene_, worst) : std::string();
}

template class MovingSolver<float>;
template class MovingSolver<double>;

}  // namespace mpm
