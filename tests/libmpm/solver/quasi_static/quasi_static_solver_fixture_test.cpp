// Specimens that are held, loaded and measured as in a laboratory, against the theory of beams.
#include <gtest/gtest.h>

#include <cmath>

#include "libmpm/run/simulate.hpp"
#include "libmpm/scene/error.hpp"
#include "libmpm/solver/plan.hpp"
#include "tests/libmpm/sample_scenes.hpp"
#include "tests/libmpm/solver/quasi_static/quasi_static_runs.hpp"

namespace fixture_test {

using mpm::Gauge;
using mpm::Load;
using mpm::Result;
using mpm::Scene;
using mpm::Side;
using mpm::Way;

Scene quasi_static(Scene scene, bool pixel_cells = true) {
  scene.method = mpm::SolverMethod::quasi_static;
  scene.pixel_cells = pixel_cells;
  scene.points_per_cell = pixel_cells ? 1 : 2;
  scene.plane = mpm::Plane::stress;
  return scene;
}

/// On two rollers, the left one of which holds it along x; a knife edge at each place presses from above.
Scene beam(int rows, int cols, std::initializer_list<double> knives) {
  Scene scene = quasi_static(samples::unbreakable(samples::mortar_block(rows, cols, 1e-3)));
  const double inset = 1e-2;
  scene.fixture.supports = {{{Side::bottom, inset, inset}, true, true},
                            {{Side::bottom, scene.width() - inset, scene.width() - inset}, false, true}};
  for (const double x : knives)
    scene.fixture.loads.push_back(
        {.at = {Side::top, x, x}, .way = Way::down, .leads = scene.fixture.loads.empty()});
  scene.loading.stop_strain = 1e-2;
  return scene;
}

double last(const Result& result, std::size_t gauge) { return result.gauges[gauge].values.back(); }

/// Force of a knife per metre of thickness [N/m].
double force(const Scene& scene, const Result& result) {
  return result.history.back().stress * scene.width();
}

TEST(Fixture, ABeamUnderTwoKnivesBendsToAnArc) {
  Scene scene = beam(10, 200, {0.06, 0.14});
  scene.fixture.gauges = {{"sag", 0.08, 0.005, 0.1, 0.005, Gauge::Direction::y}};
  const Result result = mpm::simulate(scene);
  const mpm::Phase& mortar = *scene.phases[samples::mortar];
  const double moment = force(scene, result) * 0.05;
  const double stiffness = mortar.young * std::pow(scene.height(), 3) / 12;
  EXPECT_NEAR(last(result, 0), -moment * 0.02 * 0.02 / 2 / stiffness, 1e-3 * std::abs(last(result, 0)));
  EXPECT_GT(force(scene, result), 0);
}

TEST(Fixture, ABeamUnderOneKnifeSagsByMomentAndShear) {
  Scene scene = beam(10, 220, {0.11});
  // From the axis over the support to the axis under the load.
  scene.fixture.gauges = {{"sag", 0.01, 0.005, 0.11, 0.005, Gauge::Direction::y}};
  const Result result = mpm::simulate(scene);
  const mpm::Phase& mortar = *scene.phases[samples::mortar];
  const double h = scene.height(), length = 0.2, young = mortar.young, poisson = mortar.poisson;
  const double bending = std::pow(length / h, 3) / (4 * young);
  const double shear = length / h * 1.2 * 2 * (1 + poisson) / (4 * young);
  const double expected = force(scene, result) * (bending + shear);
  EXPECT_NEAR(-last(result, 0), expected, 1e-3 * expected);
}

TEST(Fixture, ACantileverHoldsWhatPullsAtItsEnd) {
  Scene scene = quasi_static(samples::unbreakable(samples::mortar_block(10, 120, 1e-3)));
  scene.fixture.supports = {{{Side::left}, true, true}};
  scene.fixture.loads = {{.at = {Side::right}, .way = Way::down, .leads = true}};
  scene.fixture.gauges = {{"arc", 0.04, 0.005, 0.05, 0.005, Gauge::Direction::y},
                          {"next", 0.05, 0.005, 0.06, 0.005, Gauge::Direction::y}};
  const Result result = mpm::simulate(scene);
  // The difference of the slopes is the curvature at 0.05 m times 0.01 m.
  const double turn = (last(result, 1) - last(result, 0)) / 0.01;
  const double stiffness = scene.phases[samples::mortar]->young * std::pow(scene.height(), 3) / 12;
  const double moment = force(scene, result) * (0.12 - 0.05);
  EXPECT_NEAR(-turn, moment * 0.01 / stiffness, 2e-3 * std::abs(turn));
}

TEST(Fixture, LoadsAlongWholeEdgesArePlatens) {
  Scene platens = quasi_static(samples::small_concrete(40, 40));
  platens.loading.stop_strain = 4e-4;
  Scene scene = platens;
  scene.fixture.supports = {{{Side::bottom}, false, true}, {{Side::bottom, 0.01, 0.01}, true, false}};
  scene.fixture.loads = {{.at = {Side::top}, .way = Way::up, .leads = true}};
  const Result wanted = mpm::simulate(platens), result = mpm::simulate(scene);
  EXPECT_NEAR(result.peak_stress, wanted.peak_stress, 1e-3 * wanted.peak_stress);
  EXPECT_NEAR(result.peak_strain, wanted.peak_strain, 1e-3 * wanted.peak_strain);
  EXPECT_LT(result.energy_error, 1e-9);
}

/// A bar with a notch from each side, pulled; its crack gives back more than the bar takes.
Scene notched_bar() {
  Scene scene = quasi_static(samples::mortar_block(60, 20, 1e-3));
  scene.plane = mpm::Plane::stress;
  for (int col = 0; col < 5; ++col) scene.labels(30, col) = scene.labels(30, 19 - col) = 0;
  mpm::Phase& mortar = *scene.phases[samples::mortar];
  mortar.tensile_scale = 3e6;
  mortar.weibull_modulus = 30;
  mortar.fracture_energy = 5;
  scene.fixture.supports = {{{Side::bottom}, true, true}};
  scene.fixture.loads = {{.at = {Side::top}, .way = Way::up, .leads = true}};
  scene.fixture.gauges = {{"left", 0.0, 0.028, 0.0, 0.031, Gauge::Direction::y, 1e-5, true},
                          {"right", 0.02, 0.028, 0.02, 0.031, Gauge::Direction::y}};
  scene.loading.stop_strain = 1e-2;
  return scene;
}

TEST(Fixture, AGaugeThatControlsNeverFallsAndTheLoadSnapsBack) {
  const Scene scene = notched_bar();
  const Result result = mpm::simulate(scene);
  const auto& reading = result.gauges[0].values;
  ASSERT_EQ(reading.size(), result.history.size());
  double least_step = 1, farthest = 0, back = 0;
  for (std::size_t i = 1; i < reading.size(); ++i) {
    least_step = std::min(least_step, reading[i] - reading[i - 1]);
    farthest = std::max(farthest, result.history[i].strain);
    back = std::max(back, farthest - result.history[i].strain);
  }
  EXPECT_GT(least_step, -1e-9);
  EXPECT_GT(back, 0.1 * farthest) << "nothing snapped back";
  EXPECT_NEAR(reading.back(), 1e-5, 1e-9);
  EXPECT_LT(result.energy_error, 1e-9);
  EXPECT_EQ(result.stop, mpm::StopReason::strain);
}

TEST(Fixture, ARunThatAGaugeControlsGoesOnAsIfItHadNeverStopped) {
  const Scene scene = notched_bar();
  const Result whole = mpm::simulate(scene);
  const Result resumed = mpm::resume(scene, samples::stopped_after(scene, 30).kept);
  ASSERT_EQ(resumed.history.size(), whole.history.size());
  for (std::size_t i = 0; i < whole.history.size(); ++i)
    EXPECT_EQ(resumed.history[i].stress, whole.history[i].stress) << i;
  EXPECT_EQ(resumed.gauges[0].values, whole.gauges[0].values);
  Scene other = scene;
  other.fixture.gauges[0].x1 = 1e-3;
  EXPECT_THROW((void)mpm::resume(other, samples::stopped_after(scene, 5).kept), mpm::Error);
}

TEST(Fixture, WhatItCannotDoIsRefusedWithTheCure) {
  const auto refusal = [](const Scene& scene) -> std::string {
    try {
      mpm::validate(scene);
    } catch (const mpm::Error& error) {
      return error.what();
    }
    return "";
  };
  Scene scene = beam(4, 40, {0.02});
  EXPECT_EQ(refusal(scene), "");
  scene.method = mpm::SolverMethod::explicit_;
  EXPECT_EQ(refusal(scene),
            "loads: with inertia; are for runs without inertia; choose solver.method = \"quasi_static\"");
  scene = beam(4, 40, {0.02, 0.03});
  scene.fixture.loads[1].leads = true;
  EXPECT_NE(refusal(scene).find("exactly one load leads"), std::string::npos) << refusal(scene);
  scene = beam(4, 40, {0.02});
  scene.fixture.gauges = {{"a b", 0, 0, 0.01, 0}};
  EXPECT_NE(refusal(scene).find("gauges[1].name: a b; must be letters"), std::string::npos) << refusal(scene);
  scene.fixture.gauges = {{"a", 0, 0, 0.01, 0, Gauge::Direction::x, 1e-5, true}};
  scene.loading.path = mpm::LoadingPath::snap_back;
  EXPECT_NE(refusal(scene).find("loading.path: snap_back"), std::string::npos) << refusal(scene);
  scene.fixture.loads.clear();
  scene.fixture.gauges.clear();
  EXPECT_NE(refusal(scene).find("supports: without loads"), std::string::npos) << refusal(scene);
}

TEST(Fixture, WithoutControlTheSameBarBreaksAtOnce) {
  Scene scene = notched_bar();
  scene.fixture.gauges[0].controls = false;
  const Result result = mpm::simulate(scene);
  double farthest = 0;
  for (const mpm::HistoryRow& row : result.history) {
    EXPECT_GE(row.strain, farthest);
    farthest = row.strain;
  }
}

}  // namespace fixture_test
