#include "specimen/picture/picture.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace preview_test {

using specimen::phase_colour;
using specimen::Rgb;

int distance(Rgb p, Rgb q) { return std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b); }

TEST(Preview, GivesThePhasesTheColoursOfTheLegend) {
  EXPECT_EQ(phase_colour(specimen::phase::void_), (Rgb{255, 255, 255}));
  const Rgb aggregate = phase_colour(specimen::phase::aggregate);
  EXPECT_TRUE(aggregate.b > aggregate.g && aggregate.g > aggregate.r) << "blue-grey";
  const Rgb itz = phase_colour(specimen::phase::itz);
  EXPECT_TRUE(itz.r > itz.g && itz.g > itz.b) << "dark orange";
}

TEST(Preview, KeepsThePhasesApart) {
  for (int first = 0; first < 24; ++first)
    for (int second = 0; second < first; ++second)
      EXPECT_GE(distance(phase_colour(static_cast<std::uint8_t>(first)),
                         phase_colour(static_cast<std::uint8_t>(second))),
                20)
          << first << " and " << second;
}

TEST(Preview, ShowsEveryPixelWhereItIs) {
  specimen::LabelledMask mask;
  mask.labels = specimen::Raster<std::uint8_t>(2, 3, specimen::phase::mortar);
  mask.labels(0, 2) = specimen::phase::itz;
  mask.labels(1, 0) = 255;
  const specimen::Raster<Rgb> picture = specimen::preview(mask);
  ASSERT_EQ(picture.rows, 2);
  ASSERT_EQ(picture.cols, 3);
  for (int row = 0; row < 2; ++row)
    for (int col = 0; col < 3; ++col) EXPECT_EQ(picture(row, col), phase_colour(mask.labels(row, col)));
}

}  // namespace preview_test
