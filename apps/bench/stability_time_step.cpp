// On both sides of the critical time step.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/bench/stability_scenes.hpp"
#include "libmpm/solver/lattice/cell_limit.hpp"

namespace app::bench {
namespace {

/// A plan with a time step of its own that takes so many steps.
mpm::Plan with_step(const mpm::Scene& scene, double dt, std::int64_t steps, std::int64_t rows) {
  mpm::Plan plan = mpm::plan(scene);
  plan.dt = dt;
  plan.steps = steps;
  plan.steps_per_row = std::max<std::int64_t>(1, steps / rows);
  return plan;
}

/// Largest sum of kinetic and elastic energy over the work of the platens [-].
double most_energy(const mpm::Result& result) {
  double most = 0;
  for (const mpm::HistoryRow& row : result.history)
    if (row.platen_work > 0) most = std::max(most, (row.kinetic + row.elastic) / row.platen_work);
  return most;
}

/// A step a little too long must be found out within this many.
constexpr std::int64_t patience = 2000;

/// The bound from the cells, the true critical step, a run below it that stays, one above it that is stopped.
Finding both_sides(const mpm::Scene& scene) {
  const mpm::Plan plan = mpm::plan(scene);
  const CriticalStep critical = critical_step(scene, plan);
  const double bound = mpm::cell_limit(scene, plan);
  const double per_cfl = plan.dt / scene.cfl;
  Judge judge;
  judge.must(critical.uncertainty < 1e-4 && bound <= critical.dt * (1 + 1e-6),
             fmt::format("bound from the cells {:.4g} s (CFL {:.3f}) below the true {:.4g} s (CFL {:.3f})",
                         bound, bound / per_cfl, critical.dt, critical.dt / per_cfl));
  const Attempt below = attempt(scene, with_step(scene, 0.99 * critical.dt, 20'000, 1000));
  judge.must(!below.diverged, "0.99 of it runs 20 000 steps");
  judge.below("with energy over work less 1", most_energy(below.result) - 1, 1e-6);
  const Attempt above = attempt(scene, with_step(scene, 1.05 * critical.dt, 20'000, 1000));
  judge.must(above.diverged && above.result.steps <= patience,
             above.diverged ? fmt::format("1.05 of it is stopped at step {}", above.result.steps)
                            : std::string("1.05 of it is NOT stopped"));
  return judge.finding();
}

/// Points alone in their cells, with less mass at their nodes than a full cell gives.
Finding in_thin_chains() {
  mpm::Scene scene = block(16, 16, elastic());
  scene.labels.setConstant(0);
  for (int i = 0; i < 16; ++i) scene.labels(i, i) = first;
  return both_sides(scene);
}

/// Of a point alone at the corner of its cell, over the time a wave takes over the cell: its nodes weigh w_i
/// m, the sum of (dw_i/dx)^2 / w_i is 1 / (a (1 - a)) with a = 1 / (2 k), and it swings fastest when it
/// swells.
double cfl_of_lone_point(int points_per_cell, double poisson) {
  const double a = 0.5 / points_per_cell;
  return 2 * std::sqrt((1 - poisson) * a * (1 - a));
}

/// No picture bears less without extra points: any other point in the cell brings mass to those nodes.
Finding lone_points() {
  Judge judge;
  for (const double poisson : {0.2, 0.4999}) {
    for (const int k : {1, 2, 3, 4}) {
      mpm::Scene scene = block(3 * k, 3 * k, elastic(20e9, poisson));
      scene.labels.setConstant(0);
      scene.labels(k, k) = first;
      scene.points_per_cell = k;
      const mpm::Plan plan = mpm::plan(scene);
      const double exact = cfl_of_lone_point(k, poisson);
      const double per_cfl = plan.dt / scene.cfl;
      judge.near(fmt::format("nu {:g}, {} x {} points: CFL of the bound", poisson, k, k),
                 mpm::cell_limit(scene, plan) / per_cfl, exact, 1e-9);
      judge.near("true", critical_step(scene, plan).dt / per_cfl, exact, 1e-6);
    }
  }
  return judge.finding();
}

Finding million_steps() {
  const mpm::Scene scene = block(8, 8, elastic());
  const double dt = 0.99 * critical_step(scene, mpm::plan(scene)).dt;
  const Attempt run = attempt(scene, with_step(scene, dt, 1'000'000, 1000));
  const mpm::Result& result = run.result;
  return Judge()
      .must(!run.diverged && result.steps >= 1'000'000, fmt::format("{} steps", result.steps))
      .below("ledger off by", result.energy_error, 1e-8)
      .below("energy over work less 1", most_energy(result) - 1, 1e-6)
      .near("modulus", end_modulus(result), plane_modulus(*scene.phases[first]), 1e-3)
      .finding();
}

/// The longest step that the program takes, on full cells.
Finding largest_cfl() {
  mpm::Scene scene = block(8, 8, elastic());
  scene.cfl = 0.99;
  const mpm::Plan plan = mpm::plan(scene);
  const double share = plan.dt / critical_step(scene, plan).dt;
  const Attempt run = attempt(scene, with_step(scene, plan.dt, 1'000'000, 1000));
  return Judge()
      .note(fmt::format("solver.cfl 0.99 is {:.3f} of the critical step", share))
      .must(!run.diverged, fmt::format("{} steps", run.result.steps))
      .below("energy over work less 1", most_energy(run.result) - 1, 1e-6)
      .finding();
}

/// A pixel a hundred times as stiff as the others.
mpm::Scene with_stiff_pixel() {
  mpm::Scene scene = block(16, 16, elastic());
  scene.phases.emplace_back(elastic(2000e9));
  scene.phases[second]->name = "stiff";
  scene.labels(5, 9) = second;
  return scene;
}

/// With a row of the history at the very end nobody looks at the energy before: numbers overflow.
Finding seen_without_a_look() {
  const mpm::Scene scene = with_stiff_pixel();
  const double dt = 1.5 * critical_step(scene, mpm::plan(scene)).dt;
  const Attempt run = attempt(scene, with_step(scene, dt, 100'000, 1));
  const std::string said = run.diverged.value_or("nothing");
  return Judge()
      .must(said.find("motion is not a number at step ") == 0 &&
                said.find("worst at the point of pixel (row ") != said.npos &&
                said.find("solver.cfl: ") != said.npos,
            fmt::format("it says: {}", said))
      .must(!run.result.history.empty() && is_finite(run.result), "what was computed before is kept")
      .finding();
}

/// The point, its phase, and a time step that is safe.
Finding names_the_place() {
  const mpm::Scene scene = with_stiff_pixel();
  const double dt = 1.05 * critical_step(scene, mpm::plan(scene)).dt;
  const Attempt run = attempt(scene, with_step(scene, dt, 100'000, 10'000));
  const std::string said = run.diverged.value_or("nothing");
  return Judge()
      .must(said.find("worst at the point of pixel (row 5, column 9), stiff") != said.npos,
            fmt::format("it says: {}", said))
      .finding();
}

}  // namespace

std::vector<StabilityCase> time_step_cases() {
  const std::string sides =
      ": the bound from the cells below the true critical step 2 / omega_max; 0.99 of that "
      "stays, 1.05 is stopped within 2000 steps";
  return {
      {"step-uniform", "one phase" + sides, [] { return both_sides(block(16, 16, elastic())); }},
      {"step-concrete", "concrete" + sides, [] { return both_sides(unbreakable(concrete(40, 40))); }},
      {"step-contrast", "stiffness 1 to 1e6 by turns" + sides,
       [] { return both_sides(checkerboard(elastic(), elastic(20e3))); }},
      {"step-density", "density 1 to 2e4 by turns" + sides,
       [] { return both_sides(checkerboard(elastic(20e9, 0.2, 1), elastic(20e9, 0.2, 2e4))); }},
      {"step-chains", "points alone in their cells" + sides, in_thin_chains},
      {"lone-points",
       "a limit: points alone at the corner of their cell bear the least of all. The CFL number of 0.5 is "
       "safe for "
       "any picture, but for 4 x 4 points a cell with Poisson's ratio above 0.43",
       lone_points},
      {"million-steps", "0.99 of the critical step for 1e6 steps: no energy from nowhere", million_steps},
      {"largest-cfl", "solver.cfl 0.99 on full cells for 1e6 steps: no energy from nowhere", largest_cfl},
      {"not-a-number",
       "numbers that overflow before anybody looks: step, point, phase and a safe CFL are told, what was "
       "computed "
       "is kept",
       seen_without_a_look},
      {"worst-point", "one stiff pixel that bears less than the step: it is named with its phase",
       names_the_place},
  };
}

}  // namespace app::bench
