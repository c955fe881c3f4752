/// The random numbers of the material points of a scene: white, or with a correlation length.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "libmpm/scene/scene.hpp"

namespace mpm {

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
