/// Phases: the materials of a specimen; and fields of one value per pixel.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

namespace mpm {

/// A value per pixel, shape (rows, cols), row-major; row 0 is the TOP of the picture and y points up, as in
/// the mask: the centre of pixel (row, col) lies at x = (col + 1/2) d, y = (rows - row - 1/2) d.
template <class T>
using PixelField = Eigen::Array<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The plane assumption: no strain, or no stress, out of the plane.
enum class Plane { strain, stress };

/// How the stress of a crack band falls as the crack opens.
enum class SofteningCurve {
  exponential,
  bilinear,  ///< to a third of the strength, then more slowly; Petersson (1981)
  hordijk,   ///< measured on concrete; Hordijk (1991)
};

/// Isotropic linear elastic material with random strength. With infinite strengths (the default) it never
/// fails.
struct Phase {
  static constexpr double unbreakable = std::numeric_limits<double>::infinity();

  std::string name;                    ///< as in the mask; used in messages
  double young = 0;                    ///< Young's modulus [Pa], > 0
  double poisson = 0;                  ///< Poisson's ratio [-], in [0, 0.5); plane stress: [0, 0.5]
  double density = 0;                  ///< [kg/m^3], > 0
  double tensile_scale = unbreakable;  ///< Weibull scale f_t of the tensile strength [Pa], > 0
  double cohesion = unbreakable;       ///< Mohr-Coulomb c [Pa], > 0
  double friction_angle = 0;           ///< Mohr-Coulomb phi [rad], in [0, pi/2)
  double weibull_modulus = 1.5;        ///< m [-], > 0
  double fracture_energy = 0;  ///< G_f of a crack band [J/m^2]; 0 = brittle: all stress is lost at once
  SofteningCurve softening = SofteningCurve::exponential;  ///< of a crack band

  /// G_II of a shear band [J/m^2], in compression without lateral stress; 0 = brittle. Needs crack closure.
  double shear_fracture_energy = 0;

  [[nodiscard]] bool can_crack() const { return tensile_scale < unbreakable; }
  [[nodiscard]] bool can_shear() const { return cohesion < unbreakable; }
  [[nodiscard]] bool softens() const { return can_crack() && fracture_energy > 0; }
  [[nodiscard]] bool softens_in_shear() const { return can_shear() && shear_fracture_energy > 0; }
  [[nodiscard]] bool can_fail() const { return can_crack() || can_shear(); }
};

/// Stiffness matrix [Pa], shape (3, 3), from strains (e_xx, e_yy, gamma_xy) [-] to stresses (s_xx, s_yy,
/// s_xy) [Pa].   @pre the phase is valid.   Never throws.
[[nodiscard]] Eigen::Matrix3d stiffness(const Phase& phase, Plane plane);

/// Speed of the fastest (compression) wave in the plane [m/s].   @pre the phase is valid.
[[nodiscard]] double wave_speed(const Phase& phase, Plane plane);

/// Stress over strain of a bar that is free sideways in the plane [Pa].
[[nodiscard]] double bar_modulus(const Phase& phase, Plane plane);

/// Aggregate, mortar and ITZ of concrete, in this order.
/// Source: Liu et al. (2020), Table 1. The paper gives no density; 2400 kg/m^3 is our own choice.
[[nodiscard]] std::vector<Phase> concrete_phases();

/// @throws Error naming the first value that is out of range.
void validate(const Phase& phase, Plane plane);

}  // namespace mpm
