/// The true critical time step of a lattice.
#pragma once

#include "libmpm/solver/plan.hpp"
#include "libmpm/scene/scene.hpp"

namespace app::bench {

struct CriticalStep {
  double dt = 0;           ///< 2 / omega_max [s]
  double uncertainty = 0;  ///< residual of omega_max^2 over itself [-]
};

/// Of intact points between their platens, whose motion is given. Lanczos on M^-1/2 K M^-1/2, with K applied
/// point by point and never made; a few hundred nodes take milliseconds.
/// Source: Lanczos (1950), with full reorthogonalization.
[[nodiscard]] CriticalStep critical_step(const mpm::Scene& scene, const mpm::Plan& plan);

}  // namespace app::bench
