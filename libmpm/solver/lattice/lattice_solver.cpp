#include "libmpm/solver/lattice/lattice_solver.hpp"

#include <algorithm>
#include <cmath>

#include "libmpm/kernels/instruction_set.hpp"

namespace mpm {

template <class Real>
LatticeSolver<Real>::LatticeSolver(const Scene& scene, const Plan& plan)
    : scene_(scene),
      plan_(plan),
      law_(damage_law(scene, plan.cell_size, false)),
      factors_(scene, plan.softens),
      grid_(make_grid(scene, plan)),
      points_(make_points<Real>(scene, plan, factors_)),
      extra_(make_extra_points(scene, plan)),
      all_points_(count_points(scene)),
      team_(most_bands(plan)),
      maps_(empty_maps(scene, plan)) {
  const kernels::Kernels& kernels = chosen_kernels(scene.instruction_set);
  kernels::Features features = plan.features;
  sweep_cells_ = kernels.template cells<Real>(features);
  features.ledger = false;
  sweep_nodes_ = kernels.template nodes<Real>(features);
  features.ledger = true;
  sweep_nodes_ledger_ = kernels.template nodes<Real>(features);

  Phase unit;
  unit.young = 1;
  unit.poisson = plan.poisson;
  unit_stiffness_ = stiffness(unit, scene.plane);
  if (!scene.extra_points.empty()) shares_ = points_per_pixel(scene);
  const auto rows = static_cast<std::size_t>(grid_.rows);
  row_sums_.assign(rows, {});
  row_released_.assign(rows, 0.0);
  row_damped_.assign(rows, 0.0);
  no_force_.resize(points_.stride);
  find_pinned_node();
  make_bands();
}

template <class Real>
int LatticeSolver<Real>::most_bands(const Plan& plan) {
  return std::clamp(plan.threads, 1, plan.cells_y);
}

namespace {

/// Steps that one sweep over the rows takes together, so that what they need of a row is still in the cache
/// of the core: a quarter of a megabyte of rows, four of them at most.
template <class Real>
std::size_t steps_at_a_time(std::ptrdiff_t stride) {
  constexpr std::ptrdiff_t cache = std::ptrdiff_t{1} << 18U;
  const std::ptrdiff_t row = stride * static_cast<std::ptrdiff_t>(8 * sizeof(Real) + 7 * sizeof(double));
  return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(cache / row, 1, 4));
}

}  // namespace

template <class Real>
void LatticeSolver<Real>::make_bands() {
  const int count = team_.threads();
  bands_.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    Band& band = bands_[static_cast<std::size_t>(i)];
    band.begin = static_cast<int>(static_cast<std::int64_t>(plan_.cells_y) * i / count);
    band.end = static_cast<int>(static_cast<std::int64_t>(plan_.cells_y) * (i + 1) / count);
    band.upper.resize(count > 1 ? 1 : steps_at_a_time<Real>(points_.stride));
    for (auto& [one, other] : band.upper)
      for (ForceBuffer<Real>* buffer : {&one, &other}) buffer->resize(points_.stride);
    for (ForceBuffer<Real>* buffer : {&band.lower, &band.first_lower}) buffer->resize(points_.stride);
    band.suspects.assign(static_cast<std::size_t>(points_.stride), kernels::Flag<Real>{0});
  }
}

/// A smooth platen leaves the specimen free to slide; the node nearest the middle of the bottom holds it.
template <class Real>
void LatticeSolver<Real>::find_pinned_node() {
  pinned_ = nearest_to_middle(
      grid_.cols, [&](int col) { return grid_.impulse_over_mass[static_cast<std::size_t>(col)] > 0; });
}

template <class Real>
Ledger LatticeSolver<Real>::advance(std::int64_t steps) {
  steps = std::min(steps, plan_.steps + 1 - clock_.step);
  Barrier barrier(static_cast<int>(bands_.size()));
  const Clock start = clock_;
  team_.share(team_.threads(), [&](int band) {
    const Clock end = bands_.size() == 1 ? run_alone(start, steps)
                                         : run_band(static_cast<std::size_t>(band), start, steps, barrier);
    if (band == 0) clock_ = end;
  });
  return balance();
}

template <class Real>
typename LatticeSolver<Real>::Clock LatticeSolver<Real>::run_band(std::size_t index, Clock clock,
                                                                  std::int64_t steps, Barrier& barrier) {
  const FlushToZero flush;
  for (std::int64_t i = 0; i < steps; ++i) {
    const bool ledger = i + 1 == steps;
    advance_clock(clock);
    Band& band = bands_[index];
    for (int row = band.begin; row < band.end; ++row) sweep_row(band, 0, row, clock, ledger);
    barrier.arrive_and_wait();
    if (index > 0)
      sweep_node_row(band, band.begin, last_upper(bands_[index - 1]), band.first_lower, clock, ledger);
    barrier.arrive_and_wait();
    if (is_lost(clock)) break;
  }
  return clock;
}

