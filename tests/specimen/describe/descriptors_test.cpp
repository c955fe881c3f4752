#include "specimen/describe/descriptors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

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

}  // namespace descriptors_test
}  // namespace specimen
