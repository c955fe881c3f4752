/// A plate drawn as pixels under slow, damped tension between smooth platens, and the stress of its points.
#pragma once

#include <cmath>
#include <vector>

#include "libmpm/lattice_solver.hpp"
#include "tests/libmpm/moving_scenes.hpp"

namespace samples {

/// A square of two elastic phases, nu 0.2 each, everything the first. Its pixels are all of one size over the
/// width, so that the number of steps grows with theirs and the load stays the same.
inline mpm::Scene plate(int pixels, double ratio_of_moduli = 2) {
  mpm::Scene scene;
  scene.labels.setConstant(pixels, pixels, soft);
  scene.pixel_size = 1.0 / pixels;
  mpm::Phase phase;
  phase.name = "matrix";
  phase.young = 1e7;
  phase.poisson = 0.2;
  phase.density = 1000;
  scene.phases = {std::nullopt, phase};
  phase.young *= ratio_of_moduli;
  scene.phases.emplace_back(phase);
  scene.loading.velocity = 0.01;
  scene.loading.stop_strain = 1e-3;
  scene.local_damping = 0.6;
  scene.motion.margin = 0.05;
  return scene;
}

/// Draws a disc in the middle, its radius in widths of the plate.
inline void draw_disc(mpm::Scene& scene, double radius, std::uint8_t label) {
  const auto n = static_cast<double>(scene.labels.rows());
  for (int row = 0; row < scene.labels.rows(); ++row)
    for (int col = 0; col < scene.labels.cols(); ++col)
      if (std::hypot(col + 0.5 - 0.5 * n, row + 0.5 - 0.5 * n) < radius * n) scene.labels(row, col) = label;
}

/// Stress of the point of a pixel over the mean stress of the platens, at its place from the middle [m].
struct PlateStress {
  double x = 0, y = 0;
  std::uint8_t label = 0;
  mpm::Stress<double> stress;
};
struct StaticPlate {
  std::vector<PlateStress> points;
  double modulus = 0;  ///< mean stress over strain [Pa]
};

inline StaticPlate solve(mpm::Scene scene) {
  StaticPlate result;
  const mpm::Plan plan = mpm::plan(scene);
  const auto add = [&](std::uint32_t id, const mpm::Stress<double>& s, double load) {
    const auto cols = static_cast<std::uint32_t>(scene.labels.cols());
    const int row = static_cast<int>(id / cols);
    const int col = static_cast<int>(id % cols);
    result.points.push_back({(col + 0.5) * scene.pixel_size - 0.5 * scene.width(),
                             0.5 * scene.height() - (row + 0.5) * scene.pixel_size,
                             scene.labels(row, col),
                             {s.xx / load, s.yy / load, s.xy / load}});
  };
  const auto load_of = [&](const mpm::Ledger& ledger) {
    const double load = 0.5 * (ledger.force_top - ledger.force_bottom) / scene.width();
    result.modulus = load / (ledger.platen_displacement / scene.height());
    return load;
  };
  if (scene.kinematics == mpm::Kinematics::moving) {
    mpm::MovingSolver<double> solver(scene, plan, mpm::start_of(scene, plan));
    const double load = load_of(solver.advance(1000000));
    for (const auto& p : solver.points()) add(p.id, p.stress, load);
  } else {
    mpm::LatticeSolver<double> solver(scene, plan);
    const double load = load_of(solver.advance(1000000));
    for (const auto& p : solver.hand_over().points) add(p.id, p.stress, load);
  }
  return result;
}

}  // namespace samples
