#include "specimen/describe/descriptors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "specimen/body/measure.hpp"
#include "specimen/body/raster.hpp"
#include "specimen/convert/convert.hpp"
#include "specimen/pack/packing.hpp"
#include "specimen/picture/picture.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace specimen {
namespace descriptors_test {

constexpr double mm = 1e-3;

// What a picture of known ellipses is measured to be, from its pixels alone.
Descriptors measured(const std::vector<Ellipse>& ellipses, double side) {
  const test::TemporaryFolder folder;
  const LabelledMask mask = draw_ellipses(ellipses, side, side, 0.25 * mm).mask;
  write_labels(folder / "ellipses.png", mask);
  ConvertOptions options;
  options.source_pixel_size = mask.pixel_size;
  return describe(
      make_specimen(convert_picture(folder / "ellipses.png", options).segmented, {ItzMode::none, 0, 36}, {}));
}

TEST(Descriptors, GiveKnownEllipsesBackFromAPicture) {
  PackingOptions options;
  options.width = options.height = 0.12;
  options.grading = named_grading("fuller", 6 * mm, 20 * mm);
  options.gap = 0.8 * mm;
  options.aspect_min = options.aspect_max = 0.6;
  const std::vector<Ellipse> ellipses = pack(options).ellipses;
  const Descriptors found = measured(ellipses, options.width);
  EXPECT_NEAR(found.fraction, 0.45, 0.003);
  EXPECT_EQ(found.void_fraction, 0);
  EXPECT_EQ(found.merged, 0);
  EXPECT_EQ(found.sample.cut, 0);
  ASSERT_EQ(found.sample.aggregates.size(), ellipses.size());
  EXPECT_NEAR(found.mean_aspect, 0.6, 0.005);
  double boundary = 0;
  for (std::size_t i = 0; i < ellipses.size(); ++i) {
    boundary += perimeter(ellipses[i]);
    EXPECT_NEAR(found.sample.aggregates[i].diameter, 2 * std::sqrt(ellipses[i].a * ellipses[i].b), 0.05 * mm);
  }
  EXPECT_NEAR(found.specific_perimeter, boundary / (0.12 * 0.12), 0.02 * boundary / (0.12 * 0.12));
  EXPECT_GE(found.gaps.front(), 0.5 * mm);
  EXPECT_GE(found.orientation.probability, 0.05);
  EXPECT_DOUBLE_EQ(found.s2.radial.front(), found.fraction);
}

TEST(Descriptors, FindTheDirectionOfAPicture) {
  std::vector<Ellipse> ellipses;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      ellipses.push_back({(15 + 30 * i) * mm, (15 + 30 * j) * mm, 10 * mm, 5 * mm, 0.5});
  const Descriptors found = measured(ellipses, 0.12);
  EXPECT_NEAR(found.orientation.direction, 0.5, 0.01);
  EXPECT_NEAR(found.orientation.strength, 1, 1e-3);
  EXPECT_LT(found.orientation.probability, 1e-5);
  EXPECT_NEAR(found.median_diameter, 2 * std::sqrt(50.0) * mm, 0.05 * mm);
  EXPECT_NE(found.s2.along_x, found.s2.along_y);
}

TEST(Descriptors, OfPlainMortarAreUnknownOrNought) {
  const Descriptors found = describe(make_specimen(draw_ellipses({}, 0.05, 0.05, mm), {}, {}));
  EXPECT_EQ(found.fraction, 0);
  EXPECT_TRUE(found.sample.aggregates.empty());
  EXPECT_TRUE(std::isnan(found.median_diameter));
  EXPECT_TRUE(std::isnan(found.mean_aspect));
  EXPECT_TRUE(std::isnan(found.mean_gap));
  EXPECT_EQ(found.orientation.probability, 1);
  EXPECT_EQ(found.s2.radial.back(), 0);
}

TEST(Descriptors, OfAggregateAloneAreOneCutPiece) {
  Segmented whole{{{40, 40, phase::aggregate}, mm, standard_phases()}, {40, 40, 1}, {}};
  whole.inclusions = draw_window({{20 * mm, 20 * mm, 40 * mm, 40 * mm, 0}}, 40 * mm, 40 * mm, mm).inclusions;
  const Descriptors found = describe(make_specimen(whole, {ItzMode::none, 0, 36}, {}));
  EXPECT_EQ(found.fraction, 1);
  EXPECT_EQ(found.sample.parts, 1);
  EXPECT_DOUBLE_EQ(found.s2.radial.back(), 1);
}

TEST(Descriptors, CountAggregatesThatWereTakenForOne) {
  Raster<std::uint8_t> labels(60, 100, phase::mortar);
  for (int row = 0; row < 60; ++row)
    for (int col = 0; col < 100; ++col)
      if (std::min(std::hypot(row - 30, col - 30), std::hypot(row - 30, col - 70)) < 20.5)
        labels(row, col) = phase::aggregate;
  const test::TemporaryFolder folder;
  write_labels(folder / "touching.png", {labels, mm, standard_phases()});
  ConvertOptions options;
  options.source_pixel_size = mm;
  const auto found = [&] {
    return describe(make_specimen(convert_picture(folder / "touching.png", options).segmented,
                                  {ItzMode::none, 0, 36}, {}));
  };
  EXPECT_EQ(found().merged, 1);
  options.split_touching = true;
  EXPECT_EQ(found().merged, 0);
  EXPECT_EQ(found().sample.aggregates.size(), 2u);
}

constexpr double pi = std::numbers::pi;

TEST(Orientation, OfParallelAxesIsTheirs) {
  for (const double angle : {0.0, 0.3, pi / 2, 3.0}) {
    const Orientation found = mean_orientation({{angle, 1}, {angle, 2}, {angle, 1}, {angle + pi, 1}});
    EXPECT_NEAR(found.direction, angle, 1e-12);
    EXPECT_NEAR(found.strength, 1, 1e-12);
    EXPECT_LT(found.probability, 0.05);
  }
}

TEST(Orientation, OfACrossIsNone) {
  std::vector<WeightedAxis> axes;
  for (int n = 0; n < 20; ++n) axes.push_back({0.4 + n % 2 * pi / 2, 1});
  const Orientation found = mean_orientation(axes);
  EXPECT_NEAR(found.strength, 0, 1e-12);
  EXPECT_NEAR(found.probability, 1, 1e-12);
}

TEST(Orientation, FollowsTheHeavierAxes) {
  const Orientation found = mean_orientation({{0, 3}, {pi / 2, 1}});
  EXPECT_NEAR(found.direction, 0, 1e-12);
  EXPECT_NEAR(found.strength, 0.5, 1e-12);
}

TEST(Orientation, OfNothingIsNone) {
  EXPECT_EQ(mean_orientation({}).strength, 0);
  EXPECT_EQ(mean_orientation({}).probability, 1);
  EXPECT_EQ(mean_orientation({{1, 0}}).probability, 1);
}

// One in twenty samples of random axes is found to have a direction at that level, by its definition.
TEST(Orientation, TakesRandomAxesForDirectedAsOftenAsItsLevelSays) {
  Random random(1);
  constexpr int trials = 4000;
  int directed = 0;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<WeightedAxis> axes;
    for (int n = 0; n < 25; ++n) axes.push_back({random.uniform(0, pi), 1});
    directed += mean_orientation(axes).probability < 0.05;
  }
  EXPECT_NEAR(directed / static_cast<double>(trials), 0.05, 0.012);  // 3.5 standard deviations
}

