/// Stress in the plane, for the sweeps and for the slow path beside them.
/// Always inlined, so that no copy compiled for one instruction set is ever called from another.
#pragma once

namespace mpm {

template <class Real>
struct Stress {
  Real xx = 0, yy = 0, xy = 0;
};

__attribute__((always_inline)) inline float square_root(float value) { return __builtin_sqrtf(value); }
__attribute__((always_inline)) inline double square_root(double value) { return __builtin_sqrt(value); }

/// Principal stresses clipped at zero, directions kept: what a crack that can close transmits.
template <class Real>
__attribute__((always_inline)) inline Stress<Real> without_tension(const Stress<Real>& s) {
  const Real half = Real(0.5);
  const Real mean = half * (s.xx + s.yy);
  const Real deviator = half * (s.xx - s.yy);
  const Real radius = square_root(deviator * deviator + s.xy * s.xy);
  const Real first = mean + radius < 0 ? mean + radius : Real(0);
  const Real second = mean - radius < 0 ? mean - radius : Real(0);
  const Real clipped_mean = half * (first + second);
  const Real ratio = half * (first - second) / (radius > 0 ? radius : Real(1));
  return {clipped_mean + deviator * ratio, clipped_mean - deviator * ratio, s.xy * ratio};
}

/// Stress of an isotropic phase. lame [Pa], shear [Pa]; gxy is the engineering shear strain.
template <class Real>
__attribute__((always_inline)) inline Stress<Real> elastic_stress(Real lame, Real shear, Real exx, Real eyy,
                                                                  Real gxy) {
  const Real volumetric = lame * (exx + eyy);
  return {volumetric + 2 * shear * exx, volumetric + 2 * shear * eyy, shear * gxy};
}

}  // namespace mpm
