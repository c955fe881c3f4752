/// Stress of moving points: rate, closed cracks, and the failure test. Private to moving_kernels.cpp.
#pragma once

#include "libmpm/kernels/moving_weights.hpp"
#include "libmpm/material/stress.hpp"

namespace mpm::moving {
namespace {  // a copy for each instruction set

/// Square root lane by lane, for stress.hpp.
template <class Real>
MPM_INLINE Pack<Real> root(const Pack<Real>& value) {
  Pack<Real> result = value;
  for (int i = 0; i < lanes<Real>; ++i) result[i] = square_root(value[i]);
  return result;
}

/// without_tension() of stress.hpp for a vector of points.
template <class Real>
MPM_INLINE Stress<Pack<Real>> closed_crack(const Stress<Pack<Real>>& s, const Pack<Real>& lateral) {
  const Pack<Real> zero{};
  const Pack<Real> mean = Real(0.5) * (s.xx + s.yy);
  const Pack<Real> deviator = Real(0.5) * (s.xx - s.yy);
  const Pack<Real> radius = root<Real>(deviator * deviator + s.xy * s.xy);
  const Pack<Real> top = mean + radius;
  const Pack<Real> opening = top > zero ? top : zero;
  const Pack<Real> first = top - opening;
  const Pack<Real> rest = mean - radius - lateral * opening;
  const Pack<Real> second = rest < zero ? rest : zero;
  const Pack<Real> new_mean = Real(0.5) * (first + second);
  const Pack<Real> ratio = Real(0.5) * (first - second) / (radius > zero ? radius : all<Real>(1));
  return {new_mean + deviator * ratio, new_mean - deviator * ratio, s.xy * ratio};
}

/// Stress that the points carry: that of their record, or of its closed crack.
template <class Real, bool closure>
MPM_INLINE Stress<Pack<Real>> carried(const Stress<Pack<Real>>& s, const TileRow<Real>& row,
                                      const Real* record, Real unilateral) {
  if constexpr (!closure) {
    return s;
  } else {
    const Pack<Real> zero{};
    const Pack<Real> lame = field(record, Field::lame);
    const Pack<Real> axial = lame + 2 * field(record, Field::shear);
    const Pack<Real> lateral = unilateral * lame / (axial > zero ? axial : all<Real>(1));
    const Stress<Pack<Real>> c = closed_crack<Real>(s, lateral);
    const Pack<Real> cracked = field(record, row.layout.cracked);
    const Pack<Real> whole = 1 - cracked;
    return {whole * s.xx + cracked * c.xx, whole * s.yy + cracked * c.yy, whole * s.xy + cracked * c.xy};
  }
}

template <class Real>
MPM_INLINE Stress<Pack<Real>> stress_of(const Real* record) {
  return {field(record, Field::sxx), field(record, Field::syy), field(record, Field::sxy)};
}

/// Displacement gradient of the step, dt grad(v) [-].
template <class Real>
struct Gradient {
  Pack<Real> xx, xy, yx, yy;  ///< of component by direction
};
template <class Real, int N>
MPM_INLINE Gradient<Real> gradient(const TileNodes<Real, N>& vx, const TileNodes<Real, N>& vy,
                                   const Weights<Real, N>& x, const Weights<Real, N>& y, Real per_x,
                                   Real per_y) {
  const Slopes<Real> of_x = slopes<Real>(vx, x, y);
  const Slopes<Real> of_y = slopes<Real>(vy, x, y);
  return {per_x * of_x.across, per_y * of_x.upwards, per_x * of_y.across, per_y * of_y.upwards};
}

/// Change of volume and stress in a step.
template <class Real>
struct Strained {
  Pack<Real> growth;  ///< of the volume [-]
  Stress<Pack<Real>> stress;
};
/// Jaumann rate: the stress is rotated with the spin and then incremented by C : strain. Both use the
/// displacement gradient with respect to the positions at mid-step,
///   G (1 + G / 2)^-1 = (G + det(G) / 2) / D,   D = det(1 + G / 2).
/// For a rotation this is a spin without strain. For nodes that move along tangents while the body rotates it
/// is the resulting stretch; with the gradient at the beginning of the step this stretch would be zero, and a
/// rotating body would grow with every step. The rotation conserves the norm: tan(angle / 2) = spin / 2.
/// Source: Hughes, Winget (1980).
template <class Real>
MPM_INLINE Strained<Real> turned_and_loaded(const Stress<Pack<Real>>& s, const Gradient<Real>& g,
                                            const Pack<Real>& lame, const Pack<Real>& shear) {
  const Pack<Real> trace = g.xx + g.yy;
  const Pack<Real> det = g.xx * g.yy - g.xy * g.yx;
  const Pack<Real> d = 1 + Real(0.5) * trace + Real(0.25) * det;
  const Pack<Real> per_d = 1 / d;
  // The tangent of half the angle is spin / d.
  const Pack<Real> spin = Real(0.25) * (g.yx - g.xy);
  const Pack<Real> per_square = 1 / (d * d + spin * spin);
  const Pack<Real> sine = 2 * spin * d * per_square;
  const Pack<Real> cosine = (d * d - spin * spin) * per_square;
  const Pack<Real> cos2 = 1 - 2 * sine * sine;
  const Pack<Real> sin2 = 2 * sine * cosine;
  const Pack<Real> mean = Real(0.5) * (s.xx + s.yy);
  const Pack<Real> deviator = Real(0.5) * (s.xx - s.yy);
  const Pack<Real> turned = deviator * cos2 - s.xy * sin2;
  const Pack<Real> turned_xy = deviator * sin2 + s.xy * cos2;
  const Pack<Real> stiffness = shear * per_d;
  const Pack<Real> volumetric = (lame * per_d) * (trace + det) + stiffness * (trace + det);
  const Pack<Real> deviatoric = turned + stiffness * (g.xx - g.yy);
  const Pack<Real> pressure = mean + volumetric;
  return {1 + trace + det,
          {pressure + deviatoric, pressure - deviatoric, turned_xy + stiffness * (g.xy + g.yx)}};
}

/// Lanes in which a point may fail; the same test as in lattice_kernels.cpp. Not-a-number is
/// suspect.
template <kernels::Check check, class Real>
MPM_INLINE Mask<Real> suspect_lanes(const Stress<Pack<Real>>& s, const TileRow<Real>& row,
                                    const Real* record) {
  const Pack<Real> zero{};
  const Pack<Real> det = s.xx * s.yy - s.xy * s.xy;
  const Pack<Real> sum = s.xx + s.yy;
  const Pack<Real> tension = field(record, row.layout.tension);
  const Pack<Real> reserve = tension - sum;
  Mask<Real> safe = (tension * reserve + det >= zero) & (tension + reserve >= zero);
  if constexpr (check == kernels::Check::tension_and_shear) {
    const Pack<Real> crush = field(record, row.layout.crush);
    const Pack<Real> depth = crush + sum;
    safe &= (crush * depth + det >= zero) & (crush + depth >= zero);
  }
  return ~safe;
}

}  // namespace
}  // namespace mpm::moving
