#include "libmpm/solver/quasi_static/quasi_static_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "libmpm/material/failure.hpp"

namespace mpm {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double reduction = 1e-3;  ///< of the error that the last failures have added
constexpr double rounding = 1e-5;   ///< of the utilisation of a row [-]
/// Share of its stiffness that a failed point keeps, so that what has come loose stays where it is.
constexpr double remainder = 1e-6;

PixelField<double> drawn_factors(const Scene& scene) {
  const StrengthFactors drawn(scene, false);
  PixelField<double> factors = PixelField<double>::Zero(scene.labels.rows(), scene.labels.cols());
  for (int row = 0; row < scene.labels.rows(); ++row)
    for (int col = 0; col < scene.labels.cols(); ++col) {
      const auto& phase = scene.phases[scene.labels(row, col)];
      if (phase && phase->can_fail()) factors(row, col) = drawn.of_pixel(row, col);
    }
  return factors;
}

}  // namespace

QuasiStaticSolver::QuasiStaticSolver(const Scene& scene, const Plan& plan)
    : QuasiStaticSolver(scene, plan, drawn_factors(scene)) {}

QuasiStaticSolver::QuasiStaticSolver(const Scene& scene, const Plan& plan, const PixelField<double>& factors)
    : scene_(scene),
      plan_(plan),
      equilibrium_(scene, plan, StrengthFactors(scene, false)),
      maps_(empty_maps(scene, plan)),
      sign_(scene.loading.direction == Direction::tension ? 1.0 : -1.0),
      carrying_(count_points(scene)) {
  for (const auto& phase : scene.phases) {
    Limits limits;
    if (phase)
      limits = {stiffness(*phase, scene.plane), scene.plane == Plane::strain ? phase->poisson : 0,
                phase->can_crack() ? phase->tensile_scale : never, std::sin(phase->friction_angle),
                phase->can_shear() ? 2 * phase->cohesion * std::cos(phase->friction_angle) : never};
    limits_.push_back(limits);
  }
  const LatticePoints<double>& points = equilibrium_.points();
  factors_.assign(points.stiffness.size(), 0.0);
  resistance_.tension.assign(points.stiffness.size(), 0.0F);
  resistance_.crush.assign(points.stiffness.size(), 0.0F);
  for (const Limits& limits : limits_)
    if (limits.cohesion > 0)
      resistance_.crush_share = std::max(resistance_.crush_share, (1 + limits.sine) / limits.cohesion);
  utilisations_.assign(static_cast<std::size_t>(plan.cells_y * points.planes), 0.0);
  if (plan.softens) strengths_.assign(points.stiffness.size(), never);
  each_point([&](const Place& at, std::size_t index) {
    const std::uint8_t* label = equilibrium_.label(at.row, at.plane, at.cell);
    if (label == nullptr || !scene.phases[*label]->can_fail()) return;
    const Pixel pixel = equilibrium_.pixel(at.row, at.plane, at.cell);
    factors_[index] = factors(pixel.row, pixel.col);
    if (plan.softens) strengths_[index] = limits_[*label].tension * factors_[index];
    set_resistance(at, index);
  });
}

const QuasiStaticSolver::Limits& QuasiStaticSolver::limits_at(const Place& at) const {
  return limits_[*equilibrium_.label(at.row, at.plane, at.cell)];
}

/// Stress of an intact point at a platen strain, with its sign [Pa].
Stress<double> QuasiStaticSolver::elastic_at(const Limits& limits, const Place& at, double strain) const {
  const int k = scene_.points_per_cell;
  Stress<double> s = stress_in_cell(limits.stiffness, equilibrium_.displacement(at.row, at.cell),
                                    (at.plane % k + 0.5) / k, (at.plane / k + 0.5) / k, plan_.cell_size);
  for (double* one : {&s.xx, &s.yy, &s.xy}) *one *= sign_ * strain;
  return s;
}

/// Platen strain at which the point fails that carries this stress at a platen strain of 1.
/// @param strength  largest principal stress that it survives [Pa].
QuasiStaticSolver::Onset QuasiStaticSolver::onset_of(const Limits& limits, double factor, double strength,
                                                     const Stress<double>& s) {
  const PrincipalStress principal = principal_stress(s.xx, s.yy, s.xy, limits.normal * (s.xx + s.yy));
  const double first = std::max(principal.first, principal.normal);
  const double last = std::min(principal.second, principal.normal);
  const double tension = first > 0 ? strength / first : never;
  const double drive = -last * (1 - limits.sine) + factor * first * (1 + limits.sine);
  const double shear = last < 0 && drive > 0 ? factor * limits.cohesion / drive : never;
  return tension <= shear ? Onset{tension, FailureMode::tension} : Onset{shear, FailureMode::shear};
}

