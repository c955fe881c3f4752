// Precision, and numbers that are hardly any.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <vector>

#include "apps/bench/stability_scenes.hpp"

namespace app::bench {
namespace {

/// To a strain of 4e-3 in compression, where displacements are two cells: those of one cell stay small.
Finding single_precision() {
  mpm::Scene whole = block(40, 40, elastic());
  whole.loading.direction = mpm::Direction::compression;
  whole.loading.velocity = 0.4;
  whole.loading.stop_strain = 4e-3;
  mpm::Scene breaking = concrete(40, 40);
  breaking.loading = whole.loading;
  const mpm::Result exact = mpm::simulate(whole);
  const mpm::Result reference = mpm::simulate(breaking);
  whole.precision = breaking.precision = mpm::Precision::single;
  const mpm::Result rounded = mpm::simulate(whole);
  const mpm::Result broken = mpm::simulate(breaking);
  return Judge()
      .below("curve of the whole block off by", curve_difference(exact, rounded, 1), 1e-5)
      .near("peak of concrete", broken.peak_stress, reference.peak_stress, 1e-2)
      .below("its ledger off by", broken.energy_error, 1e-4)
      .must(is_finite(broken),
            fmt::format("{} of {} failures", broken.tension_failures, reference.tension_failures))
      .finding();
}

/// Very small pixels of very stiff phases, and very large ones of very soft: squares of scaled stresses stay
/// within 32 bits.
Finding single_precision_at_extremes() {
  Judge judge;
  for (const auto& [size, young] :
       {std::pair{1e-6, 1e12}, std::pair{1.0, 1e3}, std::pair{1e-6, 1e3}, std::pair{1.0, 1e12}}) {
    for (const double other_poisson : {0.2, 0.25}) {
      mpm::Scene scene = scaled(concrete(20, 20), young / 40e9);
      scene.pixel_size = size;
      scene.phases[third]->poisson = other_poisson;
      const double exact = mpm::simulate(scene).peak_stress;
      scene.precision = mpm::Precision::single;
      const double off = std::abs(mpm::simulate(scene).peak_stress / exact - 1);
      judge.below(fmt::format("{:g} m, {:.0e} Pa, {}: peak off by", size, young,
                              other_poisson == 0.2 ? "one ratio of Poisson" : "two ratios"),
                  off, 1e-2);
    }
  }
  return judge.finding();
}

/// Time of one over that of another on this core, each the least of several, taken by turns. A thread that
/// waits for its core takes no time.
template <class One, class Other>
double ratio_of_times(const One& one, const Other& other) {
  const auto time_of = [](const auto& work) {
    const auto now = [] {
      timespec time{};
      clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
      return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    };
    const double start = now();
    work();
    return now() - start;
  };
  double least_one = 1e9;
  double least_other = 1e9;
  for (int i = 0; i < 15; ++i) {
    least_one = std::min(least_one, time_of(one));
    least_other = std::min(least_other, time_of(other));
  }
  return least_one / least_other;
}

/// So slow that nothing but numbers below full precision comes of it.
mpm::Scene hardly_loaded(double velocity, mpm::Precision precision) {
  mpm::Scene scene = block(64, 64, elastic());
  scene.loading.velocity = velocity;
  scene.loading.stop_strain = 3e-4 * velocity / 0.05;
  scene.precision = precision;
  return scene;
}

/// 32 bits hold strains down to 1e-38, 64 bits down to 1e-308; a step moves the platen by 1e-7 s times its
/// speed.
Finding denormal_lattice() {
  Judge judge;
  for (const auto& [precision, tiny, name] : {std::tuple{mpm::Precision::double_, 1e-304, "double"},
                                              std::tuple{mpm::Precision::single, 1e-35, "single"}}) {
    const mpm::Scene plain = hardly_loaded(0.05, precision);
    const mpm::Scene hardly = hardly_loaded(tiny, precision);
    const double ratio =
        ratio_of_times([&] { (void)mpm::simulate(hardly); }, [&] { (void)mpm::simulate(plain); });
    judge.below(fmt::format("{}: time over that of a plain run", name), ratio, 1.15);
  }
  return judge.finding();
}

/// A disc that breathes at a speed [m/s].
mpm::Scene breathing() {
  mpm::Scene scene = sky(24, 24);
  add_disc(scene, 12, 12, 10);
  scene.motion.margin = 0.2;
  return scene;
}
void breathe(Flight& flight, double speed) {
  flight.solver.kick([&](const mpm::PointView& p, double& vx, double& vy) {
    vx = speed * (p.x - 0.6);
    vy = speed * (p.y - 0.6);
  });
}

Finding denormal_motion() {
  Flight plain(breathing());
  Flight hardly(breathing());
  breathe(plain, 0.01);
  breathe(hardly, 1e-310);
  const double ratio =
      ratio_of_times([&] { (void)hardly.solver.advance(300); }, [&] { (void)plain.solver.advance(300); });
  return Judge().below("time over that of a plain run", ratio, 1.15).finding();
}

}  // namespace

std::vector<StabilityCase> number_cases() {
  return {
      {"single-precision", "32 bits at a strain of 4e-3: the curve of 64 bits", single_precision},
      {"single-extremes",
       "32 bits with pixels of 1 micrometre and 1 m, at 1 kPa and 1 TPa: the peak of 64 bits",
       single_precision_at_extremes},
      {"denormals-lattice", "numbers below full precision do not slow small strain", denormal_lattice},
      {"denormals-motion", "nor points that move", denormal_motion},
  };
}

}  // namespace app::bench
