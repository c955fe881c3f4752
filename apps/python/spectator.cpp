#include "apps/python/spectator.hpp"

#include <pybind11/stl.h>
#include <utility>

#include "apps/python/options.hpp"

namespace binding {
namespace {

namespace py = pybind11;

/// A named tuple of the package.
py::object named(const char* type, const py::tuple& values) {
  return py::module_::import("mesopix.progress").attr(type)(*values);
}

}  // namespace

py::object glance_at(const mpm::Progress& progress) {
  const mpm::HistoryRow& row = progress.row;
  return named("Progress", py::make_tuple(progress.fraction, row.time, row.strain, row.stress,
                                          row.tension_failures, row.shear_failures, progress.wall_time));
}

py::object glance_at(const app::Calibration& so_far) {
  const app::Evaluation& last = so_far.history.back();
  return named("Trial", py::make_tuple(so_far.history.size(), last.misfit, so_far.best_evaluation().misfit,
                                       last.factors, last.peak.stress, last.peak.strain));
}

py::object glance_at(const app::StudyTally& tally) {
  return named("StudyProgress", py::make_tuple(tally.done, tally.failed, tally.before, tally.all));
}

py::object glance_at_twins(std::size_t done, int count) {
  return named("TwinProgress", py::make_tuple(done, count));
}

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto between_looks = std::chrono::milliseconds(50);

}  // namespace

Spectator::Spectator(py::object progress)
    : progress_(std::move(progress)), next_look_(Clock::now() + between_looks) {}

bool Spectator::is_due() {
  const Clock::time_point now = Clock::now();
  if (now < next_look_.load()) return false;
  next_look_ = now + between_looks;
  return true;
}

bool Spectator::ask(const std::function<void()>& tell) {
  const py::gil_scoped_acquire lock;
  if (raised_ || ended_) return false;
  try {
    // Ctrl-C comes to the main thread alone; in others this does nothing.
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    tell();
  } catch (const py::error_already_set& error) {
    ended_ = error.matches(PyExc_StopIteration);
    if (!ended_) raised_.emplace(error);
  }
  return !raised_ && !ended_;
}

bool Spectator::look(const std::function<py::object()>& glance) {
  return progress_.is_none() ? go_on() : ask([&] { progress_(glance()); });
}

bool Spectator::go_on() {
  return !is_due() || ask([] {});
}

bool Spectator::interrupted() const { return raised_ && raised_->matches(PyExc_KeyboardInterrupt); }

void Spectator::rethrow() const {
  if (raised_ && !interrupted()) throw py::error_already_set(*raised_);
}

void Spectator::conclude(const std::string& text, const py::object& result) const {
  rethrow();
  if (interrupted()) raise_with("Interrupted", text, result);
}

}  // namespace binding
