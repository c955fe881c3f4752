#include "apps/bench/problem_table.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <utility>

#include "apps/text/complaint.hpp"
#include "apps/text/words.hpp"

namespace app::bench {
namespace {

using reproduce::Setting;
using Settings = std::vector<Setting>;

Settings joined(Settings first, const Settings& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

Setting velocity(double value) { return {"loading.velocity", fmt::format("{:g} m/s", value)}; }
Setting pixel(double millimetres) { return {"generate.pixel_size", fmt::format("{:g} mm", millimetres)}; }

using Quantity = double (*)(const mpm::Result&);

Run run_of(const Settings& settings, Quantity quantity) {
  return [trial = reproduce::Trial{"tension", settings, false}, quantity] {
    const mpm::Result result = reproduce::run_trial(trial, [] { return true; }).result;
    return Measured{quantity(result), result.wall_time, result.points * result.steps, {}};
  };
}

double peak(const mpm::Result& result) { return result.peak_stress; }
double secant(const mpm::Result& result) {
  return result.history.back().stress / result.history.back().strain;
}

/// @param setting_of  what a size stands for in the scene.
Method method_of(const std::string& name, const std::string& refined, const std::string& unit,
                 const std::vector<double>& sizes, Setting (*setting_of)(double), const Settings& settings,
                 Quantity quantity) {
  Method method{name, refined, unit, sizes, {}};
  for (const double size : sizes)
    method.runs.push_back(run_of(joined(settings, {setting_of(size)}), quantity));
  return method;
}

Settings moving(const std::string& shape) {
  return {{"solver.kinematics", "moving"}, {"motion.shape", shape}};
}

}  // namespace

Problem tension_problem(const Settings& settings) {
  const Settings common = joined(
      {{"loading.stop_strain", "2e-4"}, {"loading.stop_drop", "0.5"}, {"solver.cfl", "0.8"}}, settings);
  const auto over_velocity = [&](const std::string& name, const std::vector<double>& velocities,
                                 const Settings& more) {
    return method_of(name, "velocity", "m/s", velocities, velocity, joined(common, more), peak);
  };
  Problem problem{
      "tension",
      "The paper's tension test",
      "error of the peak stress",
      "a run with the platen at 0.01 m/s and CFL 0.25, in double precision",
      "How slowly a test must be loaded, and what step, precision and kinematics add. Runs scatter by a "
      "per cent or two, for each breaks in another order. Damping leads to another peak: it takes from the "
      "cascades in which points overload each other. The last line takes coarser pixels instead: the law "
      "that fails points at once depends on them, so that it need not converge, and is near by chance.",
      run_of(joined(common, {velocity(0.01), {"solver.cfl", "0.25"}}), peak),
      {}};
  const std::vector<double> slower{0.4, 0.2, 0.1, 0.05, 0.02};
  problem.methods = {over_velocity("small strain CFL 0.8", slower, {{"solver.cfl", "0.8"}}),
                     over_velocity("small strain CFL 0.5", slower, {{"solver.cfl", "0.5"}}),
                     over_velocity("small strain CFL 0.25", {0.4, 0.2, 0.1, 0.05}, {{"solver.cfl", "0.25"}}),
                     over_velocity("small strain single", slower, {{"solver.precision", "single"}}),
                     over_velocity("small strain, damping 0.1", slower, {{"solver.local_damping", "0.1"}}),
                     over_velocity("moving linear", {0.4, 0.2}, moving("linear")),
                     over_velocity("moving GIMP", {0.4, 0.2}, moving("gimp")),
                     over_velocity("moving B-spline", {0.4, 0.2}, moving("bspline")),
                     method_of("coarser pixels", "pixel", "mm", {2.5, 1.5, 1, 0.75}, pixel,
                               joined(common, {velocity(0.05)}), peak)};
  return problem;
}

Problem modulus_problem(const Settings& settings) {
  const std::string unbreakable = "unbreakable";
  const Settings common = joined({{"itz.mode", "none"},
                                  {"loading.stop_strain", "5e-5"},
                                  {"solver.local_damping", "0.3"},
                                  {"phases.mortar.tensile_scale", unbreakable},
                                  {"phases.mortar.cohesion", unbreakable}},
                                 settings);
  const auto over_pixels = [&](const std::string& name, const std::vector<double>& pixels,
                               const Settings& more) {
    return method_of(name, "pixel", "mm", pixels, pixel, joined(common, more), secant);
  };
  Problem problem{"modulus",
                  "Young's modulus of the random specimen",
                  "error of the modulus",
                  "the same ellipses in pixels of 0.25 mm, the platen at 0.05 m/s",
                  "Shapes drawn as pixels, against the pixel; the slow start of the loading is in all runs.",
                  run_of(joined(common, {pixel(0.25), velocity(0.05)}), secant),
                  {}};
  problem.methods = {
      over_pixels("small strain", {3, 1.5, 1, 0.5}, {velocity(0.05)}),
      over_pixels("small strain, 0.2 m/s", {3, 1.5, 1, 0.5}, {velocity(0.2)}),
      over_pixels("small strain single", {3, 1.5, 1, 0.5}, {velocity(0.05), {"solver.precision", "single"}}),
      over_pixels("moving GIMP", {3, 1.5, 1}, joined(moving("gimp"), {velocity(0.05)})),
      over_pixels("moving B-spline", {3, 1.5, 1}, joined(moving("bspline"), {velocity(0.05)}))};
  return problem;
}

std::vector<Problem> all_problems() {
  return {tension_problem(), modulus_problem(), bar_problem(),  manufactured_problem(), inclusion_problem(),
          hole_problem(),    layers_problem(),  spin_problem(), collision_problem(),    flight_problem()};
}

std::vector<Problem> select_problems(const std::vector<std::string>& names) {
  std::vector<Problem> all = all_problems();
  std::vector<std::string> known;
  for (const Problem& problem : all) known.push_back(problem.name);
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw Rejected(Exit::usage, "--problem", name, "must be " + listed(known), did_you_mean(name, known));
  if (!names.empty())
    std::erase_if(all, [&](const Problem& problem) {
      return std::find(names.begin(), names.end(), problem.name) == names.end();
    });
  return all;
}

}  // namespace app::bench