TEST(Orientation, FindsAWeakDirectionOfManyAxes) {
  Random random(2);
  std::vector<WeightedAxis> axes;
  for (int n = 0; n < 400; ++n)
    axes.push_back({n % 4 == 0 ? random.uniform(0.9, 1.1) : random.uniform(0, pi), 1});
  const Orientation found = mean_orientation(axes);
  EXPECT_LT(found.probability, 1e-4);
  EXPECT_NEAR(found.direction, 1, 0.15);
  EXPECT_NEAR(found.strength, 0.25, 0.07);
}

TEST(Orientation, CountsAxesByTheirEffectiveNumber) {
  const Orientation three = mean_orientation({{0.1, 1}, {0.3, 1}, {1.2, 1}});
  const Orientation heavy = mean_orientation({{0.1, 100}, {0.3, 100}, {1.2, 100}, {0.7, 0}});
  EXPECT_NEAR(heavy.strength, three.strength, 1e-12);
  EXPECT_NEAR(heavy.probability, three.probability, 1e-12);
}

TEST(Spacing, OfEllipsesIsTheirExactGapToAPartOfAPixel) {
  const PackingOptions options;
  const std::vector<Ellipse> ellipses = pack(options).ellipses;
  const Specimen specimen = make_specimen(draw_ellipses(ellipses, options.width, options.height, 0.5 * mm),
                                          {ItzMode::none, 0, 36}, {});
  const std::vector<double> gaps = nearest_gaps(specimen);
  ASSERT_EQ(gaps.size(), ellipses.size());
  for (std::size_t i = 0; i < ellipses.size(); ++i) {
    double least = 1;
    for (std::size_t j = 0; j < ellipses.size(); ++j)
      if (j != i) least = std::min(least, gap_between(ellipses[i], ellipses[j]));
    EXPECT_GE(gaps[i], least - 1e-12) << i;
    EXPECT_LE(gaps[i], least + 0.1 * mm) << i;
  }
}

