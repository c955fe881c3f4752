#include "libmpm/solver/moving/moving_solver.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <utility>

#include "libmpm/run/simulate.hpp"
#include "libmpm/solver/moving_start.hpp"
#include "libmpm/solver/plan.hpp"
#include "tests/libmpm/moving_scenes.hpp"

namespace moving_solver_test {

using mpm::Scene;
using samples::Method;
using samples::Moving;

/// A disc that turns and flies askew through the cells.
Scene thrown_disc() {
  Scene scene = samples::soft_body(24, 24, 0.05, 0.2);
  samples::keep_disc(scene, 11, 12, 9);
  scene.motion.margin = 0.6;
  return scene;
}
template <class Real>
void throw_it(Moving<Real>& it) {
  it.solver.kick([](const mpm::PointView& p, double& vx, double& vy) {
    vx = 7 - 20 * (p.y - 0.6) + 3 * (p.x - 0.55);
    vy = 4 + 20 * (p.x - 0.55);
  });
}

template <class Real>
std::vector<mpm::PointView> after(Scene scene, int threads, int steps) {
  scene.threads = threads;
  Moving<Real> it(std::move(scene));
  throw_it(it);
  EXPECT_EQ(it.solver.advance(steps).trouble, "");
  return it.solver.points();
}

bool same_bits(const std::vector<mpm::PointView>& a, const std::vector<mpm::PointView>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto& p = a[i];
    const auto& q = b[i];
    const double values_p[] = {p.x, p.y, p.vx, p.vy, p.mass, p.volume, p.stress.xx, p.stress.yy, p.stress.xy};
    const double values_q[] = {q.x, q.y, q.vx, q.vy, q.mass, q.volume, q.stress.xx, q.stress.yy, q.stress.xy};
    if (p.id != q.id || std::memcmp(values_p, values_q, sizeof values_p) != 0 ||
        std::memcmp(p.gradient, q.gradient, sizeof p.gradient) != 0)
      return false;
  }
  return true;
}

// The order of every sum is fixed by the tiles, so that the number of bands cannot show, while points cross
// cells in both directions.
template <class Real>
void expect_same_bits_for_any_threads() {
  for (const Method& method : samples::all_methods()) {
    Scene scene = thrown_disc();
    method.give_to(scene);
    SCOPED_TRACE(method.name());
    const auto one = after<Real>(scene, 1, 60);
    ASSERT_FALSE(one.empty());
    for (const int threads : {2, 3, 5})
      EXPECT_TRUE(same_bits(one, after<Real>(scene, threads, 60))) << threads;
  }
}
TEST(Threads, GiveTheSameBitsInDouble) { expect_same_bits_for_any_threads<double>(); }
TEST(Threads, GiveTheSameBitsInSingle) { expect_same_bits_for_any_threads<float>(); }

TEST(Threads, PointsCrossCellsInThoseTests) {
  Moving<double> it(thrown_disc());
  throw_it(it);
  std::vector<mpm::PointView> before = it.solver.points();
  (void)it.solver.advance(60);
  double furthest = 0;
  for (const auto& p : it.solver.points())
    for (const auto& q : before)
      if (p.id == q.id) furthest = std::max(furthest, std::hypot(p.x - q.x, p.y - q.y));
  EXPECT_GT(furthest, 1.5 * it.plan.cell_size);
}

// A few points alone drift over cells at every offset, so that nodes of any small mass come and go, while
// they swing against each other. The energy that they hold must not grow beyond what the swing makes of it.
TEST(LightNodes, DoNotExplode) {
  for (const Method& method : samples::all_methods()) {
    SCOPED_TRACE(method.name());
    Scene scene = samples::soft_body(16, 16, 0.05, 0.3);
    scene.labels.setConstant(0);
    scene.labels(3, 4) = scene.labels(9, 2) = scene.labels(9, 3) = scene.labels(10, 3) = samples::soft;
    scene.motion.margin = 0.4;
    method.give_to(scene);
    Moving<double> it(scene);
    it.solver.kick([&](const mpm::PointView& p, double& vx, double& vy) {
      vx = 4.1 + 3 * std::sin(50 * p.x + 20 * p.y);
      vy = 1.3 + 3 * std::cos(70 * p.y - 30 * p.x);
    });
    const double start = samples::sums_of(it.solver).kinetic;
    double most = 0;
    double furthest = 0;
    for (int i = 0; i < 300; ++i) {
      const mpm::Ledger ledger = it.solver.advance(1);
      ASSERT_EQ(ledger.trouble, "");
      most = std::max(most, ledger.kinetic + ledger.elastic);
    }
    for (const auto& p : it.solver.points()) furthest = std::max(furthest, p.x - it.rest_place(p.id).x);
    if (samples::figures)
      std::printf("%-22s %.4f moved %.3f\n", method.name().c_str(), most / start, furthest);
    EXPECT_LT(most, 1.2 * start);
    EXPECT_GT(furthest, 2 * it.plan.cell_size);
  }
}

