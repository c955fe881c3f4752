/// A small run of each kind that the solver knows, and how to tell whether two runs are the same.
#pragma once

#include <cstring>
#include <string>
#include <vector>

#include "libmpm/scene/result.hpp"
#include "tests/libmpm/moving_scenes.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace samples {

struct Kind {
  std::string name;
  mpm::Scene scene;
};

namespace kinds {

/// Concrete of 24 x 24 pixels that cracks within some hundred steps.
inline mpm::Scene pulled_concrete() {
  mpm::Scene scene = pulled(small_concrete(24, 24));
  scene.loading.velocity = 0.2;
  scene.history_rows = 60;
  return scene;
}

inline mpm::Scene pressed_concrete(mpm::CrackClosure closure) {
  mpm::Scene scene = pulled_concrete();
  scene.loading.direction = mpm::Direction::compression;
  scene.loading.velocity = 2;
  scene.loading.stop_strain = 4e-3;
  scene.loading.platen = mpm::Platen::rough;
  scene.damage.crack_closure = closure;
  if (closure == mpm::CrackClosure::clipped) scene.damage.residual_stiffness = 0.3;
  return scene;
}

inline mpm::Scene softening_concrete() {
  mpm::Scene scene = pulled_concrete();
  for (auto& phase : scene.phases)
    if (phase && phase->can_crack()) {
      phase->fracture_energy = 60;
      phase->weibull_modulus = 6;
    }
  scene.loading.stop_strain = 1e-3;
  scene.loading.velocity = 0.4;
  return scene;
}

inline mpm::Scene with_extra_points(mpm::Scene scene) {
  for (int i = 0; i < 12; ++i) {
    const double place = (i + 0.7) * 0.9e-3;
    scene.extra_points.push_back({place, 11.1e-3 - place, i % 2 == 0 ? itz : mortar});
  }
  return scene;
}

inline mpm::Scene of_two_poisson_ratios(mpm::Scene scene) {
  scene.phases[aggregate]->poisson = 0.3;
  scene.local_damping = 0.1;
  scene.damage.residual_stiffness = 1e-4;
  return scene;
}

/// A brittle disc that flies against a wall and loses points through the sides.
inline mpm::Scene thrown_disc() {
  mpm::Scene scene = soft_body(20, 20, 0.05, 0.2);
  keep_disc(scene, 10, 10, 9);
  mpm::Phase& body = *scene.phases[soft];
  body.tensile_scale = 2e5;
  body.cohesion = 1e6;
  body.friction_angle = 0.6;
  body.weibull_modulus = 3;
  scene.loading.initial_velocity_x = 12;
  scene.loading.initial_velocity_y = -8;
  scene.loading.duration = 0.02;
  scene.motion.margin = 0.1;
  scene.motion.bottom = mpm::Edge::smooth_wall;
  scene.motion.left = scene.motion.right = scene.motion.top = mpm::Edge::open;
  scene.history_rows = 30;
  return scene;
}

inline mpm::Scene moving(mpm::Scene scene) {
  scene.kinematics = mpm::Kinematics::moving;
  scene.motion.margin = 2e-3;
  return scene;
}

inline mpm::Scene handed_over(mpm::Scene scene) {
  scene = moving(std::move(scene));
  scene.kinematics = mpm::Kinematics::automatic;
  scene.handover.strain = 1.5e-4;
  return scene;
}

inline mpm::Scene damped(mpm::Scene scene) {
  scene.local_damping = 0.1;
  return scene;
}

inline mpm::Scene in_single(mpm::Scene scene) {
  scene.precision = mpm::Precision::single;
  return scene;
}

}  // namespace kinds

inline std::vector<Kind> kinds_of_runs() {
  using namespace kinds;
  using mpm::CrackClosure;
  std::vector<Kind> all{
      {"small strain", pulled_concrete()},
      {"two Poisson ratios, damped", of_two_poisson_ratios(pulled_concrete())},
      {"clipped cracks", pressed_concrete(CrackClosure::clipped)},
      {"unilateral cracks", pressed_concrete(CrackClosure::unilateral)},
      {"softening", softening_concrete()},
      {"extra points", with_extra_points(pulled_concrete())},
      {"hand-over", handed_over(with_extra_points(pulled_concrete()))},
      {"hand-over of softening points", handed_over(softening_concrete())},
      {"moving with closed cracks, damped", damped(moving(pressed_concrete(CrackClosure::unilateral)))},
  };
  for (const Method& method : all_methods()) {
    mpm::Scene scene = thrown_disc();
    method.give_to(scene);
    all.push_back({"thrown, " + method.name(), scene});
  }
  all[9].scene.motion.deformation_gradient = true;
  for (const std::size_t kind : {0U, 3U, 4U, 5U, 6U, 9U, 10U})
    all.push_back({all[kind].name + ", single", in_single(all[kind].scene)});
  all.push_back({"dropped", pulled_concrete()});
  all.back().scene.loading.stop_drop = 0.9;
  return all;
}

template <class A, class B>
bool same_bits(const A& a, const B& b) {
  if (a.size() != b.size()) return false;
  const auto bytes = static_cast<std::size_t>(a.size()) * sizeof(*a.data());
  return bytes == 0 || std::memcmp(a.data(), b.data(), bytes) == 0;
}

/// All but the time that it took and the threads that it took.
inline bool same_result(const mpm::Result& a, const mpm::Result& b) {
  bool same = same_bits(a.history, b.history) && same_bits(a.failure_strain, b.failure_strain) &&
              same_bits(a.failure_mode, b.failure_mode) && same_bits(a.crush_strain, b.crush_strain) &&
              same_bits(a.end_x, b.end_x) && same_bits(a.end_y, b.end_y) &&
              same_bits(a.extra_failure_strain, b.extra_failure_strain) &&
              same_bits(a.extra_failure_mode, b.extra_failure_mode);
  for (std::size_t i = 0; i < a.deformation.size(); ++i)
    same &= same_bits(a.deformation[i], b.deformation[i]);
  return same && a.peak_stress == b.peak_stress && a.peak_strain == b.peak_strain &&
         a.tension_failures == b.tension_failures && a.shear_failures == b.shear_failures &&
         a.points == b.points && a.steps == b.steps && a.dt == b.dt && a.energy_error == b.energy_error &&
         a.instruction_set == b.instruction_set && a.stop == b.stop && a.nothing_carries == b.nothing_carries;
}

}  // namespace samples
