/// Random strengths: each material point has one random number, which depends only on the seed and the point.
/// The numbers are independent, or one field with a correlation length. And the failure criteria, tension and
/// Mohr-Coulomb.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "libmpm/scene/phase.hpp"
#include "libmpm/scene/scene.hpp"

namespace mpm {

/// Uniform random number in (0, 1), never 0 or 1, from a counter: the same for any order, thread or machine.
/// Never throws.
/// Source: Philox4x32-10, Salmon, Moraes, Dror, Shaw (2011).
/// @param point   index of the material point.   @param stream  0 = pixels, 1 = extra points.
[[nodiscard]] double uniform_random(std::uint64_t seed, std::uint64_t point, std::uint32_t stream);

/// Uniform random number of a pixel; depends only on the seed and on the row and column of the pixel.
[[nodiscard]] inline double pixel_random(std::uint64_t seed, int row, int col) {
  return uniform_random(seed, (static_cast<std::uint64_t>(row) << 32U) | static_cast<std::uint32_t>(col), 0);
}

/// Factor q = (-ln r)^(1/m) [-] on the strength of a point: r is its survival probability in the Weibull
/// distribution.   @param random  r, in (0, 1).   @param weibull_modulus  m [-], > 0.
/// Source: Weibull (1951).
[[nodiscard]] double strength_factor(double random, double weibull_modulus);

/// Principal stresses in the plane and the out-of-plane stress [Pa]; tension is positive.
struct PrincipalStress {
  double first = 0;   ///< largest in the plane [Pa]
  double second = 0;  ///< smallest in the plane [Pa]
  double normal = 0;  ///< out of the plane [Pa]
};
/// From the components of a plane stress state and the out-of-plane stress [Pa].
[[nodiscard]] PrincipalStress principal_stress(double xx, double yy, double xy, double normal);

/// Tension failure: the largest principal stress exceeds f_t q.   @param factor  q [-].
[[nodiscard]] bool fails_in_tension(const Phase& phase, double factor, const PrincipalStress& stress);

/// Share of the Mohr-Coulomb strength that a stress takes [-]: (-s3 (1 - sin phi) + q s1 (1 + sin phi)) /
/// (2 q c cos phi), in proportion to the stress; 0 without compression.   @param factor  q [-].
[[nodiscard]] double shear_utilisation(const Phase& phase, double factor, const PrincipalStress& stress);

/// Compressive strength of a bar that is free sideways [Pa]: q 2 c cos phi / (1 - sin phi).   @param factor q
/// [-].
[[nodiscard]] double compressive_strength(const Phase& phase, double factor);

/// Mohr-Coulomb failure: -s3 (1 - sin phi) > q (2 c cos phi - s1 (1 + sin phi)), with s3 < 0.
/// @param factor  q [-].
[[nodiscard]] bool fails_in_shear(const Phase& phase, double factor, const PrincipalStress& stress);

/// Largest s1 [Pa] that a point with this factor q [-] survives; infinite for a phase that does not crack.
[[nodiscard]] double tension_threshold(const Phase& phase, double factor);

/// Smallest -s3 [Pa] at which shear failure is possible while s1 <= largest_s1 [Pa]; infinite for a phase
/// that does not fail in shear. A bound for the fast test; fails_in_shear() decides.
/// @param share  of the cohesion that remains [-].
[[nodiscard]] double shear_onset(const Phase& phase, double factor, double largest_s1, double share = 1);

/// Uniform random number in (0, 1) at a position, from a field with a correlation length: nearly constant
/// within a fraction of `length`, independent beyond three lengths. So all pixel sizes sample the same field.
/// Standard normal numbers on a lattice of spacing `length` are weighted by quadratic B-splines, normalised
/// to variance 1 and mapped by the normal distribution function.
/// @param x, y  position from the lower left corner [m].   @param length  [m], > 0.
[[nodiscard]] double field_random(std::uint64_t seed, double x, double y, double length);

/// The random number of a pixel or an extra point of a scene [-], in (0, 1), by Damage::correlation_length.
[[nodiscard]] double random_of_pixel(const Scene& scene, int row, int col);
[[nodiscard]] double random_of_extra_point(const Scene& scene, std::size_t index);

/// Strength factors q [-] of the points of a scene, computed on demand or stored.
class StrengthFactors {
 public:
  /// @param scene  must outlive this object.   @param keep  compute all factors of pixels once and store
  /// them.
  StrengthFactors(const Scene& scene, bool keep);

  /// q [-]; 1 for a phase that cannot fail.
  [[nodiscard]] double of_pixel(int row, int col) const;
  [[nodiscard]] double of_extra_point(std::size_t index) const;

 private:
  [[nodiscard]] double draw_pixel(int row, int col) const;

  const Scene& scene_;
  std::vector<double> kept_;  ///< by pixel, row by row; empty when they are not kept
};

}  // namespace mpm
