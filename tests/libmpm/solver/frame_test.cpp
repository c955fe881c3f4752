#include "libmpm/solver/frame.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "libmpm/material/failure.hpp"
#include "libmpm/run/simulate.hpp"
#include "tests/libmpm/moving_scenes.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace frame_test {

using mpm::Frame;
using mpm::FramePoint;
using mpm::Kinematics;
using mpm::Result;
using mpm::Scene;

struct Seen {
  std::vector<Frame> frames;
  Result result;
};

Seen look_at(const Scene& scene, const mpm::Observer& observer = {}) {
  Seen seen;
  seen.result = mpm::simulate(
      scene, {.observer = observer, .frames = [&](const Frame& frame) { seen.frames.push_back(frame); }});
  return seen;
}

const mpm::HistoryRow& row_of(const Seen& seen, const Frame& frame) {
  return seen.result.history.at(static_cast<std::size_t>(frame.row));
}

/// Concrete that cracks, with extra points, one of them in a void phase.
Scene cracking(Kinematics kinematics) {
  Scene scene = samples::pulled(samples::small_concrete(40, 40));
  scene.labels(0, 0) = 0;
  scene.extra_points = {
      {10.1e-3, 15.2e-3, samples::itz}, {3.1e-3, 4.2e-3, 0}, {15.3e-3, 5.1e-3, samples::itz}};
  scene.kinematics = kinematics;
  scene.handover.strain = 1.5e-4;
  scene.motion.margin = 2e-3;
  scene.frames = 6;
  return scene;
}

/// Slow, damped and elastic: at its end as good as static.
Scene stretched_block(Kinematics kinematics) {
  Scene scene = samples::unbreakable(samples::mortar_block(20, 20));
  scene.loading.velocity = 0.02;
  scene.loading.stop_strain = 2e-4;
  scene.local_damping = 0.5;
  scene.kinematics = kinematics;
  scene.motion.margin = 2e-3;
  scene.frames = 4;
  return scene;
}

Scene thrown_body() {
  Scene scene = samples::soft_body(8, 8, 0.05);
  scene.loading.initial_velocity_x = 2;
  scene.loading.initial_velocity_y = -3;
  scene.loading.duration = 2e-2;
  scene.frames = 5;
  return scene;
}

constexpr Kinematics all_kinematics[] = {Kinematics::small_strain, Kinematics::moving, Kinematics::automatic};

bool same_run(const Result& a, const Result& b) {
  return a.history.size() == b.history.size() &&
         std::memcmp(a.history.data(), b.history.data(), a.history.size() * sizeof(mpm::HistoryRow)) == 0 &&
         (a.failure_mode == b.failure_mode).all() && a.extra_failure_mode == b.extra_failure_mode &&
         a.steps == b.steps;
}

TEST(Frame, IsMadeOnlyWhereSceneAndCallerAskForIt) {
  Scene scene = stretched_block(Kinematics::small_strain);
  EXPECT_FALSE(mpm::simulate(scene).history.empty());
  scene.frames = 0;
  EXPECT_TRUE(look_at(scene).frames.empty());
}

TEST(Frame, ChangesNothingInTheRun) {
  for (const Kinematics kinematics : all_kinematics) {
    const Scene scene = cracking(kinematics);
    const Seen seen = look_at(scene);
    EXPECT_GT(seen.result.tension_failures, 0);
    EXPECT_TRUE(same_run(seen.result, mpm::simulate(scene))) << static_cast<int>(kinematics);
  }
}

TEST(Frame, HasTheSameBitsForAnyNumberOfThreads) {
  for (const Kinematics kinematics : all_kinematics) {
    Scene scene = cracking(kinematics);
    scene.threads = 1;
    const std::vector<Frame> one = look_at(scene).frames;
    scene.threads = 3;
    EXPECT_TRUE(one == look_at(scene).frames) << static_cast<int>(kinematics);
  }
}

TEST(Frame, ComesAtTheStartAndEvenlySpacedOverTheStrain) {
  for (const Kinematics kinematics : all_kinematics) {
    const Scene scene = cracking(kinematics);
    const Seen seen = look_at(scene);
    ASSERT_EQ(seen.frames.size(), 7U);
    for (std::size_t i = 0; i < seen.frames.size(); ++i) {
      const Frame& frame = seen.frames[i];
      const double row_spacing = scene.loading.stop_strain / scene.history_rows;
      EXPECT_NEAR(frame.strain, static_cast<double>(i) / 6 * scene.loading.stop_strain, 2 * row_spacing);
      // With moving points the row tells the beginning of the step that the frame is at the end of.
      const bool moving = i > 0 && row_of(seen, frame).moving_points > 0;
      const double later = moving ? seen.result.dt : 0;
      EXPECT_NEAR(frame.time, row_of(seen, frame).time + later, 0.02 * seen.result.dt);
      EXPECT_NEAR(frame.strain, row_of(seen, frame).strain, moving ? 1e-6 : 1e-15);
    }
    EXPECT_EQ(seen.frames.back().row, static_cast<std::int64_t>(seen.result.history.size()) - 1);
  }
}

