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

constexpr double trial = 0.3;                   ///< wall time to measure a speed in [s]
constexpr double long_time = 60;                ///< wall time that is said beforehand [s]
constexpr std::int64_t many_steps = 500'000;    ///< steps that are said beforehand
constexpr double certainly_short = 1e9;         ///< point-updates that no machine takes a minute for
constexpr double certainly_short_states = 1e6;  ///< the same of points in states in equilibrium
// Measured on random specimens of 10,000 to 90,000 points: 240 to 810 states in tension, of 0.1 to 0.3 times
// the time of the first one each, and 300 in compression, of 3 times that time.
constexpr double states_of_a_column = 2;
constexpr double share_of_first = 0.25;
constexpr double share_of_first_pressed = 3;
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

/// Wall time of a state in equilibrium in the mean [s], from that of the first one. Of those after it each
/// begins with the displacements of the one before; where much is broken in compression that helps little.
double time_of_a_state(const mpm::Scene& scene) {
  mpm::Scene start = scene;
  start.frames = 0;
  const mpm::Result result = mpm::simulate(start, {.observer = [](const mpm::Progress&) { return false; }});
  return result.wall_time *
         (scene.loading.direction == mpm::Direction::compression ? share_of_first_pressed : share_of_first);
}

/// Of one point in one step, or in one state in equilibrium [s].
double time_of_an_update(const mpm::Scene& scene) {
  const auto points = static_cast<double>(std::max<std::int64_t>(1, mpm::count_points(scene)));
  if (scene.method == mpm::SolverMethod::quasi_static) return time_of_a_state(scene) / points;
  return time_of_a_step(scene, mpm::plan(scene), mpm::count_points(scene)) / points;
}

/// States in equilibrium that a run may have, roughly: cracks are as long as the specimen is wide, and points
/// break one by one. One, where nothing can break.
std::int64_t expected_states(const mpm::Scene& scene, std::int64_t points) {
  const bool can_fail = std::any_of(scene.phases.begin(), scene.phases.end(),
                                    [](const auto& phase) { return phase && phase->can_fail(); });
  return can_fail ? std::llround(states_of_a_column * std::sqrt(static_cast<double>(points))) : 1;
}

bool is_certainly_short(double updates, bool quasi_static) {
  return updates < (quasi_static ? certainly_short_states : certainly_short);
}

}  // namespace

std::string duration_text(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  if (seconds < 100 * 60) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 48 * 3600) return fmt::format("{:.1f} h", seconds / 3600);
  return fmt::format("{:.0f} days", seconds / 86400);
}

RunSize size_of(const mpm::Scene& scene) {
  const std::int64_t points = mpm::count_points(scene);
  const mpm::Plan plan = mpm::plan(scene);
  if (scene.method == mpm::SolverMethod::quasi_static) return {points, expected_states(scene, points), true};
  return {points, plan.steps};
}

namespace {

/// Of the runs of one method.
double time_of_method(const std::vector<RunSize>& runs, bool quasi_static,
                      const std::function<mpm::Scene(std::size_t)>& sample, int workers) {
  double updates = 0;
  std::size_t largest = runs.size();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].quasi_static != quasi_static) continue;
    updates += runs[i].updates();
    if (largest == runs.size() || runs[i].updates() > runs[largest].updates()) largest = i;
  }
  if (is_certainly_short(updates, quasi_static)) return 0;
  mpm::Scene alone = sample(largest);
  alone.threads = 1;
  return time_of_an_update(alone) * std::max(updates / std::max(workers, 1), runs[largest].updates());
}

}  // namespace

double time_of_runs(const std::vector<RunSize>& runs, const std::function<mpm::Scene(std::size_t)>& sample,
                    int workers) try {
  return time_of_method(runs, false, sample, workers) + time_of_method(runs, true, sample, workers);
} catch (const mpm::Diverged&) {  // the run itself will say it
  return 0;
}

std::string size_text(const std::vector<RunSize>& runs) {
  std::int64_t points = 0, steps = 0, states = 0;
  for (const RunSize& run : runs) {
    points = std::max(points, run.points);
    std::int64_t& most = run.quasi_static ? states : steps;
    most = std::max(most, run.steps);
  }
  std::string text = fmt::format("{} points", points);
  if (steps > 0) text += fmt::format(" and {} steps", steps);
  if (states > 0)
    text += fmt::format("{} roughly {} states in equilibrium", steps > 0 ? " or" : " and", states);
  return text;
}

const char* precision_word(const std::vector<RunSize>& runs, bool may_end_before) {
  const bool is_rough =
      std::any_of(runs.begin(), runs.end(), [](const RunSize& run) { return run.quasi_static; });
  return is_rough ? "roughly" : may_end_before ? "up to" : "about";
}

bool is_long(double seconds) { return seconds >= long_time; }

RunLength length_of(const mpm::Scene& scene) try {
  const RunSize size = size_of(scene);
  const bool has_many_steps = !size.quasi_static && size.steps >= many_steps;
  if (!has_many_steps && is_certainly_short(size.updates(), size.quasi_static)) return {};
  const double expected = size.updates() * time_of_an_update(scene);
  if (!has_many_steps && !is_long(expected)) return {};
  const char* word = precision_word({size}, scene.loading.stop_drop.has_value());
  const std::string steps = size.quasi_static ? "" : fmt::format(" of {:.3g} s", mpm::plan(scene).dt);
  return {expected, fmt::format("a run of {}{}, which takes {} {} here", size_text({size}), steps, word,
                                duration_text(expected))};
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