double QuasiStaticSolver::kept_at(const Place& at) const {
  return strengths_.empty() ? 1 : equilibrium_.kept(at.row, at.plane, at.cell);
}

/// @pre the point can fail.
QuasiStaticSolver::Onset QuasiStaticSolver::onset_at(const Place& at, std::size_t index) const {
  const Limits& limits = limits_at(at);
  const double strength = strengths_.empty() ? limits.tension * factors_[index] : strengths_[index];
  const double kept = kept_at(at);
  const Stress<double> s = elastic_at(limits, at, 1);
  return onset_of(limits, factors_[index], strength, {kept * s.xx, kept * s.yy, kept * s.xy});
}

/// What the search for the next failure asks of a point: never less than the criteria do.
void QuasiStaticSolver::set_resistance(const Place& at, std::size_t index) {
  const Limits& limits = limits_at(at);
  const double factor = factors_[index];
  const double strength = strengths_.empty() ? limits.tension * factor : strengths_[index];
  resistance_.tension[index] = static_cast<float>(factor > 0 ? 1 / strength : 0);
  resistance_.crush[index] =
      static_cast<float>(factor > 0 ? (1 - limits.sine) / (factor * limits.cohesion) : 0);
}

/// Visits every point that can fail up to a strain, and others.
template <class Visit>
void QuasiStaticSolver::each_point_near(double strain, const Visit& visit) const {
  const LatticePoints<double>& points = equilibrium_.points();
  const double least = (1 - rounding) / strain;
  std::size_t i = 0;
  for (int row = 0; row < plan_.cells_y; ++row)
    for (int plane = 0; plane < points.planes; ++plane, ++i)
      for (int cell = 0; cell < plan_.cells_x && utilisations_[i] >= least; ++cell)
        if (const std::size_t index = points.at(row, plane, cell); factors_[index] > 0)
          visit(Place{row, plane, cell}, index);
}

/// The onset of a point is looked at where its row may have the next one.
void QuasiStaticSolver::find_onsets() {
  const int planes = equilibrium_.points().planes;
  equilibrium_.each_row([&](int row) {
    for (int plane = 0; plane < planes; ++plane)
      utilisations_[static_cast<std::size_t>(row * planes + plane)] =
          equilibrium_.largest_utilisation(row, plane, resistance_, sign_);
  });
  const double largest = *std::max_element(utilisations_.begin(), utilisations_.end());
  next_ = never;
  if (!(largest > 0)) return;
  // The row with the largest utilisation has a point that fails not much later, whatever the others do.
  const auto take = [&](const Place& at, std::size_t index) {
    next_ = std::min(next_, onset_at(at, index).strain);
  };
  each_point_near(1 / largest, take);
  each_point_near(next_, take);
}

double QuasiStaticSolver::energy() const {
  return 0.5 * modulus_ * strain_ * strain_ * scene_.width() * scene_.height();
}

/// The platens move to another strain while nothing fails.
void QuasiStaticSolver::add_work(double strain) {
  const double before = energy();
  strain_ = strain;
  farthest_ = std::max(farthest_, strain);
  tally_.platen_work += energy() - before;
}

/// Only the first failure of a point counts. Where the platens went back, the order of the failures is that
/// of the largest strains until then.
void QuasiStaticSolver::record(const Place& at, FailureMode mode, double strain) {
  strain = std::max(strain, farthest_);
  const Pixel pixel = equilibrium_.pixel(at.row, at.plane, at.cell);
  if (maps_.failure_mode(pixel.row, pixel.col) != 0) return;
  ++(mode == FailureMode::shear ? tally_.shear_failures : tally_.tension_failures);
  maps_.failure_strain(pixel.row, pixel.col) = static_cast<float>(strain);
  maps_.failure_mode(pixel.row, pixel.col) = static_cast<std::uint8_t>(mode);
}

/// The point is gone.   @return the share of its stiffness that it keeps.
double QuasiStaticSolver::fail(const Place& at, std::size_t index, FailureMode mode, double strain) {
  record(at, mode, strain);
  factors_[index] = 0;
  set_resistance(at, index);
  if (scene_.damage.residual_stiffness <= 0) --carrying_;
  return least_kept();
}

/// The point goes on with less. It counts as failed when half of its strength is lost.
/// @return the share of its stiffness that it keeps.
double QuasiStaticSolver::soften(const Place& at, std::size_t index, double strain) {
  const Limits& limits = limits_at(at);
  const Phase& phase = *scene_.phases[*equilibrium_.label(at.row, at.plane, at.cell)];
  const Stress<double> s = elastic_at(limits, at, strain);
  const double peak = tension_threshold(phase, factors_[index]);
  const PrincipalStress principal = principal_stress(s.xx, s.yy, s.xy, limits.normal * (s.xx + s.yy));
  const Tooth tooth = next_tooth(softening(phase, scene_.plane, peak, plan_.cell_size), kept_at(at),
                                 std::max(principal.first, principal.normal));
  if (tooth.kept <= least_kept()) return fail(at, index, FailureMode::tension, strain);
  strengths_[index] = tooth.strength;
  set_resistance(at, index);
  if (tooth.strength <= 0.5 * peak) record(at, FailureMode::tension, strain);
  return tooth.kept;
}

