#include "libmpm/simulate.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "libmpm/divergence.hpp"
#include "libmpm/instruction_set.hpp"
#include "libmpm/lattice_solver.hpp"
#include "libmpm/moving_solver.hpp"
#include "libmpm/plan.hpp"

namespace mpm {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

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
double kinetic_energy_at_start(const Scene& scene, const Plan& plan) {
  double energy = 0;
  for (const StartPoint& point : start_of(scene, plan).points)
    energy += 0.5 * point.mass * (point.vx * point.vx + point.vy * point.vy);
  return energy;
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

/// Energy that came in from outside, at the start and since [J/m].
double energy_put_in(const HistoryRow& row, const HistoryRow& first) {
  return row.platen_work + first.kinetic;
}

double imbalance(const HistoryRow& row, const HistoryRow& first) {
  return std::abs(energy_put_in(row, first) - row.kinetic - row.elastic - row.released - row.damped -
                  row.left);
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
    largest_work = std::max(largest_work, std::abs(energy_put_in(row, result.history.front())));
    largest_imbalance = std::max(largest_imbalance, imbalance(row, result.history.front()));
  }
  result.energy_error = largest_work > 0 ? largest_imbalance / largest_work : 0;
}

std::string trouble_message(const Ledger& ledger, std::int64_t step) {
  char text[512];
  std::snprintf(text, sizeof text, "%s, at step %lld (time %.4g s)", ledger.trouble.c_str(),
                static_cast<long long>(step), ledger.time);
  return text;
}

/// Of the strain, or without platens of the time, at which the run ends [-].
double share_done(const Scene& scene, const HistoryRow& row) {
  return scene.loading.direction == Direction::none ? row.time / scene.loading.duration
                                                    : row.strain / scene.loading.stop_strain;
}

/// When which frame is due; it costs a comparison a row where nobody asked for any.
class Frames {
 public:
  Frames(const Scene& scene, const FrameSink& sink) : count_(sink ? scene.frames : 0), sink_(sink) {}

  /// At the start and at every row of the history. @param done  share of the run [-].
  template <class Solver>
  void offer(const Solver& solver, double done, std::size_t row) {
    if (count_ > 0 && done * count_ >= due_) take(solver, row);
    due_ = std::max(due_, std::floor(done * count_) + 1);
  }
  /// At the end: the last row, unless it was a frame.
  template <class Solver>
  void close(const Solver& solver, std::size_t row) {
    if (count_ > 0 && frame_.row != static_cast<std::int64_t>(row)) take(solver, row);
  }

 private:
  template <class Solver>
  void take(const Solver& solver, std::size_t row) {
    solver.fill(frame_);
    frame_.row = static_cast<std::int64_t>(row);
    sink_(frame_);
  }

  int count_;
  const FrameSink& sink_;
  double due_ = 0;  ///< number of the next frame
  Frame frame_;
};

/// A run as it goes: what was recorded so far, and what ends it.
class Run {
 public:
  Run(const Scene& scene, const Plan& plan, const Observer& observer, const FrameSink& frames)
      : scene_(scene), plan_(plan), observer_(observer), frames_(scene, frames) {
    result_.points = count_points(scene);
    result_.dt = plan.dt;
    result_.threads = plan.threads;
    result_.instruction_set = chosen_kernels(scene.instruction_set).name;
    result_.history.reserve(static_cast<std::size_t>(plan.steps / plan.steps_per_row + 2));
    HistoryRow rest;
    if (scene.loading.direction == Direction::none) rest.kinetic = kinetic_energy_at_start(scene, plan);
    add_row(result_, rest);
    if (scene.loading.direction == Direction::none) result_.stop = StopReason::time;
  }

  /// Steps until the run ends or `outgrown` says, after a row of the history, that the solver has done its
  /// part.   @return whether the run goes on with another solver.
  template <class Solver, class Outgrown>
  [[nodiscard]] bool drive(Solver& solver, bool moving, const Outgrown& outgrown) {
    if (result_.history.size() == 1) frames_.offer(solver, 0, 0);
    std::int64_t steps = plan_.steps_per_row;
    while (!solver.is_done()) {
      const Ledger ledger = solver.advance(steps);
      result_.steps = solver.steps();
      HistoryRow row = history_row(scene_, ledger);
      row.moving_points = moving ? result_.points - ledger.left_points : 0;
      if (const std::string trouble = trouble_of(solver, moving, ledger, row); !trouble.empty()) {
        complete(result_, solver);
        throw Diverged(trouble, std::move(result_));
      }
      add_row(result_, row);
      frames_.offer(solver, share_done(scene_, row), result_.history.size() - 1);
      const bool was_over = result_.nothing_carries;
      result_.nothing_carries = nothing_carries(ledger);
      if (ends(solver, row)) return false;
      if (was_over) {
        result_.stop = StopReason::drop;
        return false;
      }
      // What failed last may still have pushed in its step: one more shows that nothing does.
      if (result_.nothing_carries)
        steps = 1;
      else if (outgrown())
        return true;
    }
    return false;
  }

