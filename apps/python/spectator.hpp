/// Python, looking on at work that goes on without its lock.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <functional>
#include <optional>

namespace binding {

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

 private:
  [[nodiscard]] bool is_due();

  py::object progress_;
  std::optional<py::error_already_set> raised_;
  bool ended_ = false;  ///< by StopIteration
  std::chrono::steady_clock::time_point next_look_;
};

}  // namespace binding
