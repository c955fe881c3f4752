/// The rows of the history and the quantities derived from them; messages for an unstable run; the times of
/// frames.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "libmpm/scene/result.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/solver/checkpoint.hpp"
#include "libmpm/solver/failure_maps.hpp"
#include "libmpm/solver/frame.hpp"
#include "libmpm/solver/plan.hpp"

namespace mpm {

/// An instability: what was observed, when and where.
struct Divergence {
  std::string what = {};   ///< "energy grows without work"
  std::int64_t step = 0;   ///< number of the step
  double time = 0;         ///< [s]
  double dt = 0;           ///< of the step [s]
  std::string point = {};  ///< where it is worst, by name with its phase; empty = nowhere in particular
  bool moving = false;     ///< the points move
};

/// Message with step, time and point, the likely cause and the cure, with a safe solver.cfl if one is known.
[[nodiscard]] std::string divergence_text(const Scene& scene, const Plan& plan, const Divergence& divergence);

/// The row of the initial state.
[[nodiscard]] HistoryRow first_row(const Scene& scene);

/// The row of a ledger, without the number of moving points.
[[nodiscard]] HistoryRow history_row(const Scene& scene, const Ledger& ledger);

/// Strain below which the rows of the history lie closest, whatever the stop_strain [-]: well below the peak
/// of any specimen of these phases. 0 = nothing can fail, or there are no platens.
[[nodiscard]] double early_strain(const Scene& scene);

/// Steps to the next row after one at a strain: those of the plan, or fewer, so that up to any peak beyond
/// the early strain a run has a fifth of Scene::history_rows at least.
[[nodiscard]] std::int64_t steps_to_next_row(const Scene& scene, const Plan& plan, double early,
                                             double strain);

/// Add a row, and update the peak and the other totals of the result.
void add_row(Result& result, const HistoryRow& row, Direction direction);

/// Of the strain, or without platens of the time, at which the run ends [-].
[[nodiscard]] double share_done(const Scene& scene, const HistoryRow& row);

/// Whether more energy was created than put in.   @param first  row of the history.
[[nodiscard]] bool makes_energy(const HistoryRow& row, const HistoryRow& first);

/// Set the energy error of the result from its history.
void close_ledger(Result& result);

/// Number of the next frame behind one at a share of the run [-], counted in even steps of the whole run: a
/// whole number, or what lies closer where the run may end long before, so that up to any peak beyond the
/// early strain there is a fifth of the frames at least.
/// @param early  early_strain() over the strain at which the run ends [-].
[[nodiscard]] double next_frame(int count, double early, double done);

/// It costs a comparison a row where nobody asked for any.
class RunFrames {
 public:
  /// The sink must outlive this.
  RunFrames(const Scene& scene, const FrameSink& sink)
      : count_(sink ? scene.frames : 0),
        early_(count_ > 0 ? early_strain(scene) / scene.loading.stop_strain : 0),
        sink_(sink) {}

  /// At the start and at every row of the history. @param done  share of the run [-].
  template <class Solver>
  void offer(const Solver& solver, double done, std::size_t row) {
    if (count_ == 0 || done * count_ < due_) return;
    take(solver, row);
    due_ = next_frame(count_, early_, done);
  }
  /// At the end: the last row, unless it was a frame.
  template <class Solver>
  void close(const Solver& solver, std::size_t row) {
    if (count_ > 0 && frame_.row != static_cast<std::int64_t>(row)) take(solver, row);
  }

  [[nodiscard]] const std::vector<FrameTaken>& taken() const { return taken_; }

  /// When the next one is due, for the archive of a run.
  template <class Archive, class Self>
  static void pass(Archive& archive, Self& self) {
    archive.finite(self.due_);
    archive.whole(self.frame_.row, 0, std::int64_t{1} << 62);
    archive.list(self.taken_);
  }

 private:
  template <class Solver>
  void take(const Solver& solver, std::size_t row) {
    solver.fill(frame_);
    frame_.row = static_cast<std::int64_t>(row);
    sink_(frame_);
    taken_.push_back({frame_.time, static_cast<std::int64_t>(frame_.points.size())});
  }

  int count_;
  double early_;  ///< share of the run up to which frames lie closest [-]
  const FrameSink& sink_;
  double due_ = 0;  ///< number of the next frame
  Frame frame_;
  std::vector<FrameTaken> taken_;
};

}  // namespace mpm
