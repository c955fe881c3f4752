/// Axial vibration of a bar, held at the left by a plane of symmetry and free at the right:
/// v(x, t) = v0 sin(pi x / 2 L) cos(omega t), omega = pi c / 2 L.
#pragma once

#include <string>

#include "libmpm/problems/method.hpp"

namespace mpm::problems {

/// Amplitude over v0, and phase less omega t, of the first mode.
struct Mode {
  double amplitude = 0, lag = 0;
};

struct Vibration {
  Mode one, ten;      ///< after as many periods
  double energy = 0;  ///< after ten periods over that at the start [-]
  double error =
      0;  ///< after ten periods: root of the mean square of the distance between the points and the
          ///< exact solution in the plane of displacement and velocity / omega, over the amplitude [-]
  Cost cost;
  std::string trouble;  ///< empty: it came to its end
};

/// @param cells  over the length of the bar, >= 2.
[[nodiscard]] Vibration vibrate_bar(const Method& method, int cells, double cfl = 0.5);

}  // namespace mpm::problems
