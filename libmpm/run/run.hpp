/// A run in progress: its records so far, and the conditions that end it.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <utility>

#include "libmpm/kernels/instruction_set.hpp"
#include "libmpm/run/hooks.hpp"
#include "libmpm/run/run_history.hpp"
#include "libmpm/solver/archive.hpp"
#include "libmpm/solver/plan.hpp"

namespace mpm {

class Run {
 public:
  /// All of them must outlive the run.
  Run(const Scene& scene, const Plan& plan, const RunHooks& hooks)
      : scene_(scene), plan_(plan), hooks_(hooks), frames_(scene, hooks.frames) {
    result_.points = count_points(scene);
    result_.dt = plan.dt;
    result_.threads = plan.threads;
    result_.instruction_set = chosen_kernels(scene.instruction_set).name;
    result_.history.reserve(static_cast<std::size_t>(plan.steps / plan.steps_per_row + 2));
    add_row(result_, first_row(scene), scene.loading.direction);
    if (scene.loading.direction == Direction::none) result_.stop = StopReason::time;
    for (const Gauge& gauge : scene.fixture.gauges) result_.gauges.push_back({gauge.name, {0.0}});
  }

  /// Restore the records from the archive of a checkpoint.   @pre nothing has been recorded.
  void restore(ArchiveReader& archive, double wall_time) {
    pass(archive, *this);
    archive.list(result_.history);
    if (result_.history.size() < 2) archive.fail("a history without rows");
    const std::vector<HistoryRow> rows = std::exchange(result_.history, {});
    for (const HistoryRow& row : rows) add_row(result_, row, scene_.loading.direction);
    restore_gauges(archive);
    wall_time_before_ = wall_time;
  }

  /// Take steps until the run ends, or until `outgrown` says at a row of the history that another solver must
  /// continue.   @return whether the run continues with another solver.
  template <class Solver, class Outgrown>
  [[nodiscard]] bool drive(Solver& solver, bool moving, const Outgrown& outgrown) {
    if (result_.history.size() == 1) frames_.offer(solver, 0, 0);
    while (result_.nothing_carries || !outgrown()) {
      if (solver.is_done()) return false;
      // What failed last may still have pushed in its step: one more shows that nothing does.
      const bool was_over = result_.nothing_carries;
      const Ledger ledger = solver.advance(was_over ? 1 : steps_to_row());
      result_.steps = solver.steps();
      HistoryRow row = history_row(scene_, ledger);
      row.moving_points = moving ? result_.points - ledger.left_points : 0;
      if (const std::string trouble = trouble_of(solver, moving, ledger, row); !trouble.empty()) {
        complete(result_, solver);
        throw Diverged(trouble, std::move(result_));
      }
      add_row(result_, row, scene_.loading.direction);
      for (std::size_t i = 0; i < result_.gauges.size(); ++i)
        result_.gauges[i].values.push_back(ledger.gauges.at(i));
      frames_.offer(solver, share_done(row), result_.history.size() - 1);
      result_.nothing_carries = nothing_carries(ledger);
      const bool goes_on = !hooks_.observer || hooks_.observer(progress(solver, row));
      if (was_over || has_dropped(row)) {
        result_.stop = StopReason::drop;
        return false;
      }
      if (!goes_on || is_checkpoint_due()) keep(solver, moving, row);
      if (!goes_on) {
        result_.stop = StopReason::interrupted;
        return false;
      }
    }
    return true;
  }

  /// The result of a run without a fault.
  template <class Solver>
  [[nodiscard]] Result end(Solver& solver) {
    frames_.close(solver, result_.history.size() - 1);
    complete(result_, solver);
    return std::move(result_);
  }

 private:
  using Clock = std::chrono::steady_clock;

  void restore_gauges(ArchiveReader& archive) {
    for (GaugeReadings& gauge : result_.gauges) {
      archive.list(gauge.values);
      if (gauge.values.size() != result_.history.size()) archive.fail("a gauge with another number of rows");
    }
  }

  /// By the strain, or by the gauge that ends the run, whichever is further; of the last row.
  [[nodiscard]] double share_done(const HistoryRow& row) const {
    double share = mpm::share_done(scene_, row);
    for (std::size_t i = 0; i < result_.gauges.size(); ++i)
      if (const auto& until = scene_.fixture.gauges[i].until)
        share = std::max(share, result_.gauges[i].values.back() / *until);
    return share;
  }

