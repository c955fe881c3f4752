#include "apps/run/run_length.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "apps/text/complaint.hpp"
#include "libmpm/run/simulate.hpp"
#include "libmpm/solver/plan.hpp"

namespace app {
namespace {

constexpr double trial = 0.3;                  ///< wall time to measure a speed in [s]
constexpr double long_time = 60;               ///< wall time that is said beforehand [s]
constexpr std::int64_t many_steps = 500'000;   ///< steps that are said beforehand
constexpr double certainly_short = 1e9;        ///< point-updates that no machine takes a minute for
constexpr std::int64_t most_rows = 1'000'000;  ///< of the history of a trial
constexpr double updates_of_a_row = 1e7;       ///< point-updates between two looks at the clock
constexpr double unasked_time = 600;           ///< wall time that a picture may take unasked [s]
constexpr double usual_speed = 1e8;            ///< point-updates per second, where none can be measured

/// Wall time per step [s], from the first of them.
double time_of_a_step(const mpm::Scene& scene, const mpm::Plan& plan, std::int64_t points) {
  const double rows =
      std::min(static_cast<double>(plan.steps),
               std::ceil(static_cast<double>(plan.steps) * static_cast<double>(points) / updates_of_a_row));
  if (rows > static_cast<double>(100 * most_rows)) return static_cast<double>(points) / usual_speed;
  mpm::Scene start = scene;
  start.frames = 0;
  start.history_rows = static_cast<int>(std::clamp(rows, 10.0, static_cast<double>(most_rows)));
  const auto goes_on = [](const mpm::Progress& progress) { return progress.wall_time < trial; };
  const mpm::Result result = mpm::simulate(start, {.observer = goes_on});
  return result.wall_time / static_cast<double>(std::max<std::int64_t>(result.steps, 1));
}

}  // namespace

std::string duration_text(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  if (seconds < 100 * 60) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 48 * 3600) return fmt::format("{:.1f} h", seconds / 3600);
  return fmt::format("{:.0f} days", seconds / 86400);
}

RunSize size_of(const mpm::Scene& scene) {
  if (scene.method == mpm::SolverMethod::quasi_static) return {};
  return {mpm::count_points(scene), mpm::plan(scene).steps};
}

double time_of_runs(const std::vector<RunSize>& runs, const std::function<mpm::Scene()>& sample,
                    int workers) try {
  double updates = 0, longest = 0;
  for (const RunSize& run : runs) {
    updates += run.updates();
    longest = std::max(longest, run.updates());
  }
  if (updates < certainly_short) return 0;
  mpm::Scene alone = sample();
  alone.threads = 1;
  const std::int64_t points = mpm::count_points(alone);
  const double of_an_update =
      time_of_a_step(alone, mpm::plan(alone), points) / std::max(1.0, static_cast<double>(points));
  return of_an_update * std::max(updates / std::max(workers, 1), longest);
} catch (const mpm::Diverged&) {  // the run itself will say it
  return 0;
}

bool is_long(double seconds) { return seconds >= long_time; }

RunLength length_of(const mpm::Scene& scene) try {
  if (scene.method == mpm::SolverMethod::quasi_static) return {};
  const mpm::Plan plan = mpm::plan(scene);
  const std::int64_t points = mpm::count_points(scene);
  if (plan.steps < many_steps && size_of(scene).updates() < certainly_short) return {};
  const double expected = static_cast<double>(plan.steps) * time_of_a_step(scene, plan, points);
  if (plan.steps < many_steps && expected < long_time) return {};
  const char* ended = scene.loading.stop_drop ? "up to" : "about";
  return {expected, fmt::format("a run of {} points and {} steps of {:.3g} s, which takes {} {} here", points,
                                plan.steps, plan.dt, ended, duration_text(expected))};
} catch (const mpm::Diverged&) {  // the run itself will say it
  return {};
}

std::string announcement(const mpm::Scene& scene) { return length_of(scene).text; }

void refuse_unasked_length(const RunLength& length, int columns) {
  if (!(length.seconds > unasked_time)) return;
  // Points grow with the square of the columns, and steps with them.
  const double enough = columns * std::cbrt(0.5 * unasked_time / length.seconds);
  throw Rejected(
      Exit::data, "convert.pixels", fmt::format("auto, {} columns", columns),
      length.text + "; runs of a picture of more than " + duration_text(unasked_time) + " must be asked for",
      fmt::format("give {0} {1:.0f} for about {2}, or {0} {3} for all of it", option_name("convert.pixels"),
                  std::max(1.0, std::floor(enough)), duration_text(0.5 * unasked_time), columns));
}

}  // namespace app
