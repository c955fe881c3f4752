#include "libmpm/scene/phase.hpp"

#include <cmath>
#include <numbers>

#include "libmpm/scene/error.hpp"

namespace mpm {
Eigen::Matrix3d stiffness(const Phase& phase, Plane plane) {
  const double nu = phase.poisson;
  const double shear = phase.young / (2 * (1 + nu));
  // Plane stress has the Lame constant that makes the out-of-plane stress vanish.
  const double lame = plane == Plane::strain ? phase.young * nu / ((1 + nu) * (1 - 2 * nu))
                                             : phase.young * nu / (1 - nu * nu);
  Eigen::Matrix3d c = Eigen::Matrix3d::Zero();
  c(0, 0) = c(1, 1) = lame + 2 * shear;
  c(0, 1) = c(1, 0) = lame;
  c(2, 2) = shear;
  return c;
}

double wave_speed(const Phase& phase, Plane plane) {
  return std::sqrt(stiffness(phase, plane)(0, 0) / phase.density);
}

double bar_modulus(const Phase& phase, Plane plane) {
  return plane == Plane::strain ? phase.young / (1 - phase.poisson * phase.poisson) : phase.young;
}

std::vector<Phase> concrete_phases() {
  constexpr double degree = std::numbers::pi / 180;
  Phase aggregate{.name = "aggregate", .young = 40e9, .poisson = 0.2, .density = 2400};
  Phase mortar{.name = "mortar",
               .young = 20e9,
               .poisson = 0.2,
               .density = 2400,
               .tensile_scale = 15e6,
               .cohesion = 150e6,
               .friction_angle = 50 * degree,
               .weibull_modulus = 1.5};
  Phase itz{.name = "itz",
            .young = 12e9,
            .poisson = 0.2,
            .density = 2400,
            .tensile_scale = 9e6,
            .cohesion = 90e6,
            .friction_angle = 36 * degree,
            .weibull_modulus = 1.5};
  return {aggregate, mortar, itz};
}

std::vector<Error> faults(const Phase& phase, Plane plane) {
  Faults faults;
  const double largest_poisson = plane == Plane::strain ? 0.4999 : 0.5;
  const auto finite = [](double value) { return std::isfinite(value); };
  const auto check = [&](bool ok, const char* key, double value, const char* unit, const char* allowed) {
    faults.require(ok, "phases." + phase.name + "." + key, text(value, unit), allowed);
  };
  check(finite(phase.young) && phase.young > 0, "young", phase.young, "Pa", "must be > 0");
  check(phase.poisson >= 0 && phase.poisson <= largest_poisson, "poisson", phase.poisson, "",
        plane == Plane::strain ? "must lie in [0, 0.4999] in plane strain"
                               : "must lie in [0, 0.5] in plane stress");
  check(finite(phase.density) && phase.density > 0, "density", phase.density, "kg/m3", "must be > 0");
  check(phase.tensile_scale > 0, "tensile_scale", phase.tensile_scale, "Pa",
        "must be > 0, or absent for a phase that does not fail in tension");
  check(phase.cohesion > 0, "cohesion", phase.cohesion, "Pa",
        "must be > 0, or absent for a phase that does not fail in shear");
  check(phase.friction_angle >= 0 && phase.friction_angle < std::numbers::pi / 2, "friction_angle",
        phase.friction_angle * 180 / std::numbers::pi, "deg", "must lie in [0, 90) deg");
  check(finite(phase.weibull_modulus) && phase.weibull_modulus > 0, "weibull_modulus", phase.weibull_modulus,
        "", "must be > 0");
  check(finite(phase.fracture_energy) && phase.fracture_energy >= 0, "fracture_energy", phase.fracture_energy,
        "J/m2", "must be > 0, or 0 for a brittle phase");
  check(phase.fracture_energy == 0 || phase.can_crack(), "fracture_energy", phase.fracture_energy, "J/m2",
        "needs a tensile_scale");
  check(finite(phase.shear_fracture_energy) && phase.shear_fracture_energy >= 0, "shear_fracture_energy",
        phase.shear_fracture_energy, "J/m2", "must be > 0, or 0 for a phase that is brittle in shear");
  check(phase.shear_fracture_energy == 0 || phase.can_shear(), "shear_fracture_energy",
        phase.shear_fracture_energy, "J/m2", "needs a cohesion");
  faults.require(phase.softening == SofteningCurve::exponential || phase.fracture_energy > 0,
                 "phases." + phase.name + ".softening",
                 phase.softening == SofteningCurve::bilinear ? "bilinear" : "hordijk",
                 "needs a fracture_energy");
  return std::move(faults).found();
}

void validate(const Phase& phase, Plane plane) { refuse_first(faults(phase, plane)); }

}  // namespace mpm
