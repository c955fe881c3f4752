/// The softening of a crack band and of a shear band: curves, and teeth along their secants.
#pragma once

#include "libmpm/scene/phase.hpp"
#include "libmpm/scene/scene.hpp"

namespace mpm {

/// Share of its first strength below which a softening point is taken to be cracked through.
inline constexpr double exhausted = 1e-3;

/// Softening: the largest principal stress falls with the largest principal strain e,
///     s1 = peak f((e - onset) / scale)   for e > onset,
/// where the area under f is 1, so that a band of the given width dissipates the fracture energy:
///     exponential  f = exp(-x)
///     bilinear     from 1 to 1/3 at x = 0.8, to 0 at x = 3.6
///     hordijk      f = (1 + (3 y)^3) exp(-6.93 y) - y (1 + 3^3) exp(-6.93),  y = x / 5.136
/// Sources: Bazant, Oh, Mater. Struct. 16 (1983), for the band; Petersson, report TVBM-1006, Lund (1981), for
/// the two lines; Hordijk, thesis, Delft (1991).
struct Softening {
  double peak = 0;   ///< strength at which it begins [Pa]
  double onset = 0;  ///< strain at which it begins in uniaxial stress [-]
  double scale = 0;  ///< strain that times the peak is the area beyond the onset [-]; <= 0 if the band snaps
                     ///< back
  SofteningCurve curve = SofteningCurve::exponential;

  /// Largest principal stress that the point still carries [Pa].
  [[nodiscard]] double stress_at(double strain) const;
  /// Area under the curve from the onset to a strain >= onset [J/m^3].
  [[nodiscard]] double area_to(double strain) const;
};

/// @param peak  strength of the point [Pa].   @param band  width of the crack band [m].
[[nodiscard]] Softening softening(const Phase& phase, Plane plane, double peak, double band);

/// Width of a band above which a point of this strength snaps back [m]: its elastic energy would exceed its
/// fracture energy.
[[nodiscard]] double widest_band(const Phase& phase, Plane plane, double peak);

/// The same in shear: what remains of the Mohr-Coulomb strength over what the elastic stress would take of
/// it, both 1 at the onset; see shear_utilisation(). All components of the stress fall alike. In compression
/// without lateral stress the band dissipates the energy of the phase; where the sides are held, more.
/// @param factor  on the strength of the point [-].   @param band  width of the shear band [m].
[[nodiscard]] Softening shear_softening(const Phase& phase, Plane plane, double factor, double band);

/// Width of a shear band above which a point with this factor [-] snaps back [m].
[[nodiscard]] double widest_shear_band(const Phase& phase, Plane plane, double factor);

/// Strain above the onset at which the secant of the curve is this share of the elastic stiffness [-].
/// @param kept  the share [-], > 0.   @param strain  a smaller strain than the result, from the onset on [-].
[[nodiscard]] double strain_of_secant(const Softening& curve, double kept, double strain);

/// A softening point whose stress falls and rises by teeth, along secants of its softening curve.
struct Tooth {
  double kept = 0;      ///< share of its stiffness that remains [-]; 0 = cracked through
  double strength = 0;  ///< largest principal stress that it carries with it [Pa]
};
/// The tooth after a point has reached its strength. Each keeps nine tenths of the stiffness of the one
/// before; its strength is such that all teeth so far have dissipated what the curve dissipates up to the
/// next secant, and no more than the peak. So the fracture energy is exact, and the peak is that of the
/// curve. Source: after Rots, Invernizzi, Int. J. Numer. Anal. Meth. Geomech. 28 (2004), saw-tooth softening.
/// @param kept     share of its stiffness that the point has now [-].
/// @param elastic  largest principal stress of the intact point [Pa]; teeth that it exceeds are passed over.
[[nodiscard]] Tooth next_tooth(const Softening& curve, double kept, double elastic);

}  // namespace mpm