TEST(MovingSolver, StartsAlikeFromThePictureAndFromAListOfItsPoints) {
  const Scene scene = thrown_disc();
  const mpm::Plan plan = mpm::plan(scene);
  mpm::MovingSolver<double> listed(scene, plan, mpm::start_of(scene, plan));
  mpm::MovingSolver<double> pictured(scene, plan, mpm::pictured_start(scene, plan));
  const mpm::Ledger one = listed.advance(20), other = pictured.advance(20);
  EXPECT_EQ(one.kinetic, other.kinetic);
  EXPECT_EQ(one.elastic, other.elastic);
  const auto points = listed.points(), same = pictured.points();
  ASSERT_EQ(points.size(), same.size());
  ASSERT_FALSE(points.empty());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points[i].id, same[i].id);
    EXPECT_EQ(points[i].x, same[i].x);
    EXPECT_EQ(points[i].stress.xx, same[i].stress.xx);
  }
}

/// As a run on its way to divergence hands them over: no index follows from such a place.
TEST(MovingSolver, TakesPointsFromAnywhere) {
  const Scene scene = thrown_disc();
  const mpm::Plan plan = mpm::plan(scene);
  mpm::MovingStart start = mpm::start_of(scene, plan);
  const std::size_t count = start.points.size();
  start.points[0].x = -1e300;
  start.points[1].y = 1e300;
  start.points[2].x = std::numeric_limits<double>::quiet_NaN();
  const mpm::MovingSolver<double> solver(scene, plan, std::move(start));
  EXPECT_EQ(solver.points().size(), count);
}

/// A block between platens.
Scene pressed_block(mpm::Direction direction, bool separation) {
  Scene scene = samples::soft_body(8, 8, 0.05);
  scene.loading.direction = direction;
  scene.loading.velocity = 0.5;
  scene.loading.ramp_time = 0.01;
  scene.loading.stop_strain = 0.02;
  scene.loading.duration = 0;
  scene.loading.separation = separation;
  scene.local_damping = 0.3;
  scene.motion.margin = 0.1;
  scene.history_rows = 40;
  return scene;
}

TEST(Platens, PullWithTheModulusOfTheBlock) {
  for (const auto shape : samples::all_shapes()) {
    Scene scene = pressed_block(mpm::Direction::tension, false);
    scene.motion.shape = shape;
    EXPECT_NEAR(mpm::simulate(scene).history.back().stress, 0.02 * 1e7, 0.05 * 0.02 * 1e7);
  }
}

TEST(Platens, WithSeparationCompressionCarriesAllTheSame) {
  for (const auto shape : samples::all_shapes()) {
    Scene scene = pressed_block(mpm::Direction::compression, false);
    scene.motion.shape = shape;
    const double held = mpm::simulate(scene).history.back().stress;
    EXPECT_NEAR(held, 0.02 * 1e7, 0.05 * 0.02 * 1e7);
    scene.loading.separation = true;
    EXPECT_NEAR(mpm::simulate(scene).history.back().stress, held, 0.02 * held);
  }
}

