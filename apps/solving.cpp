#include "apps/solving.hpp"

#include <utility>

#include "apps/progress_line.hpp"

namespace app {

Outcome solve(const mpm::Scene& scene, Console& console, const InterruptGuard& guard, mpm::RunHooks hooks,
              const mpm::Checkpoint* from) {
  ProgressLine line(console.err, scene, console.err_is_terminal && !console.quiet);
  hooks.observer = [&, other = std::move(hooks.observer)](const mpm::Progress& progress) {
    line.show(progress);
    return (!other || other(progress)) && !guard.interrupted();
  };
  try {
    return {from != nullptr ? mpm::resume(scene, *from, hooks) : mpm::simulate(scene, hooks), {}};
  } catch (const mpm::Diverged& diverged) {
    return {diverged.result, diverged.what()};
  }
}

Solve second_run(Console& console, const InterruptGuard& guard) {
  return [&](const mpm::Scene& scene) {
    Outcome outcome = solve(scene, console, guard);
    if (!outcome.divergence.empty()) throw NoEstimate{false, outcome.divergence};
    if (outcome.interrupted()) throw NoEstimate{true, "it was interrupted"};
    return std::move(outcome.result);
  };
}

}  // namespace app
