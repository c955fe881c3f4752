/// How a point that cracks loses its strength over the width of a crack band.
#pragma once

#include "libmpm/scene/phase.hpp"
#include "libmpm/material/stress.hpp"

namespace mpm {

/// Exponential softening: the largest principal stress falls with the largest principal strain e,
///     s1 = peak exp(-(e - onset) / scale)   for e > onset,
/// so that a band of the given width dissipates the fracture energy by the time it carries nothing.
/// Source: Bazant, Oh (1983), for the band; Hordijk (1991) measured a curve of this kind.
struct Softening {
  double peak = 0;   ///< strength at which it begins [Pa]
  double onset = 0;  ///< strain at which it begins in uniaxial stress [-]
  double scale = 0;  ///< strain over which the stress falls to 1/e [-]; not above 0 where the band snaps back

  /// Largest principal stress that the point still carries [Pa].
  [[nodiscard]] double stress_at(double strain) const;
};

/// @param peak  strength of the point [Pa].   @param band  width of the crack band [m].
[[nodiscard]] Softening softening(const Phase& phase, Plane plane, double peak, double band);

/// Width of a band above which a point of this strength snaps back [m]: it would have to give back more
/// energy than its crack takes.
[[nodiscard]] double widest_band(const Phase& phase, Plane plane, double peak);

/// Largest principal strain in the plane that belongs to an elastic stress [-].
[[nodiscard]] double largest_strain(const Phase& phase, Plane plane, const Stress<double>& elastic);

}  // namespace mpm
