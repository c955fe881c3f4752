#include "libmpm/solver/plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "libmpm/material/softening.hpp"
#include "libmpm/material/strength.hpp"
#include "libmpm/scene/error.hpp"
#include "libmpm/solver/threads.hpp"

namespace mpm {
namespace {

/// The phases of which the scene holds at least one point.
std::vector<const Phase*> phases_present(const Scene& scene) {
  std::array<bool, 256> used{};
  for (const auto label : scene.labels.reshaped()) used[label] = true;
  for (const auto& point : scene.extra_points) used[point.phase] = true;
  std::vector<const Phase*> present;
  for (std::size_t label = 0; label < scene.phases.size(); ++label)
    if (used[label] && scene.phases[label]) present.push_back(&*scene.phases[label]);
  return present;
}

/// Time that a wave takes along a bar as long as the longer side of the specimen, free sideways and with the
/// mean compliance and the mean density of its points [s]. It sets the slowest period of the specimen. The
/// wave of the time step, which cannot strain sideways, tells nothing of that: its speed has no limit as
/// Poisson's ratio nears 1/2.
double transit_time(const Scene& scene) {
  std::array<std::int64_t, 256> points{};
  for (const auto label : scene.labels.reshaped()) ++points[label];
  for (const auto& point : scene.extra_points) ++points[point.phase];
  double all = 0, compliance = 0, density = 0;
  for (std::size_t label = 0; label < scene.phases.size(); ++label) {
    if (!scene.phases[label]) continue;
    const auto count = static_cast<double>(points[label]);
    all += count;
    compliance += count / bar_modulus(*scene.phases[label], scene.plane);
    density += count * scene.phases[label]->density;
  }
  return std::max(scene.width(), scene.height()) * std::sqrt(compliance / all * (density / all));
}

kernels::Check check_needed(const std::vector<const Phase*>& phases) {
  const auto any = [&](auto property) { return std::any_of(phases.begin(), phases.end(), property); };
  if (any([](const Phase* phase) { return phase->can_shear(); })) return kernels::Check::tension_and_shear;
  if (any([](const Phase* phase) { return phase->can_crack(); })) return kernels::Check::tension;
  return kernels::Check::none;
}

kernels::Features features_needed(const Scene& scene, const std::vector<const Phase*>& phases) {
  kernels::Features features;
  features.points_per_cell = scene.points_per_cell;
  features.pixel_cells = scene.pixel_cells;
  // Kernels for one Poisson's ratio exist for pixel cells and for the usual 2 x 2 points a cell.
  const bool usual = scene.pixel_cells || scene.points_per_cell == 2;
  features.one_poisson_ratio = usual && std::all_of(phases.begin(), phases.end(), [&](const Phase* phase) {
                                 return phase->poisson == phases.front()->poisson;
                               });
  features.check = check_needed(phases);
  // A crack that never opens needs no closing.
  features.crack_closure =
      scene.damage.crack_closure != CrackClosure::off && features.check != kernels::Check::none;
  // Kernels for one check alone exist for the same cells, without cracks that close.
  if (features.check == kernels::Check::tension && (!usual || features.crack_closure))
    features.check = kernels::Check::tension_and_shear;
  features.damping = scene.local_damping > 0;
  return features;
}

moving::Return return_of(const Motion& motion) {
  if (motion.transfer == Transfer::apic) return moving::Return::apic;
  return motion.flip_ratio < 1 ? moving::Return::blend : moving::Return::flip;
}

/// Cells beyond the picture, as whole numbers.
/// @throws Error for a grid that no memory holds, before it is asked for.
void set_margins(const Scene& scene, double cell_size, MovingPlan& plan) {
  const Motion& motion = scene.motion;
  const double margin = motion.margin < 0 ? 0.25 * scene.width() : motion.margin;
  const double cells = std::ceil(margin / cell_size - 1e-9);
  const bool flies = scene.loading.direction == Direction::none;
  const auto beyond = [&](Edge edge) { return edge == Edge::closed || edge == Edge::open ? cells : 0; };
  const double left = beyond(motion.left), right = beyond(motion.right);
  const double bottom = flies ? beyond(motion.bottom) : 0, top = flies ? beyond(motion.top) : 0;
  constexpr double most = 200e6;
  const double wanted =
      (scene.width() / cell_size + left + right) * (scene.height() / cell_size + bottom + top);
  // A grid without a margin is as large as the picture, which has its own limit.
  if (left + right + bottom + top > 0 && !(wanted <= most))
    throw Error("motion.margin", text(margin, "m"),
                "makes a grid of " + text(wanted, "cells") + "; at most 200 million are allowed",
                "make it smaller");
  plan.margin_left = static_cast<int>(left);
  plan.margin_right = static_cast<int>(right);
  plan.margin_bottom = static_cast<int>(bottom);
  plan.margin_top = static_cast<int>(top);
}

MovingPlan moving_plan(const Scene& scene, const kernels::Features& features, double cell_size) {
  const Motion& motion = scene.motion;
  MovingPlan plan;
  plan.features.stencil =
      motion.shape == Shape::linear ? moving::Stencil::linear : moving::Stencil::quadratic;
  plan.features.transfer = return_of(motion);
  plan.features.check = features.check;
  plan.features.crack_closure = features.crack_closure;
  plan.features.damping = features.damping;
  plan.optional.tension = features.check != kernels::Check::none;
  plan.optional.crush = features.check == kernels::Check::tension_and_shear;
  plan.optional.cracked = features.crack_closure;
  plan.optional.deformation = motion.deformation_gradient;
  plan.optional.affine = motion.transfer == Transfer::apic;
  // What APIC maps back is what it mapped: only light nodes differ, and there USL is not stable.
  plan.mapped_back =
      motion.scheme == Scheme::musl || (motion.scheme == Scheme::usl && motion.transfer == Transfer::apic);
  plan.half_size = motion.shape == Shape::gimp ? 0.5 / scene.points_per_cell : 0.5;
  // Measured: points as wide as a cell smear a crack over that many cells, the others over the one it lies
  // in.
  const bool wide = motion.shape != Shape::linear && plan.half_size >= 0.5;
  plan.crack_band = wide ? 1.95 * cell_size : cell_size;
  set_margins(scene, cell_size, plan);
  return plan;
}

/// Time until the platen has moved to stop_strain. At full velocity it lags half the ramp behind; in the ramp
/// it has moved velocity * ramp_time * (x^3 - x^4 / 2) at x = time / ramp_time.
double time_needed(const Scene& scene, const Plan& plan) {
  if (scene.loading.direction == Direction::none) return scene.loading.duration;
  const double time = scene.loading.stop_strain * scene.height() / scene.loading.velocity;
  if (time >= 0.5 * plan.ramp_time) return time + 0.5 * plan.ramp_time;
  double low = 0;
  double high = 1;
  for (int i = 0; i < 60; ++i) {
    const double x = 0.5 * (low + high);
    (plan.ramp_time * x * x * x * (1 - 0.5 * x) < time ? low : high) = x;
  }
  return high * plan.ramp_time;
}

std::int64_t steps_needed(const Scene& scene, const Plan& plan) {
  const double steps = std::ceil(time_needed(scene, plan) / plan.dt);
  if (!(steps < 1e12))
    throw Error("loading.velocity", std::to_string(scene.loading.velocity) + " m/s",
                "the run would need more than 1e12 steps", "load faster, or stop at a smaller strain");
  return std::max<std::int64_t>(1, static_cast<std::int64_t>(steps));
}

/// A thread for as many points as take it some ten times longer than a wait for the others.
int threads_worth_having(const Scene& scene) {
  if (scene.threads > 0) return scene.threads;
  const std::int64_t share = scene.kinematics == Kinematics::small_strain ? 10'000 : 2'500;
  // Threads that share a core with others wait for each other most of the time.
  const std::int64_t cores = idle_cores();
  return static_cast<int>(
      std::clamp<std::int64_t>(count_points(scene) / share, 1, std::min<std::int64_t>(cores, 1024)));
}

/// A crack that opens in small strain must not change its width when points begin to move.
void refuse_other_width(const Scene& scene, const Plan& plan) {
  if (scene.kinematics == Kinematics::automatic && plan.moving.crack_band != plan.cell_size)
    throw Error("motion.shape",
                scene.motion.shape == Shape::bspline ? "bspline" : "gimp with one point per cell",
                "smears a crack over two cells, and small strain over one",
                "choose linear or gimp with 2 x 2 points per cell, or solver.kinematics moving");
}

bool softens(const Phase& phase) { return phase.softens() || phase.softens_in_shear(); }

/// Strongest point of each phase that softens, by label [-]; 0 = none.
std::vector<double> largest_factors(const Scene& scene) {
  std::vector<double> largest(scene.phases.size(), 0.0);
  const StrengthFactors factors(scene, false);
  const auto take = [&](std::uint8_t label, auto&& factor) {
    if (scene.phases[label] && softens(*scene.phases[label]))
      largest[label] = std::max(largest[label], factor());
  };
  for (int row = 0; row < scene.labels.rows(); ++row)
    for (int col = 0; col < scene.labels.cols(); ++col)
      take(scene.labels(row, col), [&] { return factors.of_pixel(row, col); });
  for (std::size_t i = 0; i < scene.extra_points.size(); ++i)
    take(scene.extra_points[i].phase, [&] { return factors.of_extra_point(i); });
  return largest;
}

std::string rounded(double value, const char* unit) {
  char text[64];
  std::snprintf(text, sizeof text, "%.3g %s", value, unit);
  return text;
}

/// A band that has to give back more energy than its crack takes cannot follow its curve.
void refuse_snap_back(const Scene& scene, double band) {
  const std::vector<double> largest = largest_factors(scene);
  for (std::size_t label = 0; label < largest.size(); ++label) {
    if (largest[label] <= 0) continue;
    const Phase& phase = *scene.phases[label];
    const auto refuse = [&](const char* field, double energy, const char* kind, double widest, double peak) {
      if (band < widest) return;
      const double pixel = 0.999 * scene.pixel_size * widest / band;
      throw Error("phases." + phase.name + "." + field, rounded(energy, "J/m2"),
                  std::string("is less than the elastic energy of a ") + kind + " band of " +
                      rounded(1e3 * band, "mm") + " at the strongest point, " + rounded(1e-6 * peak, "MPa"),
                  "use pixels of " + rounded(1e3 * pixel, "mm") +
                      " at most, a larger weibull_modulus or a larger " + field);
    };
    if (phase.softens()) {
      const double peak = tension_threshold(phase, largest[label]);
      refuse("fracture_energy", phase.fracture_energy, "crack", widest_band(phase, scene.plane, peak), peak);
    }
    if (phase.softens_in_shear())
      refuse("shear_fracture_energy", phase.shear_fracture_energy, "shear",
             widest_shear_band(phase, scene.plane, largest[label]),
             compressive_strength(phase, largest[label]));
  }
}

}  // namespace

double damped_share(double local_damping) { return 1 / std::sqrt(1 + local_damping); }

Plan plan(const Scene& scene) {
  validate(scene);
  const auto phases = phases_present(scene);
  Plan plan;
  plan.cells_x = static_cast<int>(scene.labels.cols()) / scene.points_per_cell;
  plan.cells_y = static_cast<int>(scene.labels.rows()) / scene.points_per_cell;
  plan.cell_size = scene.pixel_size * scene.points_per_cell;
  double slowest = Phase::unbreakable;
  for (const Phase* phase : phases) {
    const double speed = wave_speed(*phase, scene.plane);
    plan.wave_speed = std::max(plan.wave_speed, speed);
    slowest = std::min(slowest, speed);
  }
  plan.dt = scene.cfl * damped_share(scene.local_damping) * plan.cell_size / plan.wave_speed;
  plan.transit_time = transit_time(scene);
  plan.ramp_time = scene.loading.ramp_time < 0 ? 2 * std::max(plan.transit_time, scene.height() / slowest)
                                               : scene.loading.ramp_time;
  plan.features = features_needed(scene, phases);
  plan.poisson = phases.front()->poisson;
  if (scene.kinematics != Kinematics::small_strain)
    plan.moving = moving_plan(scene, plan.features, plan.cell_size);
  plan.threads = threads_worth_having(scene);
  plan.boundary = find_boundary(scene, plan.cells_x, plan.cells_y, plan.cell_size);
  plan.softens =
      std::any_of(phases.begin(), phases.end(), [](const Phase* phase) { return softens(*phase); });
  if (plan.softens) {
    refuse_other_width(scene, plan);
    refuse_snap_back(scene, std::max(plan.cell_size, plan.moving.crack_band));
  }
  if (scene.method == SolverMethod::quasi_static) {  // there is no time; failures make the steps
    plan.dt = plan.ramp_time = 0;
    plan.steps = scene.history_rows;
    plan.steps_per_row = 1;
    return plan;
  }
  plan.steps = steps_needed(scene, plan);
  plan.steps_per_row = std::max<std::int64_t>(1, plan.steps / scene.history_rows);
  return plan;
}

double ramp(const Plan& plan, double time) {
  if (time >= plan.ramp_time) return 1;
  const double x = time / plan.ramp_time;
  return x * x * (3 - 2 * x);
}

}  // namespace mpm
