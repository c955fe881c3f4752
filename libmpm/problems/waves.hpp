/// Problems with a known answer: waves and large deformation.
/// Axial vibration of a bar, held at the left by a plane of symmetry and free at the right:
/// v(x, t) = v0 sin(pi x / 2 L) cos(omega t), omega = pi c / 2 L.
/// Large deformation with a solution made up beforehand: u = A sin(2 pi X) sin(c pi t) along each axis of the
/// unit square, driven by the body force that it needs.
///
/// F = diag(Fx(X, t), Fy(Y, t)) turns nothing, so Jaumann's rate integrates to the Cauchy stress
/// s_xx = (l + 2 m) ln Fx + l ln Fy. With P = J s F^-T, P_xx = Fy s_xx and the balance of momentum
/// rho0 u_tt = P_xx,X + rho0 b, where ln Fy does not depend on X, the body force is
/// b_x = u_tt - Fy (l + 2 m) Fx,X / (Fx rho0); b_y alike.
/// Source: method of manufactured solutions for MPM, Steffen, Wallstedt, Guilkey, Kirby, Berzins, CMES 31
/// (2008).
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

/// The same in small strain, with one pixel a cell: the bar and its mirror image beyond the free end, between
/// two platens at rest. Only the error and the cost are filled in.
/// @param cells  over the length of the bar, >= 2.
[[nodiscard]] Vibration vibrate_bar_of_pixels(int cells, double cfl = 0.5);

struct Deformation {
  double error = 0;  ///< root of the mean square of the displacement's error, the largest in time, over A [-]
  Cost cost;
  std::string trouble;  ///< empty: it came to its end
};

/// Out, back and through to the other side. The body force comes as a kick before the step: USF would strain
/// the points with it before the stress has answered, which is of first order in the step and says nothing of
/// the scheme.
/// @param cells  along an edge.   @param amplitude  A [m]: 1e-4 takes no point out of its cell, 0.05 over up
/// to two of the coarsest grids' cells.
[[nodiscard]] Deformation deform_as_made_up(const Method& method, int cells, double amplitude,
                                            double cfl = 0.4);

}  // namespace mpm::problems
