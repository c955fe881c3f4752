/// The frames of a run: when which one is due.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "libmpm/solver/checkpoint.hpp"
#include "libmpm/solver/frame.hpp"
#include "libmpm/scene/scene.hpp"

namespace mpm {

/// It costs a comparison a row where nobody asked for any.
class RunFrames {
 public:
  /// The sink must outlive this.
  RunFrames(const Scene& scene, const FrameSink& sink) : count_(sink ? scene.frames : 0), sink_(sink) {}

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
  const FrameSink& sink_;
  double due_ = 0;  ///< number of the next frame
  Frame frame_;
  std::vector<FrameTaken> taken_;
};

}  // namespace mpm