/// All rows by one thread, some steps at a time: each step follows the one before it one row behind, where
/// the nodes that it needs have just been moved. What is computed is the same.
template <class Real>
typename LatticeSolver<Real>::Clock LatticeSolver<Real>::run_alone(Clock clock, std::int64_t steps) {
  const FlushToZero flush;
  Band& band = bands_.front();
  std::vector<Clock> clocks;
  for (std::int64_t done = 0; done < steps && !is_lost(clock);
       done += static_cast<std::int64_t>(clocks.size())) {
    clocks.clear();
    while (clocks.size() < band.upper.size() && done + static_cast<std::int64_t>(clocks.size()) < steps) {
      advance_clock(clock);
      clocks.push_back(clock);
    }
    const int lanes = static_cast<int>(clocks.size());
    for (int front = 0; front < band.end + lanes - 1; ++front)
      for (int lane = std::max(0, front - band.end + 1); lane <= std::min(front, lanes - 1); ++lane)
        sweep_row(band, static_cast<std::size_t>(lane), front - lane, clocks[static_cast<std::size_t>(lane)],
                  done + lane + 1 == steps);
  }
  return clock;
}

/// From the state at the end of a step to that of the next: the velocity that the platen will have in it.
template <class Real>
void LatticeSolver<Real>::advance_clock(Clock& clock) const {
  const double sign = scene_.loading.direction == Direction::tension ? 1.0 : -1.0;
  clock.displacement += plan_.dt * clock.next_velocity;
  clock.velocity = clock.next_velocity;
  clock.next_velocity =
      sign * scene_.loading.velocity * ramp(plan_, (static_cast<double>(clock.step) + 0.5) * plan_.dt);
  ++clock.step;
}

template <class Real>
const ForceBuffer<Real>& LatticeSolver<Real>::last_upper(const Band& band) const {
  return band.upper.front()[static_cast<std::size_t>((band.end - 1) % 2)];
}

/// The forces of a row of cells, and then the motion of the row of nodes below it, which is complete.
/// @param lane  of the steps under way, the one that the clock tells.
template <class Real>
void LatticeSolver<Real>::sweep_row(Band& band, std::size_t lane, int row, const Clock& clock, bool ledger) {
  const auto turn = static_cast<std::size_t>(row % 2);
  ForceBuffer<Real>& upper = band.upper[lane][turn];
  const ForceBuffer<Real>& below = row == band.begin ? no_force_ : band.upper[lane][1 - turn];
  const bool shared = row == band.begin && row > 0;
  ForceBuffer<Real>& lower = shared ? band.first_lower : band.lower;
  sweep_cell_row(band, row, lower, upper, std::abs(clock.displacement) / scene_.height());
  if (row == 0)
    sweep_platen_row(band, row, below, lower, clock);
  else if (!shared)
    sweep_node_row(band, row, below, lower, clock, ledger);
  if (row + 1 == plan_.cells_y) sweep_platen_row(band, row + 1, upper, no_force_, clock);
}

template <class Real>
void LatticeSolver<Real>::sweep_cell_row(Band& band, int row, ForceBuffer<Real>& lower,
                                         ForceBuffer<Real>& upper, double strain) {
  const auto nodes = grid_.at(row);
  const auto above = grid_.at(row + 1);
  const auto at = points_.row(row);
  const kernels::CellRow<Real> in{
      .cells = static_cast<int>(points_.stride),
      .stride = points_.stride,
      .ux_lower = grid_.ux.data() + nodes,
      .uy_lower = grid_.uy.data() + nodes,
      .ux_upper = grid_.ux.data() + above,
      .uy_upper = grid_.uy.data() + above,
      .stiffness = points_.stiffness.data() + at,
      .shear = points_.shear.empty() ? nullptr : points_.shear.data() + at,
      .tension = points_.tension.empty() ? nullptr : points_.tension.data() + at,
      .crush = points_.crush.empty() ? nullptr : points_.crush.data() + at,
      .cracked = points_.cracked.empty() ? nullptr : points_.cracked.data() + at,
      .unilateral = static_cast<Real>(scene_.damage.crack_closure == CrackClosure::unilateral ? 1 : 0),
      .unit_axial = static_cast<Real>(unit_stiffness_(0, 0)),
      .unit_lateral = static_cast<Real>(unit_stiffness_(0, 1)),
      .unit_shear = static_cast<Real>(unit_stiffness_(2, 2)),
      .unit_bending = static_cast<Real>(bending_stiffness(unit_stiffness_)),
      .lower = lower.forces(),
      .upper = upper.forces(),
      .suspects = band.suspects.data(),
  };
  // Points that fail carry nothing from this very step on, so the row is swept again without them.
  if (sweep_cells_(in) != 0 && fail_suspects(band, row, strain)) (void)sweep_cells_(in);
  if (!extra_.points.empty()) sweep_extra_points(band, row, in.lower, in.upper, strain);
}