TEST(Spacing, OfGrainsThatTouchIsNought) {
  Specimen specimen;
  specimen.mask = {{6, 8, phase::mortar}, 1, standard_phases()};
  Raster<std::int32_t> instances(6, 8, 0);
  for (int row = 1; row < 5; ++row)
    for (int col = 1; col < 7; ++col) instances(row, col) = col < 4 ? 1 : 2;
  specimen.inclusions = measure_inclusions(instances, 1);
  const std::vector<double> gaps = nearest_gaps(specimen);
  ASSERT_EQ(gaps.size(), 2u);
  EXPECT_NEAR(gaps[0], 0, 0.3);
  EXPECT_EQ(gaps[0], gaps[1]);
}

TEST(Spacing, NeedsTwo) {
  Specimen specimen = make_specimen(draw_ellipses({{5, 5, 2, 2, 0}}, 10, 10, 1), {ItzMode::none, 0, 36}, {});
  EXPECT_TRUE(nearest_gaps(specimen).empty());
}

Inclusion drawn(const std::vector<std::string>& rows) {
  Raster<std::int32_t> instances(static_cast<int>(rows.size()), static_cast<int>(rows.front().size()), 0);
  for (int row = 0; row < instances.rows; ++row)
    for (int col = 0; col < instances.cols; ++col)
      instances(row, col) = rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(col)] == '#';
  return measure_inclusions(instances, 1).front();
}

TEST(Solidity, TellsGrainsThatWereTakenForOne) {
  EXPECT_EQ(solidity(make_inclusion(1, {0, 0, 2, 1, 0})), 1);
  EXPECT_NEAR(solidity(drawn({"####", "####", "####", "####"})), 1, 0.07);
  EXPECT_NEAR(solidity(drawn({"########", "########", "##......", "##......", "##......", "##......"})),
              24.0 / 36, 0.06);  // the diagonal closes half of what lacks of 48 pixels
}

TEST(Solidity, OfTwoDiscsThatTouchIsBelowThatOfOne) {
  Raster<std::int32_t> one(60, 100, 0), two(60, 100, 0);
  for (int row = 0; row < 60; ++row)
    for (int col = 0; col < 100; ++col) {
      one(row, col) = std::hypot(row - 30, col - 30) < 20.5;
      two(row, col) = std::min(std::hypot(row - 30, col - 30), std::hypot(row - 30, col - 70)) < 20.5;
    }
  EXPECT_GT(solidity(measure_inclusions(one, 1).front()), 0.95);
  EXPECT_NEAR(solidity(measure_inclusions(two, 1).front()), 0.88, 0.02);
}

}  // namespace descriptors_test
}  // namespace specimen
