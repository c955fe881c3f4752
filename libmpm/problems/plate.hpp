/// A plate drawn as pixels under slow, damped or quasi-static tension between smooth platens: uniform, with a
/// stiff disc, with a round hole, in layers.
#pragma once

#include <string>
#include <vector>

#include "libmpm/material/failure.hpp"
#include "libmpm/problems/method.hpp"
#include "libmpm/scene/scene.hpp"

namespace mpm::problems {

/// A square of 1 m of two elastic phases, nu 0.2 each, everything the first. Its pixels are all of one size
/// over the width, so that the number of steps grows with theirs and the load stays the same.
[[nodiscard]] Scene plate(int pixels, double ratio_of_moduli = 2);

/// Draws a disc in the middle, its radius in widths of the plate.
void draw_disc(Scene& scene, double radius, std::uint8_t label);

/// Stress of the point of a pixel over the mean stress of the platens, at its place from the middle [m].
struct PlateStress {
  double x = 0, y = 0;
  std::uint8_t label = 0;
  Stress<double> stress;
};
struct StaticPlate {
  std::vector<PlateStress> points;
  double modulus = 0;  ///< mean stress over strain [Pa]
  Cost cost;
  std::string trouble;  ///< empty: it came to its end
};
[[nodiscard]] StaticPlate pull(const Scene& scene);

/// What the disc of Goodier's solution carries over the stress T of the plate far away [-].
/// mean p = (T / 2) m2 (k1 + 1) / (2 m2 + m1 (k2 - 1)), deviator s = (T / 2) m2 (k1 + 1) / (m1 + k1 m2),
/// k = 3 - 4 nu in plane strain; here for m2 = 2 m1, nu = 0.2.
/// Source: Goodier, Trans. ASME 55 (1933); written as in Mura, Micromechanics of defects in solids, ch. 4.
struct DiscStress {
  double along = 0, across = 0;
};
[[nodiscard]] DiscStress goodier();

/// Errors of the stress of a disc twice as stiff as the plate over the stress of the plate [-].
struct InclusionErrors {
  double mean = 0;   ///< of s_yy over the disc
  double inner = 0;  ///< root of the mean square over the points within half its radius
};
[[nodiscard]] InclusionErrors inclusion_errors(const StaticPlate& plate, double radius);

/// s_yy beside a round hole over the stress of the plate at x / a from its middle, 3 at its edge [-].
/// Source: Kirsch (1898).
[[nodiscard]] double kirsch(double x_over_a);

/// Root of the mean square of s_yy less Kirsch's at the points beside the hole, from 1.25 to 3 radii from its
/// middle, over the stress of the plate [-].
[[nodiscard]] double hole_error(const StaticPlate& plate, double radius, double pixel_size);

enum class Layers { across, along };

/// A plate of two layers of moduli 1 and 2, nu = 0. Its modulus is 4/3 across them (Reuss), 3/2 along them
/// (Voigt), over that of the softer.
[[nodiscard]] Scene layered_plate(int pixels, Layers layers);
[[nodiscard]] double layered_modulus(Layers layers);  ///< [Pa]

}  // namespace mpm::problems
