// Points a cell, and where they stand in it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/bench/stability_scenes.hpp"
#include "libmpm/solver/lattice/cell_limit.hpp"

namespace app::bench {
namespace {

/// The same scene with points that move [Pa].
double moving_modulus(mpm::Scene scene) {
  scene.kinematics = mpm::Kinematics::moving;
  return end_modulus(mpm::simulate(scene));
}

Finding one_per_cell() {
  mpm::Scene whole = block(12, 12, elastic());
  whole.points_per_cell = 1;
  load_slowly(whole);
  mpm::Scene breaking = concrete(30, 30);
  breaking.points_per_cell = 1;
  const mpm::Result broken = mpm::simulate(breaking);
  return Judge()
      .near("modulus", end_modulus(mpm::simulate(whole)), plane_modulus(*whole.phases[first]), 2e-3)
      .near("of moving points", moving_modulus(whole), plane_modulus(*whole.phases[first]), 5e-2)
      .must(broken.tension_failures > 50, fmt::format("of concrete {} points fail", broken.tension_failures))
      .below("ledger off by", broken.energy_error, 1e-9)
      .finding();
}

/// Points of a phase at places that cover the picture evenly and follow no pattern of its cells.
void scatter(mpm::Scene& scene, int count, std::uint8_t phase) {
  const double g = 1.32471795724474602596;  // the plastic number
  for (int i = 1; i <= count; ++i)
    scene.extra_points.push_back(
        {std::fmod(i / g, 1.0) * scene.width(), std::fmod(i / (g * g), 1.0) * scene.height(), phase});
}

/// 4 of pixels and 16 more.
Finding twenty_per_cell() {
  mpm::Scene whole = block(12, 12, elastic());
  scatter(whole, 36 * 16, first);
  load_slowly(whole);
  mpm::Scene breaking = concrete(20, 20);
  scatter(breaking, 100 * 16, third);
  const mpm::Result broken = mpm::simulate(breaking);
  return Judge()
      .near("modulus", end_modulus(mpm::simulate(whole)), plane_modulus(*whole.phases[first]), 1e-2)
      .near("of moving points", moving_modulus(whole), plane_modulus(*whole.phases[first]), 5e-2)
      .must(broken.tension_failures > 200 && broken.points == 2000,
            fmt::format("of concrete {} of {} points fail", broken.tension_failures, broken.points))
      .below("ledger off by", broken.energy_error, 1e-9)
      .finding();
}

/// Every node of the grid, its edges and corners too.
void put_on_nodes(mpm::Scene& scene) {
  const double cell = scene.pixel_size * scene.points_per_cell;
  for (int row = 0; row * cell <= scene.height() * (1 + 1e-12); ++row)
    for (int col = 0; col * cell <= scene.width() * (1 + 1e-12); ++col)
      scene.extra_points.push_back(
          {std::min(col * cell, scene.width()), std::min(row * cell, scene.height()), first});
}

Finding on_a_node() {
  mpm::Scene scene = block(12, 12, elastic());
  put_on_nodes(scene);
  load_slowly(scene);
  const double exact = plane_modulus(*scene.phases[first]);
  Judge judge;
  judge.near("modulus on the lattice", end_modulus(mpm::simulate(scene)), exact, 1e-2);
  scene.kinematics = mpm::Kinematics::moving;
  for (const auto& [shape, name] :
       {std::pair{mpm::Shape::linear, "linear"}, std::pair{mpm::Shape::gimp, "GIMP"},
        std::pair{mpm::Shape::bspline, "B-spline"}}) {
    scene.motion.shape = shape;
    const mpm::Result result = mpm::simulate(scene);
    judge.near(name, end_modulus(result), exact, 5e-2);
  }
  return judge.finding();
}

/// A point that all but stands on a node of void has next to no mass at the nodes across the cell, and all
/// its stiffness there: what a CFL of 0.5 means to full cells is far too long.
Finding beside_a_node_in_void() {
  mpm::Scene scene = block(8, 8, elastic());
  scene.labels.rightCols(4).setConstant(0);
  const double cell = 2 * scene.pixel_size;
  scene.extra_points = {{2 * cell + 1e-4 * cell, 2 * cell + 1e-4 * cell, first}};
  const mpm::Plan plan = mpm::plan(scene);
  const double bound = mpm::cell_limit(scene, plan);
  Judge judge;
  judge.must(bound < 0.1 * plan.dt,
             fmt::format("bound from the cells {:.2g} of the time step", bound / plan.dt));
  const Attempt run = attempt(scene);
  judge.must(run.diverged && run.diverged->find("extra point 0, elastic") != std::string::npos &&
                 run.diverged->find("solver.cfl: ") != std::string::npos,
             fmt::format("it says: {}", run.diverged.value_or("nothing")));
  scene.cfl *= 0.9 * bound / plan.dt;
  scene.loading.velocity = 5;
  judge.must(!attempt(scene).diverged, fmt::format("with solver.cfl {:.2g} it runs", scene.cfl));
  return judge.finding();
}

}  // namespace

std::vector<StabilityCase> point_cases() {
  return {
      {"one-point-a-cell", "one point a cell: E / (1 - nu^2), energies that close while it breaks",
       one_per_cell},
      {"twenty-points-a-cell", "twenty points a cell, sixteen at any place: the same", twenty_per_cell},
      {"point-on-a-node", "a point on every node, corners too: E / (1 - nu^2), on the lattice and moving",
       on_a_node},
      {"point-beside-a-node",
       "a limit: a point alone in void beside a node bears next to no step; it is stopped, named, and told a "
       "CFL "
       "that is safe",
       beside_a_node_in_void},
  };
}

}  // namespace app::bench