TEST(NotANumber, StopsInItsStepWithThePointAndItsPhase) {
  for (const auto shape : samples::all_shapes()) {
    Scene scene = samples::soft_body(8, 8, 0.05);
    scene.motion.shape = shape;
    Moving<double> it(scene);
    it.solver.kick([](const mpm::PointView& p, double& vx, double&) {
      if (p.id == 27) vx = std::nan("");
    });
    EXPECT_THAT(
        it.solver.advance(100).trouble,
        testing::AllOf(testing::HasSubstr("a position is not a number, that of the point of pixel (row "),
                       testing::HasSubstr("), soft; "), testing::HasSubstr("try a smaller solver.cfl")));
    EXPECT_EQ(it.solver.steps(), 1);
  }
}

// Points on the line of a platen have the whole weight of its nodes, and nothing but rounding beyond it.
TEST(Platens, KeepAPointThatStandsOnThem) {
  for (const auto shape : samples::all_shapes()) {
    for (const auto direction : {mpm::Direction::tension, mpm::Direction::compression}) {
      Scene scene = pressed_block(direction, false);
      scene.motion.shape = shape;
      for (int i = 0; i <= 4; ++i)
        for (const double y : {0.0, scene.height()})
          scene.extra_points.push_back({i * 0.1, y, samples::soft});
      EXPECT_NEAR(mpm::simulate(scene).history.back().stress, 0.02 * 1e7, 0.07 * 0.02 * 1e7);
    }
  }
}

// The rows of the grid follow the top platen, in 32 bits too, where the stretch of a step is lost beside 1.
TEST(Platens, PointsStretchWithThePlatenInBothPrecisions) {
  Scene scene = pressed_block(mpm::Direction::tension, false);
  const auto worst = [&](auto real) {
    Moving<decltype(real)> it(scene);
    (void)it.solver.advance(1000000);
    double error = 0;
    const double height = scene.height();
    for (const auto& p : it.solver.points()) {
      const double y = it.rest_place(p.id).y;
      error = std::max(error, std::abs(p.y - y * (1 + scene.loading.stop_strain)));
    }
    return error / (scene.loading.stop_strain * height);
  };
  const double in_double = worst(0.0);
  const double in_single = worst(0.0F);
  EXPECT_LT(in_double, 0.08) << "what the waves of a fast platen leave";
  EXPECT_NEAR(in_single, in_double, 1e-3);
}

TEST(TimeStep, ShrinksWithTheSpeedOfThePoints) {
  Scene scene = samples::soft_body(8, 8, 0.05);
  Moving<double> it(scene);
  (void)it.solver.advance(1);
  EXPECT_NEAR(it.solver.dt(), 0.5 * 0.1 / 100, 1e-15);
  it.solver.kick([](const mpm::PointView&, double& vx, double& vy) {
    vx = 15;
    vy = 20;
  });
  (void)it.solver.advance(1);
  EXPECT_NEAR(it.solver.dt(), 0.5 * 0.1 / 125, 1e-12);
  (void)it.solver.advance(1);
  EXPECT_NEAR(it.solver.dt(), 0.5 * 0.1 / 125, 1e-9) << "it is gathered from the points as well";
}

TEST(TimeStep, GrowsWhenTheStiffestPhaseHasFailed) {
  Scene scene = samples::soft_body(8, 8, 0.05);
  mpm::Phase stiff = *scene.phases[samples::soft];
  stiff.young = 16e7;
  stiff.tensile_scale = 1e3;
  scene.phases.emplace_back(stiff);
  scene.labels(3, 3) = scene.labels(4, 4) = 2;
  Moving<double> it(scene);
  (void)it.solver.advance(1);
  EXPECT_NEAR(it.solver.dt(), 0.5 * 0.1 / 400, 1e-15);
  it.solver.kick([](const mpm::PointView& p, double& vx, double& vy) {
    vx = 1 * (p.x - 0.2);
    vy = 1 * (p.y - 0.2);
  });
  double before = it.solver.dt();
  mpm::Ledger ledger;
  for (int i = 0; i < 60; ++i) {
    ledger = it.solver.advance(1);
    EXPECT_LE(it.solver.dt(), 1.0500001 * before);
    before = it.solver.dt();
  }
  EXPECT_EQ(ledger.tension_failures, 2);
  EXPECT_NEAR(it.solver.dt(), 0.5 * 0.1 / 100, 0.01 * 0.5 * 0.1 / 100);
}

}  // namespace moving_solver_test
