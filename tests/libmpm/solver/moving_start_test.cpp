#include "libmpm/solver/moving_start.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/libmpm/sample_scenes.hpp"

namespace moving_start_test {

/// Two rows of three pixels of 2 mm: a void at the lower right, an aggregate at the upper left.
mpm::Scene small_picture() {
  mpm::Scene scene = samples::mortar_block(2, 3, 2e-3);
  scene.points_per_cell = 1;
  scene.labels(0, 0) = samples::aggregate;
  scene.labels(1, 2) = 0;
  scene.kinematics = mpm::Kinematics::moving;
  return scene;
}

mpm::MovingStart start_of(const mpm::Scene& scene) { return mpm::start_of(scene, mpm::plan(scene)); }

TEST(MovingStart, PutsAPointIntoTheMiddleOfEverySolidPixel) {
  const mpm::Scene scene = small_picture();
  const mpm::MovingStart start = start_of(scene);
  ASSERT_EQ(start.points.size(), 5U);
  for (const mpm::StartPoint& point : start.points) {
    const auto row = static_cast<int>(point.id / 3);
    const auto col = static_cast<int>(point.id % 3);
    EXPECT_NE(scene.labels(row, col), 0);
    EXPECT_DOUBLE_EQ(point.x, (col + 0.5) * 2e-3);
    EXPECT_DOUBLE_EQ(point.y, (1.5 - row) * 2e-3) << "row 0 is the top";
    EXPECT_DOUBLE_EQ(point.volume, 4e-6);
    EXPECT_DOUBLE_EQ(point.mass, 4e-6 * scene.phases[scene.labels(row, col)]->density);
    EXPECT_EQ(point.vx, 0);
    EXPECT_EQ(point.vy, 0);
    EXPECT_EQ(point.kept, 1);
    EXPECT_FALSE(point.ghost);
    EXPECT_EQ(point.cracked, 0);
  }
}

TEST(MovingStart, ExtraPointsShareTheirPixel) {
  mpm::Scene scene = small_picture();
  scene.extra_points = {{2.5e-3, 0.5e-3, samples::itz}, {3.5e-3, 1.5e-3, 0}, {3e-3, 1.9e-3, samples::itz}};
  const mpm::MovingStart start = start_of(scene);
  ASSERT_EQ(start.points.size(), 7U) << "void is no point, but has its share";
  for (const mpm::StartPoint& point : start.points) {
    if (point.x < 2e-3 || point.x > 4e-3 || point.y > 2e-3) continue;
    EXPECT_DOUBLE_EQ(point.volume, 4e-6 / 4);
  }
  const mpm::StartPoint& last = start.points.back();
  EXPECT_EQ(last.id, 6U + 2U);
  EXPECT_DOUBLE_EQ(last.x, 3e-3);
  EXPECT_DOUBLE_EQ(last.y, 1.9e-3);
  EXPECT_DOUBLE_EQ(last.mass, last.volume * scene.phases[samples::itz]->density);
}

TEST(MovingStart, GivesTheVelocityOfAFlight) {
  mpm::Scene scene = small_picture();
  scene.loading.direction = mpm::Direction::none;
  scene.loading.duration = 1e-3;
  scene.loading.initial_velocity_x = 3;
  scene.loading.initial_velocity_y = -4;
  for (const mpm::StartPoint& point : start_of(scene).points) {
    EXPECT_EQ(point.vx, 3);
    EXPECT_EQ(point.vy, -4);
  }
}

TEST(MovingStart, KeepsMapsOnlyOfWhatCanHappen) {
  mpm::Scene scene = small_picture();
  scene.extra_points = {{1e-3, 1e-3, samples::itz}};
  mpm::MovingStart start = start_of(scene);
  EXPECT_EQ(start.maps.failure_strain.size(), 6);
  EXPECT_TRUE(start.maps.failure_strain.isNaN().all());
  EXPECT_EQ(start.maps.crush_strain.size(), 0);
  EXPECT_TRUE(std::isnan(start.maps.extra_failure_strain.at(0)));
  scene.damage.crack_closure = mpm::CrackClosure::unilateral;
  EXPECT_EQ(start_of(scene).maps.crush_strain.size(), 6);
  EXPECT_EQ(start_of(samples::unbreakable(scene)).maps.failure_strain.size(), 0);
}

TEST(PointOrigin, FindsPixelsAndExtraPoints) {
  mpm::Scene scene = small_picture();
  scene.extra_points = {{1e-3, 1e-3, samples::mortar}, {1e-3, 1e-3, samples::itz}};
  const mpm::PointOrigin pixel = mpm::origin_of(scene, 0 * 3 + 0);
  EXPECT_EQ(pixel.label, samples::aggregate);
  EXPECT_EQ(pixel.phase, &*scene.phases[samples::aggregate]);
  EXPECT_EQ(mpm::origin_of(scene, 4).row, 1);
  EXPECT_EQ(mpm::origin_of(scene, 4).col, 1);
  const mpm::PointOrigin extra = mpm::origin_of(scene, 7);
  EXPECT_EQ(extra.row, -1);
  EXPECT_EQ(extra.extra, 1U);
  EXPECT_EQ(extra.label, samples::itz);

  const mpm::StrengthFactors factors(scene, false);
  EXPECT_EQ(mpm::factor_of(factors, mpm::origin_of(scene, 2)), factors.of_pixel(0, 2));
  EXPECT_EQ(mpm::factor_of(factors, extra), factors.of_extra_point(1));
}

}  // namespace moving_start_test
