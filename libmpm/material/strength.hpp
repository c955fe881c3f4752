/// Random strengths: one number per material point, from (seed, point) alone.
/// The random numbers of the material points of a scene: white, or with a correlation length.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "libmpm/scene/phase.hpp"
#include "libmpm/scene/scene.hpp"

namespace mpm {

/// Uniform random number in (0, 1), never 0 or 1, of a counter: the same for any order, thread or machine.
/// Source: Philox4x32-10, Salmon, Moraes, Dror, Shaw (2011).
/// @param point   index of the material point.   @param stream  0 = pixels, 1 = extra points.
[[nodiscard]] double uniform_random(std::uint64_t seed, std::uint64_t point, std::uint32_t stream);

/// The random number of a pixel; it depends on nothing but the seed and the place of the pixel in the
/// picture.
[[nodiscard]] inline double pixel_random(std::uint64_t seed, int row, int col) {
  return uniform_random(seed, (static_cast<std::uint64_t>(row) << 32U) | static_cast<std::uint32_t>(col), 0);
}

/// Factor q = (-ln r)^(1/m) on the strength of a point, in which the survival probability of the Weibull
/// distribution is r.
[[nodiscard]] double strength_factor(double random, double weibull_modulus);

/// Principal stresses in the plane and the stress normal to it [Pa]; tension is positive.
struct PrincipalStress {
  double first = 0;   ///< largest in the plane
  double second = 0;  ///< least in the plane
  double normal = 0;  ///< out of the plane
};
[[nodiscard]] PrincipalStress principal_stress(double xx, double yy, double xy, double normal);

/// Tension failure: the largest principal stress exceeds f_t q.
[[nodiscard]] bool fails_in_tension(const Phase& phase, double factor, const PrincipalStress& stress);

/// Mohr-Coulomb failure: -s3 (1 - sin phi) > q (2 c cos phi - s1 (1 + sin phi)), with s3 < 0.
[[nodiscard]] bool fails_in_shear(const Phase& phase, double factor, const PrincipalStress& stress);

/// Largest s1 that a point of this factor survives [Pa]; infinite for a phase that does not crack.
[[nodiscard]] double tension_threshold(const Phase& phase, double factor);

/// Least -s3 at which shear failure is possible while s1 <= largest_s1 [Pa]; infinite for a phase that does
/// not shear. A bound for the fast test; fails_in_shear decides.
[[nodiscard]] double shear_onset(const Phase& phase, double factor, double largest_s1);

/// Uniform random number in (0, 1) of a place, equal within a fraction of `length` and independent beyond
/// three of them, so that every picture of a specimen samples one field, however fine it is: standard normal
/// numbers on a lattice of spacing `length`, weighted by quadratic B-splines, brought to variance 1 and
/// turned into probabilities.
/// @param x, y  place in the picture, from its lower left corner [m].   @param length  > 0 [m].
[[nodiscard]] double field_random(std::uint64_t seed, double x, double y, double length);

[[nodiscard]] double random_of_pixel(const Scene& scene, int row, int col);
[[nodiscard]] double random_of_extra_point(const Scene& scene, std::size_t index);

/// Factors on the strengths of the points, drawn when asked for, or once for a run that asks often.
class StrengthFactors {
 public:
  /// The scene must outlive the factors.
  StrengthFactors(const Scene& scene, bool keep);

  /// @return 1 for a point of a phase that does not fail.
  [[nodiscard]] double of_pixel(int row, int col) const;
  [[nodiscard]] double of_extra_point(std::size_t index) const;

 private:
  [[nodiscard]] double draw_pixel(int row, int col) const;

  const Scene& scene_;
  std::vector<double> kept_;  ///< by pixel, row by row; empty when they are not kept
};

}  // namespace mpm