  /// A run that did not go wrong.
  template <class Solver>
  [[nodiscard]] Result end(Solver& solver) {
    frames_.close(solver, result_.history.size() - 1);
    complete(result_, solver);
    return std::move(result_);
  }

 private:
  /// Adds what is not recorded row by row.
  template <class Solver>
  void complete(Result& result, const Solver& solver) const {
    result.wall_time = seconds_since(start_);
    solver.copy_maps(result);
    close_ledger(result);
  }

  template <class Solver>
  [[nodiscard]] Result so_far(const Solver& solver) const {
    Result copy = result_;
    complete(copy, solver);
    return copy;
  }

  template <class Solver>
  [[nodiscard]] std::string trouble_of(const Solver& solver, bool moving, const Ledger& ledger,
                                       const HistoryRow& row) const {
    if (!ledger.trouble.empty()) return trouble_message(ledger, result_.steps);
    Divergence seen{.time = ledger.time, .dt = solver.dt(), .moving = moving};
    if (ledger.diverged_at >= 0) {
      seen.what = "motion is not a number";
      seen.step = ledger.diverged_at;
      if (!moving) seen.time = static_cast<double>(seen.step) * seen.dt;
    } else if (makes_energy(row, result_.history.front())) {
      seen.what = "energy grows without work";
      seen.step = result_.steps;
    } else {
      return {};
    }
    seen.point = solver.worst_point();
    return divergence_text(scene_, plan_, seen);
  }

  template <class Solver>
  [[nodiscard]] bool ends(const Solver& solver, const HistoryRow& row) {
    // Before the ramp ends the waves of the start are no peak.
    if (scene_.loading.stop_drop && row.time > plan_.ramp_time &&
        row.stress < *scene_.loading.stop_drop * result_.peak_stress) {
      result_.stop = StopReason::drop;
      return true;
    }
    if (observer_ && !observer_({row, std::min(1.0, share_done(scene_, row)), seconds_since(start_),
                                 [&] { return so_far(solver); }})) {
      result_.stop = StopReason::interrupted;
      return true;
    }
    return false;
  }

  /// Between platens the run is then over; a specimen that flies goes on flying.
  [[nodiscard]] bool nothing_carries(const Ledger& ledger) const {
    return ledger.carrying_points == 0 && scene_.loading.direction != Direction::none;
  }

  const Scene& scene_;
  const Plan& plan_;
  const Observer& observer_;
  Frames frames_;
  Clock::time_point start_ = Clock::now();
  Result result_;
};

template <class Real>
Result run(const Scene& scene, const Plan& plan, const Observer& observer, const FrameSink& frames) {
  const auto never = [] { return false; };
  if (scene.kinematics != Kinematics::moving) {
    LatticeSolver<Real> solver(scene, plan);
    Run run(scene, plan, observer, frames);
    const bool automatic = scene.kinematics == Kinematics::automatic;
    if (!run.drive(solver, false, [&] { return automatic && solver.outgrows(scene.handover); }))
      return run.end(solver);
    MovingSolver<Real> moving(scene, plan, solver.hand_over());
    (void)run.drive(moving, true, never);
    return run.end(moving);
  }
  MovingSolver<Real> solver(scene, plan, start_of(scene, plan));
  Run run(scene, plan, observer, frames);
  (void)run.drive(solver, true, never);
  return run.end(solver);
}

}  // namespace

Result simulate(const Scene& scene, const Observer& observer, const FrameSink& frames) {
  return simulate(scene, plan(scene), observer, frames);
}

Result simulate(const Scene& scene, const Plan& plan, const Observer& observer, const FrameSink& frames) {
  return scene.precision == Precision::single ? run<float>(scene, plan, observer, frames)
                                              : run<double>(scene, plan, observer, frames);
}

}  // namespace mpm
