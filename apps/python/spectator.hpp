/// Python, looking on at work that goes on without its lock, and what a callback is told of it.
#pragma once

#include <pybind11/pybind11.h>
#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <optional>

#include "apps/calibrate/calibration.hpp"
#include "apps/study/study_run.hpp"
#include "libmpm/run/simulate.hpp"

namespace binding {

/// mesopix.Progress of a run.
[[nodiscard]] pybind11::object glance_at(const mpm::Progress& progress);

/// mesopix.Trial of a calibration.   @pre it has a history.
[[nodiscard]] pybind11::object glance_at(const app::Calibration& so_far);

/// mesopix.StudyProgress.
[[nodiscard]] pybind11::object glance_at(const app::StudyTally& tally);

/// mesopix.TwinProgress.
[[nodiscard]] pybind11::object glance_at_twins(std::size_t done, int count);

namespace py = pybind11;

/// Tells a callback how far work has come, and ends the work on Ctrl-C, by what the callback raises, and
/// where it returns False. Made and destroyed with the lock, asked without.
class Spectator {
 public:
  /// @param progress  callback, or None.
  explicit Spectator(py::object progress = py::none());

  /// @param glance  makes what the callback is given.   @return whether the work may go on.
  bool look(const std::function<py::object()>& glance);

  /// The same without the callback; does no more than look at the clock most of the time.
  bool go_on();

  /// Ctrl-C, wherever it was noticed.
  [[nodiscard]] bool interrupted() const;

  /// Raise again what has ended the work, if anything but Ctrl-C has.
  void rethrow() const;

  /// The same, and for Ctrl-C mesopix.Interrupted(text, result).
  void conclude(const std::string& text, const py::object& result) const;

 private:
  [[nodiscard]] bool is_due();
  /// Look for signals, then tell.   @return whether the work may go on.
  bool ask(const std::function<void()>& tell);

  py::object progress_;
  std::optional<py::error_already_set> raised_;
  bool ended_ = false;  ///< by StopIteration
  std::atomic<std::chrono::steady_clock::time_point> next_look_;
};

/// What work in threads of its own asks and tells.
class Overseer {
 public:
  explicit Overseer(Spectator& spectator) : spectator_(spectator) {}
  /// May be asked by any thread.
  [[nodiscard]] bool goes_on() const { return !stopped_; }
  /// By one thread at a time.
  void look(const std::function<py::object()>& glance) { stop_unless(spectator_.look(glance)); }
  void stop_unless(bool goes_on) {
    if (!goes_on) stopped_ = true;
  }

 private:
  Spectator& spectator_;
  std::atomic<bool> stopped_ = false;
};

/// Do work without the lock in a thread of its own, so that Ctrl-C finds the main thread awake.
/// @param work  takes an Overseer&.
template <class Work>
auto work_apart(Spectator& spectator, const Work& work) {
  Overseer overseer(spectator);
  const py::gil_scoped_release unlock;
  auto done = std::async(std::launch::async, [&] { return work(overseer); });
  while (done.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready)
    overseer.stop_unless(spectator.go_on());
  return done.get();
}

}  // namespace binding