double QuasiStaticSolver::least_kept() const { return std::max(scene_.damage.residual_stiffness, remainder); }

void QuasiStaticSolver::fail_points(double strain, double up_to) {
  std::vector<Equilibrium::Change> changes;
  each_point_near(up_to, [&](const Place& at, std::size_t index) {
    const Onset onset = onset_at(at, index);
    if (onset.strain > up_to) return;
    const bool softens = onset.mode == FailureMode::tension &&
                         scene_.phases[*equilibrium_.label(at.row, at.plane, at.cell)]->softens();
    const double before = kept_at(at);
    const double kept =
        softens ? soften(at, index, std::max(strain, onset.strain)) : fail(at, index, onset.mode, strain);
    if (snaps_back()) spent_ += (before - kept) * energy_of(at);
    changes.push_back({at.row, at.plane, at.cell, kept});
  });
  equilibrium_.change(changes);
}

/// Elastic energy of an intact point under the strain that it has now [J/m].
double QuasiStaticSolver::energy_of(const Place& at) const {
  const std::uint8_t label = *equilibrium_.label(at.row, at.plane, at.cell);
  const Stress<double> s = elastic_at(limits_[label], at, strain_);
  double density = 0.5 * stress_power(*scene_.phases[label], scene_.plane, s, s);
  if (scene_.pixel_cells) {
    const CellDisplacement u = equilibrium_.displacement(at.row, at.cell);
    const double x = strain_ * bending(u.ux, plan_.cell_size);
    const double y = strain_ * bending(u.uy, plan_.cell_size);
    density += 0.5 * bending_stiffness(limits_[label].stiffness) * (x * x + y * y);
  }
  return density * scene_.pixel_size * scene_.pixel_size;
}

/// While points failed.
/// @param before  elastic energy before that, at the same strain [J/m].
void QuasiStaticSolver::take_work(double before) {
  const double lost = before - energy();
  if (!snaps_back()) {  // the platens stand still
    tally_.released += lost;
    return;
  }
  // The platens give way so that the points lose their stiffness at the strain at which they fail.
  const double spent = std::min(spent_, lost);
  tally_.released += spent;
  tally_.platen_work += spent - lost;
  spent_ = 0;
}

/// To the next state, or to the end. Where the platens may go back, the drop of the stress ends in a state of
/// its own, unless another point fails before.
/// @param before  elastic energy before the last failures, at the same strain [J/m].
void QuasiStaticSolver::move_platens(double before) {
  const double lost = before - energy();
  const double drop = snaps_back() && lost > 0 ? strain_ * std::min(spent_ / lost, 1.0) : strain_;
  take_work(before);
  has_dropped_ = drop < strain_ && drop < next_;
  if (has_dropped_) return add_work(drop);
  move_on();
}

/// To the strain of the next failure, or to the end.
void QuasiStaticSolver::move_on() {
  done_ = !(next_ <= scene_.loading.stop_strain);
  if (done_) return add_work(scene_.loading.stop_strain);
  add_work(snaps_back() ? next_ : std::max(strain_, next_));
}

/// From the state of the last failures to that at the next one.
void QuasiStaticSolver::step() {
  const bool first = steps_ == 0;
  ++steps_;
  if (has_dropped_) {
    has_dropped_ = false;
    return move_on();
  }
  if (first)
    take_out_loose();
  else
    fail_points(strain_, (snaps_back() ? next_ : std::max(next_, strain_)) * (1 + scene_.event_tolerance));
  const double before = energy();
  const std::int64_t iterations = equilibrium_.iterations();
  lost_ = !parted_ && !equilibrium_.solve(first ? 0 : reduction);
  if (!first && may_be_loose(equilibrium_.iterations() - iterations)) take_out_loose();
  modulus_ = equilibrium_.modulus();
  find_onsets();
  move_platens(before);
}

Ledger QuasiStaticSolver::advance(std::int64_t steps) {
  for (std::int64_t i = 0; i < steps && !done_ && !lost_; ++i) step();
  return ledger();
}

