#include "specimen/describe/descriptors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "specimen/body/measure.hpp"
#include "specimen/pack/packing.hpp"

namespace specimen {
namespace spacing_test {

constexpr double mm = 1e-3;

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

}  // namespace spacing_test
}  // namespace specimen
