#include "specimen/body/raster.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace specimen {
namespace raster_test {

// The 10000th raw number of the default seed is laid down in the C++ standard: 9981545732273789042.
TEST(Random, IsTheStandardTwister) {
  Random random(std::mt19937_64::default_seed);
  double last = 0;
  for (int n = 0; n < 10'000; ++n) last = random.uniform();
  EXPECT_EQ(last, static_cast<double>(9981545732273789042ULL >> 11) * 0x1p-53);
}

TEST(Random, IsUniformAndStaysInItsRange) {
  Random random(7);
  double sum = 0, squares = 0;
  constexpr int count = 100'000;
  for (int n = 0; n < count; ++n) {
    const double u = random.uniform(2, 4);
    ASSERT_GE(u, 2);
    ASSERT_LE(u, 4);
    sum += u;
    squares += (u - 3) * (u - 3);
  }
  EXPECT_NEAR(sum / count, 3, 4 * std::sqrt(1.0 / 3 / count));  // four standard errors
  EXPECT_NEAR(squares / count, 1.0 / 3, 0.005);
}

}  // namespace raster_test
}  // namespace specimen
