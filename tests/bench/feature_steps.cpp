// Takes steps of a case of `mesopix bench features`, for tools that count what a program does.
// Usage: feature_steps CASE without|with STEPS; without arguments it lists the cases.
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

#include "apps/bench/feature_study.hpp"
#include "libmpm/run/simulate.hpp"

int main(int argc, char** argv) {
  const auto cases = app::bench::all_features(60);
  if (argc != 4) {
    for (const auto& it : cases) std::cout << it.feature << ", " << it.kinematics << '\n';
    return argc == 1 ? 0 : 64;
  }
  const auto& it = cases.at(std::stoul(argv[1]));
  mpm::Scene scene = it.make();
  scene.instruction_set = "avx2";  // the widest that Valgrind knows
  scene.loading.velocity = 1e-3;   // nothing fails: what that loads is no part of the sweep
  mpm::Plan plan = mpm::plan(scene);
  if (std::string(argv[2]) == "with") it.add(plan);

  plan.steps_per_row = it.feature == "energies at every step" && std::string(argv[2]) == "with" ? 1 : 10;
  const std::int64_t steps = std::stoll(argv[3]);
  std::int64_t rows = 0;
  const mpm::Result result = mpm::simulate(
      scene, plan, {.observer = [&](const mpm::Progress&) { return ++rows * plan.steps_per_row < steps; }});
  std::cout << result.points << ' ' << result.steps << ' ' << result.tension_failures << '\n';
  return 0;
}
