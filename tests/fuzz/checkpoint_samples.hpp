/// Small runs whose checkpoints are tried, one for each way in which a state is laid out.
#pragma once

#include <optional>
#include <vector>

#include "libmpm/run/simulate.hpp"
#include "tests/libmpm/kinds_of_runs.hpp"

namespace fuzz {

/// On the instructions that every machine has, so that checkpoints are the same everywhere.
inline std::vector<mpm::Scene> checkpoint_scenes() {
  using namespace samples::kinds;
  mpm::Scene small = samples::pulled(samples::mortar_block(6, 6));
  small.labels(3, 3) = samples::aggregate;
  small.loading.velocity = 0.5;
  small.history_rows = 40;
  small.frames = 4;
  mpm::Scene softening = small;
  for (auto& phase : softening.phases)
    if (phase && phase->can_crack()) phase->fracture_energy = 60;
  mpm::Scene denser = small;
  denser.extra_points = {{0.6e-3, 1.1e-3, samples::itz}, {2.2e-3, 1.9e-3, samples::mortar}};
  std::vector<mpm::Scene> scenes{small,
                                 softening,
                                 denser,
                                 in_single(small),
                                 moving(small),
                                 in_single(moving(small)),
                                 handed_over(small)};
  for (mpm::Scene& scene : scenes) {
    scene.instruction_set = "baseline";
    scene.threads = 1;
  }
  return scenes;
}

/// Where a run is after some rows of its history; nothing when it has come to its end by then.
inline std::optional<mpm::Checkpoint> checkpoint_after(const mpm::Scene& scene, int rows) {
  std::optional<mpm::Checkpoint> last;
  mpm::RunHooks hooks;
  hooks.observer = [&](const mpm::Progress&) { return --rows > 0; };
  hooks.checkpoints.sink = [&](const mpm::Checkpoint& checkpoint) { last = checkpoint; };
  (void)mpm::simulate(scene, hooks);
  return last;
}

}  // namespace fuzz