template <class Real>
void LatticeSolver<Real>::sweep_node_row(Band& band, int row, const ForceBuffer<Real>& below,
                                         const ForceBuffer<Real>& above, const Clock& clock, bool ledger) {
  const auto at = grid_.at(row);
  const kernels::NodeRow<Real> in{
      .nodes = padded(grid_.cols),
      .below = below.forces(),
      .above = above.forces(),
      .ux = grid_.ux.data() + at,
      .uy = grid_.uy.data() + at,
      .vx = grid_.vx.data() + at,
      .vy = grid_.vy.data() + at,
      .impulse_over_mass = grid_.impulse_over_mass.data() + at,
      .dt = plan_.dt,
      .damping = scene_.local_damping,
  };
  const kernels::NodeSums sums = ledger ? sweep_nodes_ledger_(in) : sweep_nodes_(in);
  const auto index = static_cast<std::size_t>(row);
  if (ledger) row_sums_[index] = sums;
  row_damped_[index] += sums.damped;
  if (!std::isfinite(sums.velocity)) note_loss(band, row, clock);
}

/// The rows of nodes that a platen moves: their vertical motion is given, and what it takes is the reaction.
template <class Real>
void LatticeSolver<Real>::sweep_platen_row(Band& band, int row, const ForceBuffer<Real>& below,
                                           const ForceBuffer<Real>& above, const Clock& clock) {
  const bool top = row > 0;
  const double old_velocity = top ? clock.velocity : 0;
  const double new_velocity = top ? clock.next_velocity : 0;
  const auto lower = below.forces();
  const auto upper = above.forces();
  kernels::NodeSums sums{};
  double reaction = 0;
  for (int col = 0; col < grid_.cols; ++col) {
    const auto at = static_cast<std::size_t>(grid_.at(row, col));
    const double w = grid_.impulse_over_mass[at];
    const auto fx = static_cast<double>((upper.left_x[col] + upper.right_x[col - 1]) +
                                        (lower.left_x[col] + lower.right_x[col - 1]));
    const auto fy = static_cast<double>((upper.left_y[col] + upper.right_y[col - 1]) +
                                        (lower.left_y[col] + lower.right_y[col - 1]));
    const double vx0 = grid_.vx[at];
    const bool held = scene_.loading.platen == Platen::rough || (!top && col == pinned_);
    const double drag = held ? 0.0 : -scene_.local_damping * std::abs(fx) * ((vx0 > 0) - (vx0 < 0));
    const double vx1 = held ? 0.0 : vx0 + w * (fx + drag);
    reaction += (w > 0 ? (new_velocity - old_velocity) / w : 0.0) - fy;
    if (w > 0) {
      sums.momentum_rate += (vx0 * vx1 + old_velocity * new_velocity) / w;
      sums.damped -= 0.5 * drag * (vx0 + vx1);
    }
    sums.force_work += grid_.ux[at] * fx + grid_.uy[at] * fy;
    grid_.vx[at] = vx1;
    grid_.vy[at] = new_velocity;
    grid_.ux[at] += plan_.dt * vx1;
    grid_.uy[at] += plan_.dt * new_velocity;
  }
  row_sums_[static_cast<std::size_t>(row)] = sums;
  row_damped_[static_cast<std::size_t>(row)] += sums.damped;
  record_reaction(top, reaction / points_.planes, clock);
  if (!std::isfinite(reaction)) note_loss(band, row, clock);
}

template <class Real>
void LatticeSolver<Real>::record_reaction(bool top, double reaction, const Clock& clock) {
  Reaction& platen = top ? top_ : bottom_;
  platen.work += 0.5 * (platen.force + reaction) * plan_.dt * (top ? clock.velocity : 0.0);
  platen.force = reaction;
}

template <class Real>
Ledger LatticeSolver<Real>::balance() const {
  Ledger ledger;
  ledger.time = static_cast<double>(clock_.step - 1) * plan_.dt;
  ledger.platen_displacement = std::abs(clock_.displacement);
  ledger.force_top = top_.force;
  ledger.force_bottom = bottom_.force;
  ledger.platen_work = top_.work;
  const double to_force = 1.0 / points_.planes;
  for (std::size_t row = 0; row < row_sums_.size(); ++row) {
    ledger.kinetic += 0.5 * to_force * plan_.dt * row_sums_[row].momentum_rate;
    ledger.elastic -= 0.5 * to_force * row_sums_[row].force_work;
    ledger.damped += to_force * plan_.dt * row_damped_[row];
    ledger.released += row_released_[row];
  }
  ledger.carrying_points = all_points_;
  for (const Band& band : bands_) {
    ledger.tension_failures += band.tension_failures;
    ledger.shear_failures += band.shear_failures;
    ledger.carrying_points -= band.dead;
  }
  ledger.diverged_at = first_loss().step;
  return ledger;
}

template class LatticeSolver<float>;
template class LatticeSolver<double>;

}  // namespace mpm
