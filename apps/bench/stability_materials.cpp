// Stiffness, Poisson's ratio and density at their extremes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/bench/stability_scenes.hpp"
#include "libmpm/scene/error.hpp"

namespace app::bench {
namespace {

/// Two phases in layers without lateral strain: the moduli add in series across them, in parallel along them.
double modulus_of_layers(double contrast, bool across) {
  mpm::Scene scene = block(16, 8, elastic(20e9, 0));
  scene.phases.emplace_back(elastic(20e9 / contrast, 0));
  if (across)
    scene.labels.topRows(8).setConstant(second);
  else
    scene.labels.leftCols(4).setConstant(second);
  load_slowly(scene);
  return end_modulus(mpm::simulate(scene));
}

Finding contrast() {
  Judge judge;
  for (const double contrast : {1.0, 1e2, 1e4, 1e6}) {
    const double soft = 20e9 / contrast;
    judge.near(fmt::format("at 1 to {:.0e}: across", contrast), modulus_of_layers(contrast, true),
               2 / (1 / 20e9 + 1 / soft), 1e-2);
    judge.near("along", modulus_of_layers(contrast, false), 0.5 * (20e9 + soft), 1e-2);
  }
  return judge.finding();
}

Finding nearly_incompressible() {
  mpm::Scene scene = block(16, 16, elastic(20e9, 0.4999));
  load_slowly(scene);
  const mpm::Result result = mpm::simulate(scene);
  Judge judge;
  judge.near("modulus", end_modulus(result), plane_modulus(*scene.phases[first]), 1e-2);
  scene.phases[first]->poisson = 0.49995;
  try {
    (void)mpm::plan(scene);
    judge.must(false, "0.49995 was taken");
  } catch (const mpm::Error& error) {
    judge.must(error.field == "phases.elastic.poisson", fmt::format("0.49995 is refused: {}", error.what()));
  }
  return judge.finding();
}

mpm::Result scaled_concrete(double s, double r) { return mpm::simulate(scaled(concrete(20, 20), s, r)); }

Finding young_moduli() {
  const mpm::Result plain = scaled_concrete(1, 1);
  Judge judge;
  judge.must(plain.tension_failures > 50, fmt::format("{} points fail", plain.tension_failures));
  for (const double young : {1e3, 1e6, 1e12}) {
    const double s = young / 40e9;
    const mpm::Result result = scaled_concrete(s, 1);
    judge.below(fmt::format("at {:.0e} Pa: curve differs by", young), curve_difference(plain, result, 1 / s),
                1e-6);
    judge.below("ledger off by", result.energy_error, 1e-9);
  }
  return judge.finding();
}

Finding densities() {
  const mpm::Result plain = scaled_concrete(1, 1);
  Judge judge;
  for (const double density : {1.0, 100.0, 2e4}) {
    const mpm::Result result = scaled_concrete(1, density / 2400);
    judge.below(fmt::format("at {:g} kg/m3: curve differs by", density), curve_difference(plain, result, 1),
                1e-6);
    judge.below("ledger off by", result.energy_error, 1e-9);
  }
  return judge.finding();
}

/// Mass has no say in what is static.
Finding density_contrast() {
  mpm::Scene scene = checkerboard(elastic(20e9, 0.2, 1), elastic(20e9, 0.2, 2e4));
  load_slowly(scene);
  const mpm::Result result = mpm::simulate(scene);
  return Judge()
      .near("modulus", end_modulus(result), plane_modulus(*scene.phases[first]), 1e-2)
      .below("ledger off by", result.energy_error, 1e-2)
      .finding();
}

}  // namespace

std::vector<StabilityCase> material_cases() {
  return {
      {"contrast",
       "layers whose stiffness differs by 1 to 1e6: the moduli of Reuss across and Voigt along them",
       contrast},
      {"incompressible", "Poisson's ratio 0.4999 in plane strain: E / (1 - nu^2); beyond it a refusal",
       nearly_incompressible},
      {"young", "Young's modulus 1 kPa to 1 TPa: the curve of concrete, scaled", young_moduli},
      {"density", "density 1 to 2e4 kg/m3: the curve of concrete", densities},
      {"density-contrast", "neighbours of 1 and 2e4 kg/m3: the modulus of the one stiffness",
       density_contrast},
  };
}

}  // namespace app::bench
