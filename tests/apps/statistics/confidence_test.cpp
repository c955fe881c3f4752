#include "apps/statistics/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace confidence_test {

using namespace app;

TEST(Confidence, IntervalIsStudents) {
  const MeanEstimate estimate = mean_estimate({1, 2, 3, 4, 5, std::nan("")});
  EXPECT_EQ(estimate.count, 5U);
  EXPECT_DOUBLE_EQ(estimate.mean, 3);
  EXPECT_NEAR(estimate.deviation, std::sqrt(2.5), 1e-12);
  EXPECT_NEAR(estimate.half_width, 2.776445 * std::sqrt(2.5 / 5),
              1e-5);  // t of 4 degrees of freedom, in any table
  EXPECT_NEAR(estimate.relative_half_width(), estimate.half_width / 3, 1e-12);
}

TEST(Confidence, OneValueTellsNothingOfItsScatter) {
  EXPECT_TRUE(std::isnan(mean_estimate({2}).half_width));
  EXPECT_TRUE(std::isnan(mean_estimate({}).mean));
  EXPECT_EQ(values_needed(mean_estimate({2}), 0.02), 0U);
}

TEST(Confidence, NeedsTheLeastNumberThatIsEnough) {
  const MeanEstimate estimate{30, 10, 1, 0.37};
  // n = 97 of a normal distribution with 10 % scatter and 2 %; Student's factor asks for two more.
  const std::size_t needed = values_needed(estimate, 0.02);
  EXPECT_EQ(needed, 99U);
  EXPECT_EQ(values_needed({5, 10, 0, 0}, 0.02), 2U);
}

}  // namespace confidence_test