TEST(Frame, HasEverySolidPointByItsId) {
  for (const Kinematics kinematics : all_kinematics) {
    const Scene scene = cracking(kinematics);
    for (const Frame& frame : look_at(scene).frames) {
      ASSERT_EQ(frame.points.size(), 1601U);
      EXPECT_EQ(frame.points.front().id, 1U) << "pixel (0, 0) is void";
      EXPECT_EQ(frame.points[1599].id, 1600U);
      EXPECT_EQ(frame.points[1600].id, 1602U) << "extra point 1 is void";
      for (const FramePoint& p : frame.points) {
        const auto place = samples::rest_place(scene, p.id);
        EXPECT_NEAR(p.x - p.ux, place.x, 1e-12);
        EXPECT_NEAR(p.y - p.uy, place.y, 1e-12);
        EXPECT_EQ(p.phase, p.id < 1600 ? scene.labels.data()[p.id] : samples::itz);
      }
    }
  }
}

TEST(Frame, OfAFreeFlightIsTheStartMovedOn) {
  const Seen seen = look_at(thrown_body());
  ASSERT_EQ(seen.frames.size(), 6U);
  for (const Frame& frame : seen.frames)
    for (const FramePoint& p : frame.points) {
      EXPECT_NEAR(p.ux, 2 * frame.time, 1e-9);
      EXPECT_NEAR(p.uy, -3 * frame.time, 1e-9);
      EXPECT_NEAR(p.vx, 2, 1e-7);
      EXPECT_NEAR(p.vy, -3, 1e-7);
      EXPECT_NEAR(p.syy, 0, 1);
      EXPECT_EQ(p.damage, 0);
    }
  EXPECT_NEAR(seen.frames.back().time, 2e-2, 2 * seen.result.dt);
}

TEST(Frame, OfAStretchedBlockHasTheStressOfThePlatensAndTheirStrain) {
  for (const mpm::Plane plane : {mpm::Plane::strain, mpm::Plane::stress})
    for (const Kinematics kinematics : {Kinematics::small_strain, Kinematics::moving}) {
      Scene scene = stretched_block(kinematics);
      scene.plane = plane;
      const Seen seen = look_at(scene);
      const Frame& last = seen.frames.back();
      const double stress = row_of(seen, last).stress;
      ASSERT_GT(stress, 3.9e6);
      for (const FramePoint& p : last.points) {
        EXPECT_NEAR(p.syy, stress, 0.01 * stress);
        EXPECT_NEAR(p.sxx, 0, 0.01 * stress);
        EXPECT_NEAR(p.sxy, 0, 0.01 * stress);
        EXPECT_NEAR(p.szz, plane == mpm::Plane::strain ? 0.2 * (p.sxx + p.syy) : 0, 1e-9 * stress);
        EXPECT_NEAR(p.uy, last.strain * (p.y - p.uy), 0.01 * last.strain * scene.height());
        EXPECT_NEAR(p.vy, 0.02 * p.y / scene.height(), 0.15 * 0.02) << "waves are left";
      }
    }
}

/// Of the stresses that the points carry [J/m]; for points that are intact or carry nothing.
double elastic_energy(const Scene& scene, const Frame& frame) {
  mpm::PixelField<int> shares;
  shares.setOnes(scene.labels.rows(), scene.labels.cols());
  const auto pixel_of = [&](const FramePoint& p) -> int& {
    const auto place = samples::rest_place(scene, p.id);
    const auto rows = scene.labels.rows();
    return shares(rows - 1 - static_cast<Eigen::Index>(place.y / scene.pixel_size),
                  static_cast<Eigen::Index>(place.x / scene.pixel_size));
  };
  for (const auto& extra : scene.extra_points)  // those of void as well
    ++shares(scene.labels.rows() - 1 - static_cast<Eigen::Index>(extra.y / scene.pixel_size),
             static_cast<Eigen::Index>(extra.x / scene.pixel_size));
  double energy = 0;
  for (const FramePoint& p : frame.points) {
    const mpm::Stress<double> s{p.sxx, p.syy, p.sxy};
    const double area = scene.pixel_size * scene.pixel_size / pixel_of(p);
    energy += 0.5 * area * mpm::stress_power(*scene.phases[p.phase], scene.plane, s, s);
  }
  return energy;
}

// Stress, damage, the shares of extra points, and the time at which all of them are taken.
TEST(Frame, HoldsTheElasticEnergyAndTheFailuresOfItsRow) {
  for (const Kinematics kinematics : all_kinematics) {
    const Scene scene = cracking(kinematics);
    const Seen seen = look_at(scene);
    ASSERT_GT(seen.result.tension_failures, 100);
    for (const Frame& frame : seen.frames) {
      const mpm::HistoryRow& row = row_of(seen, frame);
      // Volumes of moving points change with the strain.
      EXPECT_NEAR(elastic_energy(scene, frame), row.elastic,
                  (row.moving_points > 0 ? 1e-3 : 1e-9) * row.elastic);
      const auto failed = std::count_if(frame.points.begin(), frame.points.end(),
                                        [](const FramePoint& p) { return p.damage == 1; });
      const auto intact = std::count_if(frame.points.begin(), frame.points.end(),
                                        [](const FramePoint& p) { return p.damage == 0; });
      EXPECT_EQ(failed, row.tension_failures + row.shear_failures);
      EXPECT_EQ(intact + failed, static_cast<std::int64_t>(frame.points.size()));
    }
  }
}

