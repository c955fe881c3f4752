#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "specimen/body/error.hpp"
#include "specimen/body/specimen.hpp"
#include "specimen/pack/packing.hpp"

namespace specimen {
namespace draw_test {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

constexpr double mm = 1e-3;

std::string refusal(const std::vector<Ellipse>& ellipses, double width = 0.1, double height = 0.1,
                    double pixel_size = 1 * mm) {
  try {
    (void)draw_ellipses(ellipses, width, height, pixel_size);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

void expect_pixel_centres(const std::vector<Ellipse>& ellipses, double width, double height, double d) {
  const Segmented drawn = draw_ellipses(ellipses, width, height, d);
  for (int row = 0; row < drawn.mask.labels.rows; ++row) {
    for (int col = 0; col < drawn.mask.labels.cols; ++col) {
      int id = 0;
      for (std::size_t i = 0; i < ellipses.size(); ++i) {
        if (contains(ellipses[i], drawn.mask.centre(row, col))) id = static_cast<int>(i) + 1;
      }
      ASSERT_EQ(drawn.instances(row, col), id) << row << " " << col;
      ASSERT_EQ(drawn.mask.labels(row, col), id > 0 ? phase::aggregate : phase::mortar) << row << " " << col;
    }
  }
}

TEST(Draw, FillsThePixelsWhoseCentreIsInside) {
  PackingOptions options;
  options.width = 0.06;
  options.height = 0.045;
  for (options.seed = 1; options.seed <= 4; ++options.seed)
    expect_pixel_centres(pack(options).ellipses, options.width, options.height, 0.5 * mm);
}

TEST(Draw, FillsNeedles) {
  const std::vector<Ellipse> needles{{0.03, 0.03, 0.025, 0.0008, 0.7},
                                     {0.05, 0.02, 0.019, 0.0006, 3.1},
                                     {0.02, 0.05, 0.019, 0.0006, 0},
                                     {0.01, 0.03, 0.019, 0.0007, std::numbers::pi / 2}};
  expect_pixel_centres(needles, 0.08, 0.06, 0.5 * mm);
}

// Centres right on the boundary: the inside test decides, not the rounding of the scanline.
TEST(Draw, AgreesOnCentresThatLieOnTheBoundary) {
  expect_pixel_centres({{0.5, 0.5, 0.25, 0.25, 0}}, 1, 1, 0.0625);
  expect_pixel_centres({{0.53125, 0.53125, 0.3125, 0.3125, 0}}, 1, 1, 0.0625);
  expect_pixel_centres({{0.5, 0.5, 0.5, 0.5, 0}}, 1, 1, 0.03125);  // touches all walls
}

TEST(Draw, ListsInclusionsInTheOrderOfTheEllipses) {
  const std::vector<Ellipse> ellipses{{0.02, 0.08, 0.015, 0.01, 0.3}, {0.07, 0.03, 0.02, 0.01, 1}};
  const Segmented drawn = draw_ellipses(ellipses, 0.1, 0.1, 1 * mm);
  ASSERT_EQ(drawn.inclusions.size(), 2u);
  EXPECT_EQ(drawn.inclusions[1].id, 2);
  EXPECT_EQ(drawn.inclusions[1].ellipse, ellipses[1]);
  EXPECT_EQ(drawn.instances(20, 20), 1);  // y = 80 mm is a fifth from the top
  EXPECT_EQ(drawn.instances(69, 70), 2);
  EXPECT_EQ(drawn.mask.pixel_size, 1 * mm);
  EXPECT_EQ(drawn.mask.phases, standard_phases());
}

TEST(Draw, AreaOfPixelsIsThatOfTheEllipses) {
  PackingOptions options;
  const Segmented drawn = draw_ellipses(pack(options).ellipses, options.width, options.height, 0.5 * mm);
  EXPECT_EQ(drawn.mask.labels.rows, 300);
  EXPECT_EQ(drawn.mask.labels.cols, 300);
  EXPECT_NEAR(static_cast<double>(count_labels(drawn.mask)[phase::aggregate]) / 90'000, 0.45, 0.002);
}

TEST(Draw, NothingIsPlainMortar) {
  const Segmented drawn = draw_ellipses({}, 0.1, 0.05, 1 * mm);
  EXPECT_EQ(count_labels(drawn.mask)[phase::mortar], 100 * 50);
  EXPECT_EQ(drawn.mask.labels.cols, 100);
  EXPECT_EQ(drawn.mask.labels.rows, 50);
}

TEST(Draw, OverlappingEllipsesAreNamed) {
  const Ellipse first{0.02, 0.02, 0.01, 0.01, 0}, other{0.07, 0.07, 0.01, 0.01, 0};
  EXPECT_EQ(
      refusal({first, other, {0.039, 0.02, 0.01, 0.01, 0}}),
      "ellipses: number 1 at (20, 20) mm and number 3 at (39, 20) mm; overlap by 1 mm; move them apart");
  EXPECT_EQ(refusal({first, {0.04, 0.02, 0.01, 0.01, 0}}), "");  // they touch
}

TEST(Draw, EllipseThatLeavesTheSpecimenIsNamed) {
  EXPECT_EQ(refusal({{0.05, 0.05, 0.01, 0.01, 0}, {0.092, 0.05, 0.01, 0.005, 0}}),
            "ellipses: number 2 at (92, 50) mm; leaves the specimen of 100 x 100 mm by 2 mm; move it inside");
  EXPECT_THAT(refusal({{0.05, 0.005, 0.01, 0.01, 0}}), testing::HasSubstr("by 5 mm"));
  EXPECT_EQ(refusal({{0.01, 0.01, 0.01, 0.01, 0}}), "");
}

TEST(Draw, ImpossibleEllipseIsNamed) {
  EXPECT_EQ(
      refusal({{0.05, 0.05, 0.01, 0.02, 0}}),
      "ellipses: number 1 at (50, 50) mm with semi-axes 10 mm and 20 mm; must be finite with a >= b > 0; "
      "the long semi-axis comes first");
  for (const double bad : std::vector<double>{not_a_number, infinite, 0}) {
    EXPECT_NE(refusal({{0.05, 0.05, bad, 0.02, 0}}), "");
    EXPECT_NE(refusal({{0.05, 0.05, 0.02, bad, 0}}), "");
  }
  EXPECT_NE(refusal({{0.05, not_a_number, 0.02, 0.01, 0}}), "");
  EXPECT_NE(refusal({{0.05, 0.05, 0.02, 0.01, not_a_number}}), "");
}

TEST(Draw, EllipseBetweenThePixelCentresIsNamed) {
  EXPECT_EQ(refusal({{0.05, 0.05, 0.0004, 0.0003, 0}}),
            "ellipses: number 1 at (50, 50) mm; holds no pixel centre: it is smaller than a pixel of 1 mm; "
            "lower the pixel size or omit such small aggregates");
}

TEST(Draw, SizeMustBeAWholeNumberOfPixels) {
  EXPECT_EQ(refusal({}, 0.1, 0.1, 0.3 * mm),
            "generate.width: 100 mm; must be a whole number of pixels of 0.3 mm; take 99.9 mm or 100.2 mm");
  EXPECT_EQ(refusal({}, 0.1, 0.1005),
            "generate.height: 100.5 mm; must be a whole number of pixels of 1 mm; take 100 mm or 101 mm");
  EXPECT_EQ(refusal({}, 0.1, 0.1, 0.2),
            "generate.width: 100 mm; must be a whole number of pixels of 200 mm; take 200 mm");
  EXPECT_EQ(refusal({}, 0.15, 0.15, 0.5e-3), "");
  EXPECT_EQ(refusal({}, 0.1, 0.1, 0.1 / 3), "");
  EXPECT_THAT(refusal({}, 0.1, 0.1, not_a_number), testing::HasSubstr("generate.pixel_size: nan"));
  EXPECT_THAT(refusal({}, -0.1), testing::HasSubstr("generate.width: -100 mm; must be > 0"));
  EXPECT_THAT(refusal({}, 0.1, 0.1, 1e-7), testing::HasSubstr("is 1e+06 pixels of 0.0001 mm"));
  EXPECT_THAT(refusal({}, 5, 5, 0.1 * mm), testing::HasSubstr("makes 50000 x 50000 pixels"));
}

TEST(DrawWindow, CutsAtTheBorderAndLeavesOutWhatIsNotSeen) {
  const std::vector<Ellipse> ellipses{{0, 0.05, 0.02, 0.01, 0},         // half of it
                                      {-0.5, 0.05, 0.02, 0.01, 0},      // far outside
                                      {0.05, 0.05, 0.0004, 0.0003, 0},  // between the centres
                                      {0.06, 0.07, 0.02, 0.01, 0.4},    // whole
                                      {0.1, 0.1, 0.01, 0.01, 0}};       // a quarter
  const Segmented drawn = draw_window(ellipses, 0.1, 0.1, 1 * mm);
  ASSERT_EQ(drawn.inclusions.size(), 3u);
  for (int id = 1; id <= 3; ++id) EXPECT_EQ(drawn.inclusions[static_cast<std::size_t>(id - 1)].id, id);
  EXPECT_FALSE(drawn.inclusions[0].contour.empty());
  EXPECT_NEAR(drawn.inclusions[0].area, std::numbers::pi * 0.02 * 0.01 / 2, 5e-6);
  EXPECT_TRUE(drawn.inclusions[1].contour.empty());
  EXPECT_EQ(drawn.inclusions[1].ellipse, ellipses[3]);
  EXPECT_NEAR(drawn.inclusions[2].area, std::numbers::pi * 0.01 * 0.01 / 4, 5e-6);
  for (int row = 0; row < 100; ++row) {
    for (int col = 0; col < 100; ++col) {
      int id = 0;
      for (const int i : {0, 3, 4})
        if (contains(ellipses[static_cast<std::size_t>(i)], drawn.mask.centre(row, col)))
          id = i == 0 ? 1 : i - 1;
      EXPECT_EQ(drawn.instances(row, col), id) << row << ' ' << col;
      EXPECT_EQ(drawn.mask.labels(row, col), id > 0 ? phase::aggregate : phase::mortar);
    }
  }
}

}  // namespace draw_test
}  // namespace specimen
