// Compiled once per instruction set, with MPM_KERNELS naming the table that it defines. Everything here but
// that table is local to the file, and what comes in from outside is always inlined: no code for a newer
// processor can leak into the rest.
#include "libmpm/kernels/moving_kernels.hpp"

#include "libmpm/kernels/moving_gather.hpp"
#include "libmpm/kernels/moving_nodes.hpp"
#include "libmpm/kernels/moving_scatter.hpp"
#include "libmpm/kernels/moving_strain.hpp"

namespace mpm::moving {
namespace {

/// Kinetic energy, and the elastic energy 1/2 V s : e with e of the stress that an intact point would carry.
template <class Real, bool closure>
Energies measure_energies(const TileRow<Real>& in, const Step<Real>& step) {
  const TileRow<Real> row = in;
  const Pack<Real> zero{};
  Energies sum;
  for (int block = 0; block < row.blocks; ++block) {
    for (int slot = 0; slot < row.used[block]; ++slot) {
      const Real* record = record_of(row, block, slot);
      const Pack<Real> v_x = field(record, Field::vx);
      const Pack<Real> v_y = field(record, Field::vy);
      sum.kinetic += sum_of<Real>(Real(0.5) * field(record, Field::mass) * (v_x * v_x + v_y * v_y));
      const Stress<Pack<Real>> e = stress_of<Real>(record);
      const Stress<Pack<Real>> s = carried<Real, closure>(e, row, record, step.unilateral);
      const Pack<Real> lame = field(record, Field::lame);
      const Pack<Real> shear = field(record, Field::shear);
      const Mask<Real> carries = shear > zero;
      const Pack<Real> g = carries ? shear : all<Real>(1);
      const Pack<Real> product = s.xx * e.xx + s.yy * e.yy + 2 * s.xy * e.xy;
      const Pack<Real> traces = (s.xx + s.yy) * (e.xx + e.yy);
      const Pack<Real> energy =
          Real(0.25) * field(record, Field::volume) * (product - Real(0.5) * lame / (lame + g) * traces) / g;
      sum.elastic += sum_of<Real>(carries ? energy : zero);
    }
  }
  return sum;
}

template <class Real, Stencil stencil, Scattered what>
Scatter<Real> scatter_for(const Features& f) {
  constexpr bool moves_mass = what != Scattered::force;
  constexpr bool pushes = what != Scattered::momentum;
  const bool affine = moves_mass && f.transfer == Return::apic;
  const bool closure = pushes && f.crack_closure;
  if (affine)
    return closure ? scatter<Real, stencil, what, moves_mass, pushes>
                   : scatter<Real, stencil, what, moves_mass, false>;
  return closure ? scatter<Real, stencil, what, false, pushes> : scatter<Real, stencil, what, false, false>;
}

template <class Real, Stencil stencil, bool maps_back>
Gather<Real> gather_for(const Features& f) {
  switch (f.transfer) {
    case Return::flip:
      return gather<Real, stencil, Return::flip, maps_back>;
    case Return::blend:
      return gather<Real, stencil, Return::blend, maps_back>;
    case Return::apic:
      break;
  }
  return gather<Real, stencil, Return::apic, maps_back>;
}

template <class Real, Stencil stencil, Followed what>
Follow<Real> follow_for(const Features& f) {
  using kernels::Check;
  if (f.crack_closure) return follow<Real, stencil, what, Check::tension_and_shear, true>;
  switch (f.check) {
    case Check::none:
      return follow<Real, stencil, what, Check::none, false>;
    case Check::tension:
      return follow<Real, stencil, what, Check::tension, false>;
    case Check::tension_and_shear:
      break;
  }
  return follow<Real, stencil, what, Check::tension_and_shear, false>;
}

template <class Real, Stencil stencil>
Sweeps<Real> sweeps_of(const Features& f) {
  return {
      .lanes = lanes<Real>,
      .scatter = scatter_for<Real, stencil, Scattered::both>(f),
      .scatter_momentum = scatter_for<Real, stencil, Scattered::momentum>(f),
      .scatter_force = scatter_for<Real, stencil, Scattered::force>(f),
      .gather = gather_for<Real, stencil, false>(f),
      .gather_and_map_back = gather_for<Real, stencil, true>(f),
      .strain = follow_for<Real, stencil, Followed::stress>(f),
      .move = follow<Real, stencil, Followed::place, kernels::Check::none, false>,
      .strain_and_move = follow_for<Real, stencil, Followed::both>(f),
      .deform = deform<Real, stencil>,
      .measure_energies = f.crack_closure ? measure_energies<Real, true> : measure_energies<Real, false>,
      .sum_momentum = sum_momentum<Real, stencil>,
      .sum_new_momentum = sum_new_momentum<Real, stencil>,
      .integrate = f.damping ? integrate<Real, stencil, true> : integrate<Real, stencil, false>,
  };
}

template <class Real>
Sweeps<Real> sweeps(const Features& f) {
  return f.stencil == Stencil::linear ? sweeps_of<Real, Stencil::linear>(f)
                                      : sweeps_of<Real, Stencil::quadratic>(f);
}

}  // namespace

#define MPM_TEXT_OF(name) #name
#define MPM_TEXT(name) MPM_TEXT_OF(name)
extern const Kernels MPM_KERNELS = {MPM_TEXT(MPM_KERNELS), sweeps<float>, sweeps<double>};

}  // namespace mpm::moving
