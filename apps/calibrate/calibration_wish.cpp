#include "apps/calibrate/calibration_wish.hpp"

#include <utility>

#include "apps/settings/read_option.hpp"

namespace app {
namespace {

std::string wanted_free(const CalibrationWish& wish, const Target& target) {
  if (!wish.free.empty()) return wish.free;
  if (!target.curve.empty()) return "tensile_scale,young,weibull_modulus";
  if (!target.peak_strain) return "tensile_scale";
  return target.peak_stress ? "tensile_scale,young" : "young";
}

}  // namespace

Target read_target(const CalibrationWish& wish, TargetCurve measured) {
  const bool peak = !wish.peak_stress.empty() || !wish.peak_strain.empty();
  if (peak != (wish.curve.empty() && measured.empty()))
    throw Rejected(Exit::usage,
                   complaint("--target", peak ? "given beside a peak" : "no target is given",
                             "a target is --peak-stress, --peak-strain or both, or --target CURVE.csv"));
  Target target;
  target.curve = wish.curve.empty() ? std::move(measured) : read_target_curve(wish.curve);
  if (!wish.peak_stress.empty())
    target.peak_stress =
        read_option("--peak-stress", wish.peak_stress, Quantity{Dimension::pressure, above(0), {}});
  if (!wish.peak_strain.empty())
    target.peak_strain =
        read_option("--peak-strain", wish.peak_strain, Quantity{Dimension::ratio, inside(0, 1), {}});
  return target;
}

void check_loading(const mpm::Scene& scene) {
  if (scene.loading.direction != mpm::Direction::none) return;
  throw Rejected(Exit::data, complaint("loading.direction", "none",
                                       "must be tension or compression: a peak is that of a "
                                       "stress-strain curve between platens"));
}

CalibrationTask make_task(const Job& job, Target target, const CalibrationWish& wish) {
  auto parameters = parse_free(wanted_free(wish, target), job.settings, job.scene);
  CalibrationTask task{job.settings, job.specimen, std::move(target), std::move(parameters)};
  task.seeds = read_option("--seeds", wish.seeds, Integer<>{{between(1, 1000), {}}});
  task.evaluations = read_option("--max-evaluations", wish.evaluations, Integer<>{{between(1, 100000), {}}});
  task.tolerance = read_option("--tolerance", wish.tolerance, Quantity{Dimension::ratio, inside(0, 1), {}});
  return task;
}

}  // namespace app
