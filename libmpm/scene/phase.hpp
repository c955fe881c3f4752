/// Fields on the pixels of the picture.
/// What a phase is made of.
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

enum class Plane { strain, stress };

/// Isotropic elastic material with stochastic strength. Infinite strengths (the default) make it elastic.
struct Phase {
  static constexpr double unbreakable = std::numeric_limits<double>::infinity();

  std::string name;                    ///< as in the mask, for messages
  double young = 0;                    ///< Young's modulus [Pa], > 0
  double poisson = 0;                  ///< Poisson's ratio [-], in [0, 0.5); plane stress: [0, 0.5]
  double density = 0;                  ///< [kg/m^3], > 0
  double tensile_scale = unbreakable;  ///< Weibull scale f_t of the tensile strength [Pa], > 0
  double cohesion = unbreakable;       ///< Mohr-Coulomb c [Pa], > 0
  double friction_angle = 0;           ///< Mohr-Coulomb phi [rad], in [0, pi/2)
  double weibull_modulus = 1.5;        ///< m [-], > 0
  double fracture_energy = 0;          ///< G_f of a crack band [J/m^2]; 0 = cracks at one blow

  [[nodiscard]] bool can_crack() const { return tensile_scale < unbreakable; }
  [[nodiscard]] bool can_shear() const { return cohesion < unbreakable; }
  [[nodiscard]] bool softens() const { return can_crack() && fracture_energy > 0; }
  [[nodiscard]] bool can_fail() const { return can_crack() || can_shear(); }
};

/// Stiffness [Pa], shape (3, 3), of (e_xx, e_yy, gamma_xy) -> (s_xx, s_yy, s_xy).
[[nodiscard]] Eigen::Matrix3d stiffness(const Phase& phase, Plane plane);

/// Speed of the fastest (compression) wave in the plane [m/s].
[[nodiscard]] double wave_speed(const Phase& phase, Plane plane);

/// Aggregate, mortar and ITZ of concrete, in this order.
/// Source: Liu et al. (2020), Table 1; the density is ours, the paper gives none.
[[nodiscard]] std::vector<Phase> concrete_phases();

/// @throws Error naming the first value that is out of range.
void validate(const Phase& phase, Plane plane);

}  // namespace mpm
