#include "apps/run/solving.hpp"

#include <fmt/format.h>
#include <utility>

#include "apps/live/progress_line.hpp"
#include "apps/report/run_words.hpp"
#include "apps/run/run_remarks.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/words.hpp"

namespace app {

Outcome solve(const mpm::Scene& scene, const mpm::RunHooks& hooks, const mpm::Checkpoint* from) {
  try {
    return {from != nullptr ? mpm::resume(scene, *from, hooks) : mpm::simulate(scene, hooks), {}};
  } catch (const mpm::Diverged& diverged) {
    return {diverged.result, diverged.what()};
  }
}

Outcome solve(const mpm::Scene& scene, Console& console, const InterruptGuard& guard, mpm::RunHooks hooks,
              const mpm::Checkpoint* from) {
  ProgressLine line(console.err, scene, console.err_is_terminal && !console.quiet);
  hooks.observer = [&, other = std::move(hooks.observer)](const mpm::Progress& progress) {
    line.show(progress);
    return (!other || other(progress)) && !guard.interrupted();
  };
  return solve(scene, hooks, from);
}

mpm::Result end_of_second_run(Outcome outcome) {
  if (!outcome.divergence.empty()) throw NoEstimate{false, outcome.divergence};
  if (outcome.interrupted()) throw NoEstimate{true, "it was interrupted"};
  return std::move(outcome.result);
}

Solve second_run(Console& console, const InterruptGuard& guard) {
  return [&](const mpm::Scene& scene) { return end_of_second_run(solve(scene, console, guard)); };
}

namespace {

output::ErrorEstimate without_peak(Job& job) {
  job.notes.emplace_back("there is no estimate of the error: the run reached no peak");
  return {};
}

}  // namespace

output::ErrorEstimate of_a_peak(output::ErrorEstimate estimate, const Outcome& outcome, Job& job) {
  const bool has_peak = estimate.sources.empty() || !outcome.divergence.empty() || outcome.interrupted() ||
                        mpm::peak_reached(outcome.result);
  return has_peak ? std::move(estimate) : without_peak(job);
}

output::ErrorEstimate estimate_of(const Outcome& outcome, Job& job, const Solve& second) {
  if (!outcome.divergence.empty() || outcome.interrupted()) return {};
  if (!mpm::peak_reached(outcome.result)) return without_peak(job);
  try {
    return estimate_error(job.scene, outcome.result, second);
  } catch (const NoEstimate& failed) {
    job.notes.push_back("there is no estimate of the error: " + failed.why);
    return {};
  }
}

void require_met(const Tolerated& found, double tolerance, const std::string& option) {
  if (found.met) return;
  const bool at_rest = found.scene.method == mpm::SolverMethod::quasi_static;
  const std::string best =
      at_rest ? "without inertia" : "at " + output::concise(found.scene.loading.velocity, 4) + " m/s";
  throw Rejected(Exit::data, option, output::concise(100 * tolerance) + " %",
                 "not met: " + best + " the peak may still be wrong by " +
                     output::percent(found.estimate.stress_error()),
                 "choose a larger tolerance; nothing was written");
}

void adopt(const Tolerated& found, Job& job) {
  for (mpm::Scene* scene : {&job.scene, &job.settings.scene}) {
    scene->loading.velocity = found.scene.loading.velocity;
    scene->cfl = found.scene.cfl;
    scene->precision = found.scene.precision;
    scene->method = found.scene.method;
    scene->event_tolerance = found.scene.event_tolerance;
  }
}

namespace {

/// That a run with a peak did not end as it was asked to.
std::string drop_note(const mpm::Result& result, const mpm::Scene& scene) {
  const bool never = scene.loading.stop_drop && result.stop == mpm::StopReason::strain;
  if (!never || !mpm::peak_reached(result)) return {};
  return "the stress never fell below stop_drop, " + output::percent(*scene.loading.stop_drop, 0) +
         " of its peak, before stop_strain: it is " +
         output::percent(result.history.back().stress / result.peak_stress, 0) + " of it there";
}

}  // namespace

std::vector<Remark> remarks_on(const Outcome& outcome, const mpm::Scene& scene) {
  if (!outcome.divergence.empty()) return {{outcome.divergence, ""}};
  std::vector<Remark> remarks;
  if (const std::int64_t missing = outcome.result.missing_threads; missing > 0)
    remarks.push_back(
        {fmt::format("the system gave {} of {}; the run took those, which changes no bit",
                     outcome.result.threads, counted(outcome.result.threads + missing, "thread")),
         "note"});
  if (outcome.result.nothing_carries)
    remarks.push_back({"nothing carries load any more: every point has failed; the run ended at strain " +
                           strain_text(outcome.result.history.back().strain),
                       "note"});
  if (const std::string note = inertia_note(outcome.result, scene); !note.empty())
    remarks.push_back({note, "warning"});
  if (const std::string note = output::no_peak_text(outcome.result, scene); !note.empty())
    remarks.push_back({note, outcome.interrupted() ? "note" : "warning"});
  if (const std::string note = drop_note(outcome.result, scene); !note.empty())
    remarks.push_back({note, "note"});
  if (const std::string note = energy_note(outcome.result, scene); !note.empty())
    remarks.push_back({note, scene.kinematics != mpm::Kinematics::small_strain ? "note" : "warning"});
  return remarks;
}

}  // namespace app
