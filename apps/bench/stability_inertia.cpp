// What is not at rest: inertia and damping at their extremes, and what is said of them.
#include <fmt/format.h>

#include <cmath>

#include "apps/bench/stability_scenes.hpp"
#include "apps/job/job.hpp"
#include "apps/run/error_estimation.hpp"
#include "apps/run/run_remarks.hpp"
#include "apps/text/complaint.hpp"
#include "libmpm/scene/error.hpp"

namespace app::bench {
namespace {

constexpr double strength = 3e6;  // [Pa]

/// A block in which every point has the same strength, so that its peak is that; in cells of 2 x 2 pixels.
mpm::Scene even_block(int rows, int cols, double poisson = 0.2) {
  mpm::Phase phase = elastic(20e9, poisson);
  phase.tensile_scale = strength;
  phase.weibull_modulus = 1e9;
  mpm::Scene scene = block(rows, cols, phase);
  scene.pixel_cells = false;
  scene.points_per_cell = 2;
  return scene;
}

mpm::Scene breaking_concrete() {
  mpm::Scene scene = concrete(40, 40);
  scene.pixel_cells = false;
  scene.points_per_cell = 2;
  return scene;
}

/// That a run is said not to be a slow test, with a figure.
void must_say(Judge& judge, const mpm::Scene& scene, const std::string& what) {
  const std::string note = inertia_note(mpm::simulate(scene), scene);
  judge.must(note.find(what) != std::string::npos, note.empty() ? "nothing was said" : note);
}

Finding ramp_incompressible() {
  Judge judge;
  for (const int cols : {16, 64}) {
    const mpm::Result result = mpm::simulate(even_block(16, cols, 0.4999));
    judge.near(fmt::format("16 x {} pixels: peak", cols), result.peak_stress, strength, 0.05);
  }
  return judge.finding();
}

Finding void_across() {
  Judge judge;
  app::Settings settings;
  settings.scene.pixel_cells = false;
  settings.scene.points_per_cell = 2;
  specimen::Specimen parts;
  parts.mask.pixel_size = 0.5e-3;
  parts.mask.labels = specimen::Raster<std::uint8_t>(16, 16, specimen::phase::mortar);
  for (int col = 0; col < 16; ++col) parts.mask.labels(8, col) = specimen::phase::void_;
  for (const auto kinematics : {mpm::Kinematics::small_strain, mpm::Kinematics::moving}) {
    settings.scene.kinematics = kinematics;
    try {
      (void)build_scene(parts, settings);
      judge.must(false, "it was taken");
    } catch (const Rejected& refusal) {
      judge.must(true, refusal.what());
    }
  }
  return judge.finding();
}

/// At full speed at once and with short steps the platen must move its own nodes: a force without an end.
Finding first_wave() {
  mpm::Scene scene = even_block(24, 8);
  scene.loading.velocity = 0.5;
  scene.loading.ramp_time = 0;
  scene.cfl = 0.02;
  scene.history_rows = 20000;
  const mpm::Result result = mpm::simulate(scene);
  double largest = 0;
  for (const mpm::HistoryRow& row : result.history) largest = std::max(largest, row.stress);
  Judge judge;
  judge.must(largest > 3 * strength, fmt::format("largest mean reaction {:.3g} MPa", 1e-6 * largest));
  judge.must(result.peak_stress < 1.3 * strength, fmt::format("peak {:.3g} MPa", 1e-6 * result.peak_stress));
  must_say(judge, scene, "which is a wave and no peak");
  return judge.finding();
}

Finding inertia_is_said() {
  Judge judge;
  mpm::Scene fast = breaking_concrete();
  fast.loading.velocity = 10;
  must_say(judge, fast, "% of the work of the platens is motion");
  mpm::Scene heavy = breaking_concrete();
  for (auto& phase : heavy.phases)
    if (phase) phase->density = 1e8;
  must_say(judge, heavy, "of the reactions of the platens do not balance");
  return judge.finding();
}

Finding damping_is_said() {
  mpm::Scene scene = breaking_concrete();
  scene.local_damping = 0.99;
  Judge judge;
  must_say(judge, scene, "of it went into local damping");
  return judge.finding();
}

Finding outrun() {
  mpm::Scene scene = breaking_concrete();
  scene.loading.velocity = 1e30;
  try {
    (void)mpm::plan(scene);
    return Judge().must(false, "1e30 m/s was taken").finding();
  } catch (const mpm::Error& error) {
    return Judge().must(error.field == "loading.velocity", error.what()).finding();
  }
}

/// The ledger of cracks that close, in long and in short steps.
Finding closing_band() {
  Judge judge;
  double before = 1;
  for (const double cfl : {0.8, 0.2, 0.05}) {
    mpm::Scene scene = breaking_concrete();
    for (auto& phase : scene.phases)
      if (phase && phase->can_fail()) {
        phase->tensile_scale = 4e6;
        phase->weibull_modulus = 4;
        phase->fracture_energy = 20;
      }
    scene.loading.velocity = 0.2;
    scene.loading.stop_strain = 6e-4;
    scene.damage.crack_closure = mpm::CrackClosure::unilateral;
    scene.cfl = cfl;
    const double error = mpm::simulate(scene).energy_error;
    judge.below(fmt::format("CFL {}: ledger off by", cfl), error, std::min(1e-3, before));
    before = error;
  }
  return judge.finding();
}

/// Waves make explicit runs agree on what is no static strength, compression more than tension; rates that
/// agree by chance must not hide it.
Finding waves_are_estimated() {
  Judge judge;
  for (const auto direction : {mpm::Direction::tension, mpm::Direction::compression}) {
    const bool pulls = direction == mpm::Direction::tension;
    mpm::Scene scene = breaking_concrete();
    scene.loading.direction = direction;
    scene.loading.velocity = pulls ? 0.1 : 0.4;
    scene.loading.stop_strain = pulls ? 5e-4 : 5e-3;
    scene.local_damping = 0;
    mpm::Scene still = scene;
    still.method = mpm::SolverMethod::quasi_static;
    still.event_tolerance = 0;
    const mpm::Result base = mpm::simulate(scene);
    const double truth = mpm::simulate(still).peak_stress;
    const auto solve = [](const mpm::Scene& other) { return mpm::simulate(other); };
    const double estimate = estimate_error(scene, base, solve).sources.front().stress_error;
    const double error = std::abs(truth / base.peak_stress - 1);
    judge.must(estimate >= error && estimate <= 3 * error + 0.02,
               fmt::format("{}: off by {:.3g}, estimated {:.3g}", pulls ? "tension" : "compression", error,
                           estimate));
  }
  const auto agreeing = [](const mpm::Scene&) {
    mpm::Result result;
    result.peak_stress = 1e6;
    result.peak_strain = 1e-4;
    return result;
  };
  mpm::Scene closing = breaking_concrete();
  closing.loading.direction = mpm::Direction::compression;
  closing.damage.crack_closure = mpm::CrackClosure::clipped;
  const double of_none = estimate_error(closing, agreeing(closing), agreeing).stress_error();
  judge.must(of_none >= 0.4,
             fmt::format("three rates that agree, and no equilibrium to compare with: {:.2g}", of_none));
  return judge.finding();
}

/// A label picture of twice the pixel size, again and again.
Finding coarser_labels() {
  Judge judge;
  mpm::Scene scene = concrete(320, 320);
  const auto share = [](const mpm::Scene& of, int label) {
    return static_cast<double>((of.labels.array() == label).count()) / static_cast<double>(of.labels.size());
  };
  const double stones = share(scene, first);
  const double width = scene.width();
  for (int times = 0; times < 3; ++times) {
    const double ring = share(scene, third);
    scene = coarsened(scene);
    judge.near(fmt::format("pixels of {:.0f} mm: share of aggregate", 1e3 * scene.pixel_size),
               share(scene, first), stones, 0.02);
    const double grown = share(scene, third) / ring;  // a ring of one pixel is twice as wide
    judge.must(grown > 0.9 && grown < 3, fmt::format("ITZ times {:.2f}", grown));
  }
  judge.near("width", scene.width(), width, 1e-12);
  return judge.finding();
}

}  // namespace

std::vector<StabilityCase> inertia_cases() {
  return {
      {"ramp-incompressible", "nu 0.4999, narrow and wide: a slow enough start, the strength of the points",
       ramp_incompressible},
      {"void-across", "a void of one pixel from side to side, in cells of two: refused", void_across},
      {"first-wave", "full speed at once, in steps of 0.02: the wave of the start is no peak, and is told",
       first_wave},
      {"inertia", "10 m/s, and 1e8 kg/m3: the share of inertia in the peak is told", inertia_is_said},
      {"damping", "local damping 0.99: its share in the peak is told", damping_is_said},
      {"waves", "too fast by far: the estimated error covers the distance from equilibrium",
       waves_are_estimated},
      {"outrun", "1e30 m/s: no platen outruns the wave that it sends; refused", outrun},
      {"closing-band", "cracks that soften and close: a ledger that closes the better the shorter the step",
       closing_band},
      {"coarser-labels", "labels at two, four and eight times the pixel size: as much aggregate, whole rings",
       coarser_labels},
  };
}

}  // namespace app::bench
