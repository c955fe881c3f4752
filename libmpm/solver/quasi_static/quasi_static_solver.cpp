#include "libmpm/solver/quasi_static/quasi_static_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mpm {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double reduction = 1e-3;  ///< of the error that the last failures have added

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

bool softens_in_shear(const Scene& scene) {
  return std::any_of(scene.phases.begin(), scene.phases.end(),
                     [](const auto& phase) { return phase && phase->softens_in_shear(); });
}

}  // namespace

QuasiStaticSolver::QuasiStaticSolver(const Scene& scene, const Plan& plan)
    : QuasiStaticSolver(scene, plan, drawn_factors(scene)) {}

QuasiStaticSolver::QuasiStaticSolver(const Scene& scene, const Plan& plan, const PixelField<double>& factors)
    : scene_(scene),
      plan_(plan),
      equilibrium_(scene, plan, StrengthFactors(scene, false)),
      law_(damage_law(scene, plan.cell_size, false)),
      maps_(empty_maps(scene, plan)),
      sign_(scene.loading.direction == Direction::tension ? 1.0 : -1.0),
      carrying_(count_points(scene)) {
  for (std::size_t i = 0; i < scene.fixture.gauges.size(); ++i)
    if (scene.fixture.gauges[i].controls) control_ = static_cast<int>(i);
  for (const auto& phase : scene.phases) {
    Limits limits;
    if (phase)
      limits = {stiffness(*phase, scene.plane), scene.plane == Plane::strain ? phase->poisson : 0,
                phase->can_crack() ? phase->tensile_scale : never, std::sin(phase->friction_angle),
                phase->can_shear() ? 2 * phase->cohesion * std::cos(phase->friction_angle) : never};
    limits_.push_back(limits);
  }
  const LatticePoints<double>& points = equilibrium_.points();
  factors_.assign(equilibrium_.points_in_all(), 0.0);
  resistance_.tension.assign(points.stiffness.size(), 0.0F);
  resistance_.crush.assign(points.stiffness.size(), 0.0F);
  utilisations_.assign(static_cast<std::size_t>(plan.cells_y * (points.planes + 1)), 0.0);
  if (plan.softens || closes()) strengths_.assign(factors_.size(), never);
  if (softens_in_shear(scene)) cohesions_.assign(factors_.size(), 1);
  const StrengthFactors drawn(scene, false);
  each_point([&](const Place& at, std::size_t index) {
    const std::uint8_t* label = equilibrium_.label(at);
    if (label == nullptr || !scene.phases[*label]->can_fail()) return;
    factors_[index] = equilibrium_.is_extra(at)
                          ? drawn.of_extra_point(equilibrium_.extra(at).index)
                          : factors(equilibrium_.pixel(at).row, equilibrium_.pixel(at).col);
    if (!strengths_.empty()) strengths_[index] = limits_[*label].tension * factors_[index];
    set_resistance(at, index);
  });
}

double QuasiStaticSolver::energy() const { return 0.5 * modulus_ * strain_ * strain_ * volume(); }

/// The platens move to another strain while nothing fails.
void QuasiStaticSolver::add_work(double strain) {
  const double before = energy();
  strain_ = strain;
  farthest_ = std::max(farthest_, strain);
  tally_.platen_work += energy() - before;
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

/// Strain at which the controlling gauge reads so much; one that does not open tells nothing [-].
double QuasiStaticSolver::strain_at(double reading) const {
  const double opening = equilibrium_.gauge(static_cast<std::size_t>(control_));
  return opening > 0 ? reading / opening : strain_;
}

/// While points fail the controlling gauge stands still, and the load goes along a straight line to where it
/// reads the same.
/// @param before  elastic energy before that [J/m].
void QuasiStaticSolver::follow_gauge(double before) {
  const double strain = strain_at(reading_);
  const double stress_before = 2 * before / (strain_ * volume());
  const double work = 0.5 * (stress_before + modulus_ * strain) * (strain - strain_) * volume();
  strain_ = strain;
  farthest_ = std::max(farthest_, strain);
  tally_.platen_work += work;
  tally_.released += before + work - energy();
}

/// To the next state, or to the end. Where the platens may go back, the drop of the stress ends in a state of
/// its own, unless another point fails before.
/// @param before  elastic energy before the last failures, at the same strain [J/m].
void QuasiStaticSolver::move_platens(double before) {
  if (control_ >= 0 && strain_ > 0) {
    follow_gauge(before);
    has_dropped_ = next_ > strain_;
    return has_dropped_ ? void() : move_on();
  }
  const double lost = before - energy();
  const double drop = snaps_back() && lost > 0 ? strain_ * std::min(spent_ / lost, 1.0) : strain_;
  take_work(before);
  has_dropped_ = drop < strain_ && drop < next_;
  if (has_dropped_) return add_work(drop);
  move_on();
}

/// Strain at which the run ends if nothing fails before: that of the platens, or of a gauge.
double QuasiStaticSolver::end_strain() const {
  double end = scene_.loading.stop_strain;
  for (std::size_t i = 0; i < scene_.fixture.gauges.size(); ++i)
    if (const auto& until = scene_.fixture.gauges[i].until; until && equilibrium_.gauge(i) > 0)
      end = std::min(end, *until / equilibrium_.gauge(i));
  return end;
}

/// To the strain of the next failure, or to the end.
void QuasiStaticSolver::move_on() {
  const double end = end_strain();
  done_ = !(next_ <= end);
  add_work(done_          ? std::max(end, snaps_back() ? 0 : strain_)
           : snaps_back() ? next_
                          : std::max(strain_, next_));
  if (control_ >= 0)
    reading_ = std::max(reading_, strain_ * equilibrium_.gauge(static_cast<std::size_t>(control_)));
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
  if (scene_.fixture.has_loads()) {
    ledger.force_top = equilibrium_.leading_modulus() * strain_ * scene_.width();
    ledger.force_bottom = -ledger.force_top;
  } else {
    ledger.force_top = sign_ * equilibrium_.modulus_top() * strain_ * scene_.width();
    ledger.force_bottom = -sign_ * equilibrium_.modulus_bottom() * strain_ * scene_.width();
  }
  for (std::size_t i = 0; i < scene_.fixture.gauges.size(); ++i)
    ledger.gauges.push_back(sign_ * strain_ * equilibrium_.gauge(i));
  ledger.platen_work = tally_.platen_work;
  ledger.elastic = energy();
  ledger.released = tally_.released;
  ledger.tension_failures = tally_.tension_failures;
  ledger.shear_failures = tally_.shear_failures;
  ledger.carrying_points = carrying_;
  if (lost_) ledger.trouble = "no equilibrium was found";
  return ledger;
}

}  // namespace mpm
