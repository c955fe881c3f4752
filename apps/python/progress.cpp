#include "apps/python/progress.hpp"

#include <pybind11/stl.h>

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

}  // namespace binding
