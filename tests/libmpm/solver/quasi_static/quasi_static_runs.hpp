/// What tests of the quasi-static solver do with a run.
#pragma once

#include "libmpm/run/simulate.hpp"

namespace samples {

/// Gives phases that can crack a fracture energy [J/m2]; 0 = brittle.
inline void set_fracture_energy(mpm::Scene& scene, double energy) {
  for (auto& phase : scene.phases)
    if (phase && phase->can_crack()) {
      phase->fracture_energy = energy;
      phase->weibull_modulus = energy > 0 ? 4 : 1.5;
    }
}

struct Interrupted {
  mpm::Result half;
  mpm::Checkpoint kept;
};

/// A run that stops after so many rows of the history.
inline Interrupted stopped_after(const mpm::Scene& scene, int rows) {
  Interrupted run;
  mpm::RunHooks hooks;
  hooks.observer = [&](const mpm::Progress&) { return --rows > 0; };
  hooks.checkpoints.sink = [&](const mpm::Checkpoint& checkpoint) { run.kept = checkpoint; };
  run.half = mpm::simulate(scene, hooks);
  return run;
}

/// Work of the platens by the trapezoidal rule [J/m].
inline double area_under(const mpm::Result& result, const mpm::Scene& scene) {
  double area = 0;
  for (std::size_t i = 1; i < result.history.size(); ++i)
    area += 0.5 * (result.history[i].stress + result.history[i - 1].stress) *
            (result.history[i].strain - result.history[i - 1].strain);
  return area * scene.width() * scene.height();
}

}  // namespace samples
