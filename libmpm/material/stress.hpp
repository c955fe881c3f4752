/// Stress in the plane: elastic, and of a crack that closes; for the sweeps and for the exact criteria.
/// Always inlined, so that no copy compiled for one instruction set is ever called from another.
#pragma once

namespace mpm {

template <class Real>
struct Stress {
  Real xx = 0, yy = 0, xy = 0;
};

__attribute__((always_inline)) inline float square_root(float value) { return __builtin_sqrtf(value); }
__attribute__((always_inline)) inline double square_root(double value) { return __builtin_sqrt(value); }

/// Stress of a cracked point that still carries compression: a material without tensile strength, that is the
/// elastic stress minus the stress of a crack opening. The first principal stress is set to zero if positive;
/// the second loses the part due to Poisson's effect of the opening, and is then set to zero if positive.
/// Principal directions do not change.
/// @param lateral  lateral stress caused by a unit stress if lateral strain is prevented [-]: nu / (1 - nu)
/// in
///                 plane strain, nu in plane stress. With 0 the principal stresses are only clipped; this law
///                 has no potential.
/// Source: Del Piero, Meccanica 24 (1989), constitutive equation of masonry-like materials.
template <class Real>
__attribute__((always_inline)) inline Stress<Real> without_tension(const Stress<Real>& s, Real lateral) {
  const Real half = Real(0.5);
  const Real zero = Real(0);
  const Real mean = half * (s.xx + s.yy);
  const Real deviator = half * (s.xx - s.yy);
  const Real radius = square_root(deviator * deviator + s.xy * s.xy);
  const Real opening = mean + radius > zero ? mean + radius : zero;
  const Real first = mean + radius - opening;
  const Real rest = mean - radius - lateral * opening;
  const Real second = rest < zero ? rest : zero;
  const Real new_mean = half * (first + second);
  const Real ratio = half * (first - second) / (radius > zero ? radius : Real(1));
  return {new_mean + deviator * ratio, new_mean - deviator * ratio, s.xy * ratio};
}

/// Stress of an isotropic phase. lame [Pa], shear [Pa]; gxy is the engineering shear strain.
template <class Real>
__attribute__((always_inline)) inline Stress<Real> elastic_stress(Real lame, Real shear, Real exx, Real eyy,
                                                                  Real gxy) {
  const Real volumetric = lame * (exx + eyy);
  return {volumetric + 2 * shear * exx, volumetric + 2 * shear * eyy, shear * gxy};
}

}  // namespace mpm
