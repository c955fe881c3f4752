/// Bodies of moving points that fly, turn and meet.
/// The true critical time step of a lattice.
#pragma once

#include <vector>

#include "libmpm/scene/scene.hpp"
#include "libmpm/solver/moving/moving_solver.hpp"
#include "libmpm/solver/plan.hpp"

namespace app::bench {

/// Void with room for bodies of a soft phase, label 1, in which waves run at 100 m/s: Young's modulus 10 MPa,
/// density 1000 kg/m^3, no Poisson's effect. Pixels of 50 mm, no platens.
[[nodiscard]] mpm::Scene sky(int rows, int cols);

/// Puts a disc there; places in pixels from the lower left corner.
void add_disc(mpm::Scene& scene, double x, double y, double radius);

/// Sums over points.
struct Sums {
  double mass = 0;     ///< [kg/m]
  double px = 0;       ///< momentum [kg/s]
  double py = 0;       ///< [kg/s]
  double x = 0;        ///< centre of mass [m]
  double y = 0;        ///< [m]
  double spin = 0;     ///< angular momentum about that centre [kg m/s]
  double kinetic = 0;  ///< [J/m]
};
[[nodiscard]] Sums sums_of(const std::vector<mpm::PointView>& points);

/// A scene with its plan and its solver.
struct Flight {
  mpm::Scene scene;
  mpm::Plan plan;
  mpm::MovingSolver<double> solver;

  explicit Flight(mpm::Scene what)
      : scene(std::move(what)), plan(mpm::plan(scene)), solver(scene, plan, mpm::start_of(scene, plan)) {}
  Flight(const Flight&) = delete;
  Flight& operator=(const Flight&) = delete;
};

struct CriticalStep {
  double dt = 0;           ///< 2 / omega_max [s]
  double uncertainty = 0;  ///< residual of omega_max^2 over itself [-]
};

/// Of intact points between their platens, whose motion is given. Lanczos on M^-1/2 K M^-1/2, with K applied
/// point by point and never made; a few hundred nodes take milliseconds.
/// Source: Lanczos (1950), with full reorthogonalization.
[[nodiscard]] CriticalStep critical_step(const mpm::Scene& scene, const mpm::Plan& plan);

}  // namespace app::bench
