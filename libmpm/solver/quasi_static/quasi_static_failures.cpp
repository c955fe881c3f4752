// Which point fails next, and what becomes of it.
#include <algorithm>
#include <cmath>
#include <limits>

#include "libmpm/material/softening.hpp"
#include "libmpm/solver/quasi_static/quasi_static_solver.hpp"

namespace mpm {
namespace {

constexpr double no_strain = std::numeric_limits<double>::infinity();  ///< a point fails at none
constexpr double rounding = 1e-5;                                      ///< of the utilisation of a row [-]
/// Share of its stiffness that a failed point keeps, so that what has come loose stays where it is.
constexpr double remainder = 1e-6;

}  // namespace

const QuasiStaticSolver::Limits& QuasiStaticSolver::limits_at(const Place& at) const {
  return limits_[*equilibrium_.label(at)];
}

/// Stress of an intact point at a platen strain, with its sign [Pa].
Stress<double> QuasiStaticSolver::elastic_at(const Limits& limits, const Place& at, double strain) const {
  const auto [xi, eta] = equilibrium_.in_cell(at);
  Stress<double> s =
      stress_in_cell(limits.stiffness, equilibrium_.displacement(at.row, at.cell), xi, eta, plan_.cell_size);
  for (double* one : {&s.xx, &s.yy, &s.xy}) *one *= sign_ * strain;
  return s;
}

/// Platen strain at which the point fails that carries this stress at a platen strain of 1.
QuasiStaticSolver::Onset QuasiStaticSolver::onset_of(const Limits& limits, double factor, const Left& left,
                                                     const Stress<double>& s) {
  const PrincipalStress principal = principal_stress(s.xx, s.yy, s.xy, limits.normal * (s.xx + s.yy));
  const double first = std::max(principal.first, principal.normal);
  const double last = std::min(principal.second, principal.normal);
  const double tension = first > 0 ? left.strength / first : no_strain;
  const double drive = -last * (1 - limits.sine) + factor * first * (1 + limits.sine);
  const double shear = last < 0 && drive > 0 ? factor * left.cohesion * limits.cohesion / drive : no_strain;
  return tension <= shear ? Onset{tension, FailureMode::tension} : Onset{shear, FailureMode::shear};
}

double QuasiStaticSolver::strength_at(const Place& at, std::size_t index) const {
  return strengths_.empty() ? limits_at(at).tension * factors_[index] : strengths_[index];
}

QuasiStaticSolver::Left QuasiStaticSolver::left_at(const Place& at, std::size_t index) const {
  return {strength_at(at, index), cohesions_.empty() ? 1 : cohesions_[index]};
}

PointState QuasiStaticSolver::state_at(const Place& at, std::size_t index) const {
  return {.phase = &*scene_.phases[*equilibrium_.label(at)],
          .factor = factors_[index],
          .strength = strength_at(at, index),
          .kept = equilibrium_.kept(at),
          .cracked = equilibrium_.cracked(at),
          .spent = factors_[index] <= 0};
}

/// @pre the point can fail.
QuasiStaticSolver::Onset QuasiStaticSolver::onset_at(const Place& at, std::size_t index) const {
  const Limits& limits = limits_at(at);
  Stress<double> s = elastic_at(limits, at, 1);
  if (!strengths_.empty()) s = carried_stress(state_at(at, index), s, law_);
  return onset_of(limits, factors_[index], left_at(at, index), s);
}

/// What the search for the next failure asks of a point: never less than the criteria do. It sees the stress
/// times the share that the point has of its pixel.
void QuasiStaticSolver::set_resistance(const Place& at, std::size_t index) {
  if (equilibrium_.is_extra(at)) return;
  const Limits& limits = limits_at(at);
  const double factor = factors_[index];
  const double share = equilibrium_.share(at);
  const Left left = left_at(at, index);
  double tension = factor > 0 ? 1 / (share * left.strength) : 0;
  double crush = factor > 0 ? (1 - limits.sine) / (share * factor * limits.cohesion) : 0;
  if (factor > 0 && left.cohesion < 1) {
    // Of a shear band s1 takes more than crush_share says; a sum is no more than twice its larger part.
    tension = std::max(tension, 2 * (1 + limits.sine) / (share * left.cohesion * limits.cohesion));
    crush *= 2 / left.cohesion;
  }
  resistance_.tension[index] = static_cast<float>(tension);
  resistance_.crush[index] = static_cast<float>(crush);
  if (limits.cohesion > 0)
    resistance_.crush_share =
        std::max(resistance_.crush_share, (1 + limits.sine) / (share * limits.cohesion));
}

/// Visits every point that can fail up to a strain, and others.
template <class Visit>
void QuasiStaticSolver::each_point_near(double strain, const Visit& visit) const {
  const double least = (1 - rounding) / strain;
  const auto try_point = [&](const Place& at) {
    if (const std::size_t index = equilibrium_.index(at); factors_[index] > 0) visit(at, index);
  };
  std::size_t i = 0;
  for (int row = 0; row < plan_.cells_y; ++row) {
    for (int plane = 0; plane < equilibrium_.points().planes; ++plane, ++i)
      for (int cell = 0; cell < plan_.cells_x && utilisations_[i] >= least; ++cell)
        try_point({row, plane, cell});
    if (utilisations_[i++] >= least) equilibrium_.each_extra(row, try_point);
  }
}

void QuasiStaticSolver::find_utilisations(int row) {
  const int planes = equilibrium_.points().planes;
  double* largest = utilisations_.data() + static_cast<std::ptrdiff_t>(row) * (planes + 1);
  for (int plane = 0; plane < planes; ++plane)
    largest[plane] = equilibrium_.largest_utilisation(row, plane, resistance_, sign_);
  largest[planes] = 0;
  equilibrium_.each_separate(row, [&](const SeparatePoints::Place& place) {
    if (factors_[place.index] <= 0) return;
    double& of = largest[std::min(place.at.plane, planes)];
    of = std::max(of, 1 / onset_at(place.at, place.index).strain);
  });
}

/// The onset of a point is looked at where its row may have the next one.
void QuasiStaticSolver::find_onsets() {
  equilibrium_.each_row([&](int row) { find_utilisations(row); });
  const double largest = *std::max_element(utilisations_.begin(), utilisations_.end());
  next_ = no_strain;
  if (!(largest > 0)) return;
  // The row with the largest utilisation has a point that fails not much later, whatever the others do.
  const auto take = [&](const Place& at, std::size_t index) {
    next_ = std::min(next_, onset_at(at, index).strain);
  };
  each_point_near(1 / largest, take);
  each_point_near(next_, take);
}

/// Only the first failure of a point counts, and that its crack is crushed. Where the platens went back, the
/// order of the failures is that of the largest strains until then.
void QuasiStaticSolver::record(const Place& at, FailureMode mode, double strain) {
  const auto when = static_cast<float>(std::max(strain, farthest_));
  const auto note = [&](float& failure_strain, std::uint8_t& failure_mode, float* crush_strain) {
    const bool is_first = failure_mode == 0;
    if (!is_first && (mode != FailureMode::shear || !closes())) return;
    ++(mode == FailureMode::shear ? tally_.shear_failures : tally_.tension_failures);
    if (is_first) {
      failure_strain = when;
      failure_mode = static_cast<std::uint8_t>(mode);
    } else if (crush_strain != nullptr) {
      *crush_strain = when;
    }
  };
  if (equilibrium_.is_extra(at)) {
    const std::size_t i = equilibrium_.extra(at).index;
    return note(maps_.extra_failure_strain[i], maps_.extra_failure_mode[i], nullptr);
  }
  const Pixel pixel = equilibrium_.pixel(at);
  note(maps_.failure_strain(pixel.row, pixel.col), maps_.failure_mode(pixel.row, pixel.col),
       closes() ? &maps_.crush_strain(pixel.row, pixel.col) : nullptr);
}

PointState QuasiStaticSolver::gone(const Place& at, std::size_t index, FailureMode mode, double strain) {
  PointState point = state_at(at, index);
  if (mode != FailureMode::none) record(at, mode, strain);
  factors_[index] = 0;
  set_resistance(at, index);
  if (scene_.damage.residual_stiffness <= 0) --carrying_;
  point.kept = least_kept();
  point.cracked = 0;
  return point;
}

/// The point is gone, or goes on as a crack that can close, and be crushed then.
PointState QuasiStaticSolver::cracked_through(const Place& at, std::size_t index, double strain) {
  if (!closes()) return gone(at, index, FailureMode::tension, strain);
  PointState point = state_at(at, index);
  record(at, FailureMode::tension, strain);
  if (!point.phase->can_shear()) factors_[index] = 0;
  strengths_[index] = no_strain;
  point.cracked = 1;
  return point;
}

/// The point goes on with less. It counts as failed when half of its strength is lost.
PointState QuasiStaticSolver::softened(const Place& at, std::size_t index, double strain) {
  PointState point = state_at(at, index);
  const Limits& limits = limits_at(at);
  const Stress<double> s = elastic_at(limits, at, strain);
  const double peak = tension_threshold(*point.phase, point.factor);
  const PrincipalStress principal = principal_stress(s.xx, s.yy, s.xy, limits.normal * (s.xx + s.yy));
  // A crack that closes is softened beside what shear takes of the stiffness.
  const double first = std::max(principal.first, principal.normal);
  const Tooth tooth =
      next_tooth(softening(*point.phase, scene_.plane, peak, plan_.cell_size),
                 closes() ? 1 - point.cracked : point.kept, (closes() ? point.kept : 1) * first);
  if (tooth.kept <= least_kept()) return cracked_through(at, index, strain);
  strengths_[index] = tooth.strength;
  if (tooth.strength <= 0.5 * peak) record(at, FailureMode::tension, strain);
  (closes() ? point.cracked : point.kept) = closes() ? 1 - tooth.kept : tooth.kept;
  return point;
}

/// The shear band of the point goes on by a tooth, or is at its end.
PointState QuasiStaticSolver::sheared(const Place& at, std::size_t index, double strain) {
  PointState point = state_at(at, index);
  const Limits& limits = limits_at(at);
  PointState whole = point;
  whole.kept = 1;
  const Stress<double> s = carried_stress(whole, elastic_at(limits, at, strain), law_);
  const double taken = shear_utilisation(*point.phase, point.factor,
                                         principal_stress(s.xx, s.yy, s.xy, limits.normal * (s.xx + s.yy)));
  const Tooth tooth = next_tooth(shear_softening(*point.phase, scene_.plane, point.factor, plan_.cell_size),
                                 point.kept, taken);
  if (cohesions_[index] > 0.5 && tooth.strength <= 0.5) record(at, FailureMode::shear, strain);
  cohesions_[index] = tooth.strength;
  if (tooth.kept <= least_kept()) return gone(at, index, FailureMode::none, strain);
  point.kept = tooth.kept;
  return point;
}

PointState QuasiStaticSolver::failed(const Place& at, std::size_t index, const Onset& onset, double strain) {
  const Phase& phase = *scene_.phases[*equilibrium_.label(at)];
  const double reached = std::max(strain, onset.strain);
  if (onset.mode == FailureMode::shear)
    return !phase.softens_in_shear() ? gone(at, index, FailureMode::shear, strain)
                                     : sheared(at, index, reached);
  return phase.softens() ? softened(at, index, reached) : cracked_through(at, index, strain);
}

double QuasiStaticSolver::least_kept() const { return std::max(scene_.damage.residual_stiffness, remainder); }

void QuasiStaticSolver::fail_points(double strain, double up_to) {
  std::vector<Equilibrium::Change> changes;
  each_point_near(up_to, [&](const Place& at, std::size_t index) {
    const Onset onset = onset_at(at, index);
    if (onset.strain > up_to) return;
    const PointState before = state_at(at, index);
    const PointState after = failed(at, index, onset, strain);
    set_resistance(at, index);
    if (snaps_back()) spent_ += energy_of(at, before) - energy_of(at, after);
    changes.push_back({at, after.kept, after.cracked});
  });
  equilibrium_.change(changes);
}

/// Elastic energy of a point in some state under the strain that it has now [J/m].
double QuasiStaticSolver::energy_of(const Place& at, const PointState& point) const {
  const Limits& limits = limits_at(at);
  const Stress<double> s = elastic_at(limits, at, strain_);
  double density = 0.5 * stress_power(*point.phase, scene_.plane, carried_stress(point, s, law_), s);
  if (scene_.pixel_cells && !equilibrium_.is_extra(at)) {
    const CellDisplacement u = equilibrium_.displacement(at.row, at.cell);
    const double x = strain_ * bending(u.ux, plan_.cell_size);
    const double y = strain_ * bending(u.uy, plan_.cell_size);
    const double kept = point.kept * (1 - point.cracked);
    density += 0.5 * kept * bending_stiffness(limits.stiffness) * (x * x + y * y);
  }
  return equilibrium_.share(at) * density * scene_.pixel_size * scene_.pixel_size;
}

}  // namespace mpm
