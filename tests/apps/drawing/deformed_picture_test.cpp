#include "apps/drawing/deformed_picture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "apps/drawing/picture_parts.hpp"
#include "tests/apps/fake_run.hpp"

namespace deformed_picture_test {

using namespace output;
using output::nearest_points;
using output::PointPlace;
using specimen::Raster;
using specimen::Rgb;

constexpr float nan_f = std::numeric_limits<float>::quiet_NaN();

/// A mask whose points have moved by (dx, dy) pixels, up is positive.
FakeRun moved(const std::vector<std::string>& rows, float dx, float dy) {
  FakeRun run = still_run(rows);
  const auto n_rows = run.scene.labels.rows();
  const auto n_cols = run.scene.labels.cols();
  run.result.end_x.setConstant(n_rows, n_cols, nan_f);
  run.result.end_y = run.result.end_x;
  for (Eigen::Index row = 0; row < n_rows; ++row)
    for (Eigen::Index col = 0; col < n_cols; ++col) {
      if (run.scene.labels(row, col) == 0) continue;
      run.result.end_x(row, col) = (static_cast<float>(col) + 0.5F + dx) * 1e-3F;
      run.result.end_y(row, col) = (static_cast<float>(n_rows - row) - 0.5F + dy) * 1e-3F;
    }
  return run;
}

Raster<Rgb> drawn(const FakeRun& run, int fineness = 1) {
  return deformed_picture(run.specimen.mask, run.result, grey_palette(), fineness);
}

const Rgb& empty() {
  static const Rgb colour = grey_palette().phases[0];
  return colour;
}

TEST(DeformedPicture, OfPointsThatStayedIsThatOfDamage) {
  FakeRun run = moved({"1203", "2310", "0221"}, 0, 0);
  run.result.failure_strain(0, 1) = 1e-4F;
  run.result.failure_mode(0, 1) = 1;
  EXPECT_TRUE(has_end(run.result));
  EXPECT_EQ(drawn(run), damage_picture(run.specimen.mask, run.result, 1, grey_palette()));
}

TEST(DeformedPicture, GrowsWithPointsThatMoveOutOfTheMask) {
  const FakeRun run = moved({"12", "32"}, 1, 1);
  const Raster<Rgb> picture = drawn(run);
  const Palette palette = grey_palette();
  ASSERT_EQ(picture.rows, 3);
  ASSERT_EQ(picture.cols, 3);
  EXPECT_EQ(picture(0, 1), palette.phases[1]);
  EXPECT_EQ(picture(0, 2), palette.phases[2]);
  EXPECT_EQ(picture(1, 1), palette.phases[3]);
  EXPECT_EQ(picture(0, 0), empty());
  EXPECT_EQ(picture(2, 1), empty());
}

TEST(DeformedPicture, LeavesOutWhatIsFurtherThanHalfTheMaskBeyondIt) {
  FakeRun run = moved({"2222", "2222", "2222", "2222"}, 0, 0);
  run.result.end_x(0, 0) = 1;   // a metre to the right
  run.result.end_y(3, 3) = -1;  // a metre below
  const Raster<Rgb> picture = drawn(run);
  EXPECT_EQ(picture.cols, 6);
  EXPECT_EQ(picture.rows, 6);
  EXPECT_EQ(picture(0, 0), empty());
  for (int row = 0; row < 6; ++row) EXPECT_EQ(picture(row, 5), empty());
}

TEST(DeformedPicture, HasNoGapsBetweenPointsThatPartByLessThanHalfAPixel) {
  const std::vector<std::string> rows(20, std::string(20, '2'));
  for (const double stretch : {1.0, 1.05, 1.13, 1.29, 1.4}) {
    FakeRun run = moved(rows, 0, 0);
    run.result.end_x *= static_cast<float>(stretch);
    for (const int fineness : {1, 2, 3}) {
      const Raster<Rgb> picture = drawn(run, fineness);
      const int within = static_cast<int>(19 * stretch) * fineness;
      for (int row = 0; row < 20 * fineness; ++row)
        for (int col = fineness; col < within; ++col)
          ASSERT_NE(picture(row, col), empty()) << stretch << " " << fineness << " " << row << " " << col;
    }
  }
}

TEST(DeformedPicture, ShowsACrackThatOpens) {
  FakeRun run = moved({"222222", "222222"}, 0, 0);
  for (Eigen::Index col = 3; col < 6; ++col)
    for (Eigen::Index row = 0; row < 2; ++row) run.result.end_x(row, col) += 2e-3F;
  const Raster<Rgb> picture = drawn(run);
  EXPECT_EQ(picture.cols, 8);
  for (int row = 0; row < 2; ++row)
    for (int col = 0; col < 8; ++col)
      EXPECT_EQ(picture(row, col) == empty(), col == 3 || col == 4) << row << " " << col;
}

TEST(DeformedPicture, IsFinerThanTheMaskWhereItIsAskedToBe) {
  const FakeRun run = moved({"12", "32"}, 0, 0);
  EXPECT_EQ(drawn(run, 4), magnified(drawn(run), 4));
}

TEST(DeformedPicture, KnowsRunsInWhichNothingCanFail) {
  FakeRun run = moved({"12", "32"}, 0, 0);
  run.result.failure_strain.resize(0, 0);
  run.result.failure_mode.resize(0, 0);
  EXPECT_EQ(drawn(run)(0, 0), grey_palette().phases[1]);
}

TEST(HasEnd, IsSoForMovingPointsOnly) { EXPECT_FALSE(has_end(still_run({"2"}).result)); }

// What a picture makes of these numbers is tested with the pictures of points that have moved.

/// Two rows of three pixels of 2 mm.
specimen::LabelledMask small_mask() {
  specimen::LabelledMask mask;
  mask.pixel_size = 2e-3;
  mask.labels = Raster<std::uint8_t>(2, 3);
  return mask;
}

Raster<std::int32_t> numbers(int rows, int cols, std::vector<std::int32_t> values) {
  Raster<std::int32_t> raster(rows, cols);
  raster.data = std::move(values);
  return raster;
}

TEST(NearestPoints, PutsTheFirstRowOnTop) {
  const std::vector<PointPlace> points{{1e-3, 3e-3}, {5e-3, 3e-3}, {3e-3, 1e-3}};
  EXPECT_EQ(nearest_points(small_mask(), points, 1), numbers(2, 3, {0, -1, 1, -1, 2, -1}));
}

TEST(NearestPoints, GivesAPixelToTheNearerOfTwo) {
  EXPECT_EQ(nearest_points(small_mask(), {{1.3e-3, 1e-3}, {1.1e-3, 1e-3}}, 1),
            numbers(2, 3, {-1, -1, -1, 1, -1, -1}));
}

TEST(NearestPoints, LeavesOutWhatIsNowhereOrFarAway) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(nearest_points(small_mask(), {{nan, 1e-3}, {1e-3, infinity}}, 1),
            numbers(2, 3, {-1, -1, -1, -1, -1, -1}));
  const Raster<std::int32_t> far =
      nearest_points(small_mask(), {{1e300, 1e-3}, {1e-3, -1e300}, {1e-3, 1e-3}}, 1);
  EXPECT_EQ(std::count(far.data.begin(), far.data.end(), 2), 1);
  EXPECT_EQ(std::count(far.data.begin(), far.data.end(), -1), static_cast<std::ptrdiff_t>(far.size()) - 1);
  EXPECT_LE(far.cols, 5);
  EXPECT_LE(far.rows, 3);
}

}  // namespace deformed_picture_test
