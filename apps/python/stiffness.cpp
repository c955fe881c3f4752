#include "apps/job/stiffness.hpp"

#include "apps/python/body.hpp"
#include "apps/python/options.hpp"
#include "apps/python/study.hpp"

namespace binding {
namespace {

py::object stiffness(const py::object& input, const py::dict& settings, const py::dict& options) {
  const Broken broken = located({}, [&] {
    std::vector<app::Assignment> given = assignments(app::offer_of_stiffness(), settings, options);
    app::refuse_strengths(given);
    return broken_of(input, std::move(given), "INPUT");
  });
  return located(broken.resolved.origins, [&] {
    const app::Prepared cells = broken.cells();
    const app::StiffnessReport report = [&] {
      const py::gil_scoped_release others_go_on;
      return app::measure_stiffness(broken.stem, cells.specimen, broken.resolved.settings);
    }();
    return as_dict(app::stiffness_json(report));
  });
}

}  // namespace

void bind_stiffness(py::module_& module) { module.def("stiffness", &stiffness); }

}  // namespace binding