TEST(Frame, CallsFailedWhatKeepsAResidualStiffnessOrClosesItsCracks) {
  for (const Kinematics kinematics : {Kinematics::small_strain, Kinematics::moving})
    for (const bool closes : {false, true}) {
      Scene scene = cracking(kinematics);
      if (closes)
        scene.damage.crack_closure = mpm::CrackClosure::unilateral;
      else
        scene.damage.residual_stiffness = 0.1;
      const Seen seen = look_at(scene);
      const Frame& last = seen.frames.back();
      EXPECT_EQ(std::count_if(last.points.begin(), last.points.end(),
                              [](const FramePoint& p) { return p.damage > 1 - 1e-12; }),
                seen.result.tension_failures + seen.result.shear_failures);
      for (const FramePoint& p : last.points)
        EXPECT_FALSE(closes && p.damage == 1 && p.sxx + p.syy > 1e-3) << "a crack carries no tension";
    }
}

TEST(Frame, ShowsHowFarACrackHasSoftened) {
  for (const Kinematics kinematics : {Kinematics::small_strain, Kinematics::moving}) {
    Scene scene = cracking(kinematics);
    for (auto& phase : scene.phases)
      if (phase && phase->can_crack()) {
        phase->weibull_modulus = 10;
        phase->fracture_energy = 100;
      }
    scene.loading.stop_strain = 1e-3;
    const Seen seen = look_at(scene);
    const auto& points = seen.frames.back().points;
    EXPECT_TRUE(std::all_of(points.begin(), points.end(),
                            [](const FramePoint& p) { return p.damage >= 0 && p.damage <= 1; }));
    EXPECT_GT(std::count_if(points.begin(), points.end(),
                            [](const FramePoint& p) { return p.damage > 0.01 && p.damage < 0.99; }),
              20);
  }
}

TEST(Frame, GoesOnWhereSmallStrainHandsOver) {
  const Seen seen = look_at(cracking(Kinematics::automatic));
  EXPECT_EQ(row_of(seen, seen.frames[1]).moving_points, 0);
  EXPECT_GT(row_of(seen, seen.frames.back()).moving_points, 0);
  for (std::size_t i = 1; i < seen.frames.size(); ++i) {
    EXPECT_GT(seen.frames[i].time, seen.frames[i - 1].time);
    EXPECT_GT(seen.frames[i].step, seen.frames[i - 1].step);
  }
}

TEST(Frame, LacksThePointsThatLeft) {
  Scene scene = thrown_body();
  scene.motion.left = scene.motion.right = scene.motion.bottom = scene.motion.top = mpm::Edge::open;
  scene.motion.margin = 0.05;
  scene.loading.duration = 0.12;
  const Seen seen = look_at(scene);
  ASSERT_GT(seen.result.history.back().left_points, 10);
  for (const Frame& frame : seen.frames)
    EXPECT_EQ(static_cast<std::int64_t>(frame.points.size()),
              seen.result.points - row_of(seen, frame).left_points);
}

TEST(Frame, IsTheLastRowOfARunThatEndsEarly) {
  int rows = 0;
  const Seen seen =
      look_at(cracking(Kinematics::small_strain), [&](const mpm::Progress&) { return ++rows < 70; });
  EXPECT_EQ(seen.result.stop, mpm::StopReason::interrupted);
  ASSERT_EQ(seen.frames.size(), 3U);
  EXPECT_EQ(seen.frames.back().row, 70);
}

TEST(Frame, IsNeverOneOfARunGoneWrong) {
  Scene scene = samples::unbreakable(samples::mortar_block(40, 40));
  scene.labels.setConstant(0);
  for (int i = 0; i < 40; ++i) scene.labels(i, i) = samples::mortar;
  scene.cfl = 1;
  scene.loading.velocity = 1;
  scene.loading.stop_strain = 0.5;
  scene.history_rows = 1000000;
  scene.frames = 1;
  std::vector<Frame> frames;
  try {
    (void)mpm::simulate(scene, {.frames = [&](const Frame& frame) { frames.push_back(frame); }});
    FAIL() << "a diverging run must not end as if it were good";
  } catch (const mpm::Diverged& diverged) {
    EXPECT_GT(diverged.result.history.size(), 2U);
    ASSERT_EQ(frames.size(), 1U) << "the start, and no end";
    EXPECT_EQ(frames.front().time, 0);
  }
}

TEST(Frame, EndsARunWhoseSinkThrows) {
  EXPECT_THROW((void)mpm::simulate(stretched_block(Kinematics::small_strain),
                                   {.frames = [](const Frame&) { throw std::runtime_error("disk"); }}),
               std::runtime_error);
}

}  // namespace frame_test
