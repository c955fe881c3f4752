// The path on which the platens go back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "libmpm/run/simulate.hpp"
#include "libmpm/solver/quasi_static/quasi_static_solver.hpp"
#include "tests/libmpm/sample_scenes.hpp"
#include "tests/libmpm/solver/quasi_static/quasi_static_runs.hpp"

namespace quasi_static_solver_snap_back_test {

using mpm::Result;
using mpm::Scene;

/// A bar of `rows` rows, of which one can break at 3 MPa, on the path that snaps back.
Scene bar(int rows, bool pixel = true) {
  Scene scene = samples::unbreakable(samples::mortar_block(rows, 8));
  scene.method = mpm::SolverMethod::quasi_static;
  scene.loading.path = mpm::LoadingPath::snap_back;
  scene.pixel_cells = pixel;
  scene.points_per_cell = pixel ? 1 : 2;
  scene.loading.stop_strain = 0.5;
  for (auto& phase : scene.phases)
    if (phase) phase->poisson = 0;
  mpm::Phase weak = *scene.phases[samples::mortar];
  weak.tensile_scale = 3e6;
  weak.weibull_modulus = 1e9;
  scene.phases[samples::aggregate] = weak;
  scene.labels.middleRows(rows / 2, pixel ? 1 : 2).setConstant(samples::aggregate);
  return scene;
}

// Only the row that breaks has lost energy; the rest has given its own back to the platens.
TEST(QuasiStaticSnapBack, ABrittleBarGivesItsEnergyBack) {
  for (const bool pixel : {true, false})
    for (const int rows : {12, 40}) {
      const Scene scene = bar(rows, pixel);
      const Result result = mpm::simulate(scene);
      ASSERT_EQ(result.history.size(), 4U);  // rest, peak, broken, end
      const double young = scene.phases[samples::mortar]->young;
      const int broken = pixel ? 1 : 2;
      EXPECT_NEAR(result.history[1].stress, 3e6, 10);
      EXPECT_NEAR(result.history[1].strain, 3e6 / young, 1e-9);
      EXPECT_EQ(result.history[2].stress, 0);
      EXPECT_NEAR(result.history[2].strain, 3e6 / young * broken / rows, 1e-9);
      EXPECT_EQ(result.history[3].strain, 0.5);
      const double lost = 0.5 * 3e6 * 3e6 / young * scene.width() * broken * scene.pixel_size;
      EXPECT_NEAR(result.history.back().released, lost, 1e-5 * lost);
      EXPECT_NEAR(result.history.back().platen_work, lost, 1e-5 * lost);
      EXPECT_NEAR(samples::area_under(result, scene), lost, 1e-5 * lost);
      EXPECT_LT(result.energy_error, 1e-12);
    }
}

// However long the bar: it cannot be measured by platens that only go on.
TEST(QuasiStaticSnapBack, ALongBarDissipatesTheFractureEnergyOfItsBand) {
  for (const bool pixel : {true, false})
    for (const int rows : {12, 100, 300}) {
      Scene scene = bar(rows, pixel);
      constexpr double energy = 20;
      scene.phases[samples::aggregate]->fracture_energy = energy;
      const Result result = mpm::simulate(scene);
      const double expected = energy * scene.width();
      EXPECT_NEAR(result.peak_stress, 3e6, 100);
      EXPECT_NEAR(result.history.back().released, expected, 0.01 * expected) << rows << " " << pixel;
      EXPECT_NEAR(samples::area_under(result, scene), expected, 0.01 * expected);
      // Half way down its strain is larger than at the peak, or smaller.
      const auto peak = std::find_if(result.history.begin(), result.history.end(),
                                     [](const mpm::HistoryRow& row) { return row.stress > 2.99e6; });
      const auto half = std::find_if(peak, result.history.end(),
                                     [](const mpm::HistoryRow& row) { return row.stress < 1.5e6; });
      ASSERT_NE(half, result.history.end());
      EXPECT_EQ(half->strain<result.peak_strain, rows> 100) << rows;
    }
}

Scene concrete(std::uint64_t seed = 1) {
  Scene scene = samples::small_concrete(40, 40);
  scene.method = mpm::SolverMethod::quasi_static;
  scene.pixel_cells = true;
  scene.points_per_cell = 1;
  scene.loading.stop_strain = 1e-3;
  scene.damage.seed = seed;
  scene.event_tolerance = 0;
  return scene;
}

TEST(QuasiStaticSnapBack, TheFirstFailuresAndThePeakAreThoseOfPlatensThatOnlyGoOn) {
  Scene scene = concrete();
  const Result still = mpm::simulate(scene);
  scene.loading.path = mpm::LoadingPath::snap_back;
  const Result back = mpm::simulate(scene);
  // One failure at a time, the sequence is the same; only the strains differ.
  for (const mpm::HistoryRow& row : still.history) {
    if (row.tension_failures > 20) break;
    const auto same = std::find_if(back.history.begin(), back.history.end(), [&](const mpm::HistoryRow& one) {
      return one.tension_failures == row.tension_failures && one.stress == row.stress;
    });
    EXPECT_NE(same, back.history.end()) << row.tension_failures;
  }
  EXPECT_NEAR(back.peak_stress, still.peak_stress, 1e-6 * still.peak_stress);
  EXPECT_LT(back.history.back().released, 0.9 * still.history.back().released);
  EXPECT_LT(back.energy_error, 1e-12);
}

TEST(QuasiStaticSnapBack, TheWorkIsTheAreaUnderItsCurve) {
  Scene scene = concrete(2);
  scene.loading.path = mpm::LoadingPath::snap_back;
  const Result result = mpm::simulate(scene);
  const double work = result.history.back().platen_work;
  EXPECT_NEAR(samples::area_under(result, scene), work, 0.02 * work);
}

TEST(QuasiStaticSnapBack, FailuresAreRecordedAtTheLargestStrainSoFar) {
  Scene scene = concrete();
  scene.loading.path = mpm::LoadingPath::snap_back;
  const Result result = mpm::simulate(scene);
  std::int64_t until_peak = 0;
  std::int64_t failed_until_peak = 0;
  double so_far = 0;
  for (const mpm::HistoryRow& row : result.history) {
    if (row.strain >= so_far) until_peak = row.tension_failures;
    so_far = std::max(so_far, row.strain);
    if (so_far > result.peak_strain) break;
  }
  for (const float strain : result.failure_strain.reshaped())
    failed_until_peak += static_cast<double>(strain) < so_far * (1 - 1e-6) ? 1 : 0;
  EXPECT_EQ(failed_until_peak, until_peak);
}

TEST(QuasiStaticSnapBack, GoesOnAsIfItHadNeverStopped) {
  for (const double energy : {0.0, 100.0}) {
    Scene scene = concrete();
    scene.loading.path = mpm::LoadingPath::snap_back;
    scene.event_tolerance = 0.02;
    samples::set_fracture_energy(scene, energy);
    const Result whole = mpm::simulate(scene);
    const samples::Interrupted run = samples::stopped_after(scene, 60);
    EXPECT_EQ(run.half.stop, mpm::StopReason::interrupted);
    const Result resumed = mpm::resume(scene, run.kept);
    ASSERT_EQ(resumed.history.size(), whole.history.size());
    for (std::size_t i = 0; i < whole.history.size(); ++i) {
      EXPECT_EQ(resumed.history[i].strain, whole.history[i].strain) << i;
      EXPECT_EQ(resumed.history[i].platen_work, whole.history[i].platen_work) << i;
    }
    EXPECT_TRUE((resumed.failure_strain.isNaN() == whole.failure_strain.isNaN()).all());
  }
}

}  // namespace quasi_static_solver_snap_back_test