  static double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }
  [[nodiscard]] std::int64_t steps_to_row() const {
    return steps_to_next_row(scene_, plan_, early_strain_, result_.history.back().strain);
  }
  [[nodiscard]] double wall_time() const { return wall_time_before_ + seconds_since(start_); }

  template <class Solver>
  [[nodiscard]] Progress progress(const Solver& solver, const HistoryRow& row) const {
    return {row, std::min(1.0, share_done(row)), wall_time(), [&] { return so_far(solver); }};
  }

  /// Adds what is not recorded row by row.
  template <class Solver>
  void complete(Result& result, const Solver& solver) const {
    result.wall_time = wall_time();
    result.missing_threads = solver.missing_threads();
    result.threads = plan_.threads - result.missing_threads;
    solver.copy_maps(result);
    close_ledger(result);
  }

  template <class Solver>
  [[nodiscard]] Result so_far(const Solver& solver) const {
    Result copy = result_;
    complete(copy, solver);
    return copy;
  }

  [[nodiscard]] bool is_checkpoint_due() const {
    const CheckpointWish& wish = hooks_.checkpoints;
    if (!wish.sink || !(wish.every > 0)) return false;
    const double since = seconds_since(last_kept_);
    return wish.is_due ? wish.is_due(since) : since >= wish.every;
  }

  template <class Solver>
  void keep(const Solver& solver, bool moving, const HistoryRow& row) {
    if (!hooks_.checkpoints.sink) return;
    last_kept_ = Clock::now();  // of the state, however long it takes to keep
    Checkpoint checkpoint;
    checkpoint.precision = scene_.precision;
    checkpoint.moving = moving;
    checkpoint.instruction_set = result_.instruction_set;
    checkpoint.specimen = specimen_digest(scene_);
    checkpoint.step = result_.steps;
    checkpoint.fraction = std::min(1.0, share_done(row));
    checkpoint.wall_time = wall_time();
    checkpoint.frames = frames_.taken();
    ArchiveWriter archive;
    pass(archive, *this);
    archive.list(result_.history);
    for (const GaugeReadings& gauge : result_.gauges) archive.list(gauge.values);
    solver.save(archive);
    checkpoint.state = archive.take();
    hooks_.checkpoints.sink(std::move(checkpoint));
  }

  /// All that was recorded but the rows.
  template <class Archive, class Self>
  static void pass(Archive& archive, Self& self) {
    archive.whole(self.result_.steps, 1, std::int64_t{1} << 62);
    archive.flag(self.result_.nothing_carries);
    RunFrames::pass(archive, self.frames_);
  }

  [[nodiscard]] std::string trouble_message(const Ledger& ledger) const {
    char text[512];
    if (scene_.method == SolverMethod::quasi_static)
      std::snprintf(text, sizeof text, "%s, at state %lld (strain %.4g); choose solver.method = \"explicit\"",
                    ledger.trouble.c_str(), static_cast<long long>(result_.steps),
                    ledger.platen_displacement / scene_.height());
    else
      std::snprintf(text, sizeof text, "%s, at step %lld (time %.4g s)", ledger.trouble.c_str(),
                    static_cast<long long>(result_.steps), ledger.time);
    return text;
  }

  template <class Solver>
  [[nodiscard]] std::string trouble_of(const Solver& solver, bool moving, const Ledger& ledger,
                                       const HistoryRow& row) const {
    if (!ledger.trouble.empty()) return trouble_message(ledger);
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

  /// Before the ramp ends the waves of the start are no peak.
  [[nodiscard]] bool has_dropped(const HistoryRow& row) const {
    const bool is_ramped = scene_.method == SolverMethod::quasi_static || row.time > plan_.ramp_time;
    return scene_.loading.stop_drop && is_ramped &&
           row.stress < *scene_.loading.stop_drop * result_.peak_stress;
  }

  /// Between platens the run is then over; a specimen that flies goes on flying.
  [[nodiscard]] bool nothing_carries(const Ledger& ledger) const {
    return ledger.carrying_points == 0 && scene_.loading.direction != Direction::none;
  }

  const Scene& scene_;
  const Plan& plan_;
  const RunHooks& hooks_;
  double early_strain_ = early_strain(scene_);  ///< up to which rows lie closest [-]
  RunFrames frames_;
  Clock::time_point start_ = Clock::now();
  double wall_time_before_ = 0;  ///< of the parts before this one [s]
  Clock::time_point last_kept_ = start_;
  Result result_;
};

}  // namespace mpm