Ledger QuasiStaticSolver::ledger() const {
  Ledger ledger;
  ledger.platen_displacement = strain_ * scene_.height();
  ledger.force_top = sign_ * equilibrium_.modulus_top() * strain_ * scene_.width();
  ledger.force_bottom = -sign_ * equilibrium_.modulus_bottom() * strain_ * scene_.width();
  ledger.platen_work = tally_.platen_work;
  ledger.elastic = energy();
  ledger.released = tally_.released;
  ledger.tension_failures = tally_.tension_failures;
  ledger.shear_failures = tally_.shear_failures;
  ledger.carrying_points = carrying_;
  if (lost_) ledger.trouble = "no equilibrium was found";
  return ledger;
}

FramePoint QuasiStaticSolver::frame_point(const Pixel& pixel, std::uint8_t label) const {
  const int k = scene_.points_per_cell;
  const int from_below = static_cast<int>(scene_.labels.rows()) - 1 - pixel.row;
  const Place at{from_below / k, from_below % k * k + pixel.col % k, pixel.col / k};
  const double xi = (pixel.col % k + 0.5) / k;
  const double eta = (from_below % k + 0.5) / k;
  const CellDisplacement u = equilibrium_.displacement(at.row, at.cell);
  const auto moved = [&](const double(&v)[4]) {
    return sign_ * strain_ *
           ((1 - eta) * ((1 - xi) * v[0] + xi * v[1]) + eta * ((1 - xi) * v[2] + xi * v[3]));
  };
  const double share = equilibrium_.kept(at.row, at.plane, at.cell);
  const bool failed =
      !is_live(share) && maps_.failure_mode.size() > 0 && maps_.failure_mode(pixel.row, pixel.col) != 0;
  const double carried = is_live(share) ? share : failed ? scene_.damage.residual_stiffness : 0;
  const double kept = failed ? scene_.damage.residual_stiffness : is_live(share) ? share : 1;
  const Stress<double> s = elastic_at(limits_[label], at, strain_);
  return completed({.id = static_cast<std::uint32_t>(pixel.row * scene_.labels.cols() + pixel.col),
                    .x = (pixel.col + 0.5) * scene_.pixel_size + moved(u.ux),
                    .y = (from_below + 0.5) * scene_.pixel_size + moved(u.uy)},
                   {carried * s.xx, carried * s.yy, carried * s.xy, kept, 0}, scene_);
}

void QuasiStaticSolver::fill(Frame& frame) const {
  frame.step = steps_;
  frame.time = 0;
  frame.strain = strain_;
  frame.points.clear();
  for (int row = 0; row < scene_.labels.rows(); ++row)
    for (int col = 0; col < scene_.labels.cols(); ++col)
      if (const std::uint8_t label = scene_.labels(row, col); scene_.phases[label])
        frame.points.push_back(frame_point({row, col}, label));
}

template <class Archive, class Self>
void QuasiStaticSolver::pass(Archive& archive, Self& self) {
  archive.whole(self.steps_, 1, std::int64_t{1} << 62);
  archive.finite(self.strain_);
  archive.finite(self.farthest_);
  archive.finite(self.modulus_);
  archive.finite(self.tally_.platen_work);
  archive.finite(self.tally_.released);
  archive.flag(self.done_);
  archive.flag(self.has_dropped_);
  archive.block(self.factors_);
  archive.block(self.strengths_);
  archive.raw(&self.next_, 1);
  archive.block(self.equilibrium_.displacements().x);
  archive.block(self.equilibrium_.displacements().y);
  pass_maps(archive, self.maps_);
}

void QuasiStaticSolver::save(ArchiveWriter& archive) const {
  pass(archive, *this);
  archive.block(equilibrium_.points().stiffness);
  archive.block(equilibrium_.points().shear);
}

void QuasiStaticSolver::restore(ArchiveReader& archive) {
  const AlignedVector<double> intact = factors_;
  pass(archive, *this);
  AlignedVector<double> stiffness = equilibrium_.points().stiffness;
  AlignedVector<double> shear = equilibrium_.points().shear;
  archive.block(stiffness);
  archive.block(shear);
  if (!archive.ok()) return;
  for (std::size_t at = 0; at < intact.size(); ++at)
    if (factors_[at] != intact[at] && factors_[at] != 0) return archive.fail("a point of another strength");
  for (const std::uint8_t mode : maps_.failure_mode.reshaped()) {
    tally_.tension_failures += mode == static_cast<std::uint8_t>(FailureMode::tension) ? 1 : 0;
    tally_.shear_failures += mode == static_cast<std::uint8_t>(FailureMode::shear) ? 1 : 0;
  }
  if (!equilibrium_.restore(stiffness, shear)) return archive.fail("points of an impossible stiffness");
  each_point([&](const Place& at, std::size_t index) {
    if (intact[index] > 0) set_resistance(at, index);
  });
  carrying_ = 0;
  each_point([&](const Place& at, std::size_t) {
    if (is_live(equilibrium_.kept(at.row, at.plane, at.cell))) ++carrying_;
  });
  find_onsets();
}

}  // namespace mpm
