#include "apps/statistics/influences.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace size_effect_test {

using namespace app;

TEST(SizeEffect, FindsTheLawAgain) {
  std::vector<double> sizes, strengths;
  for (const double size : {0.05, 0.1, 0.2, 0.4}) {
    sizes.push_back(size);
    strengths.push_back(4e6 / std::sqrt(1 + size / 0.15));
  }
  const SizeEffect fit = fit_size_effect(sizes, strengths);
  EXPECT_NEAR(fit.plastic, 4e6, 1e2);
  EXPECT_NEAR(fit.transition, 0.15, 1e-5);
  EXPECT_NEAR(fit.determination, 1, 1e-9);
  EXPECT_FALSE(fit.bounded);
  EXPECT_NEAR(fit.strength(0.2), strengths[2], 1e2);
}

TEST(SizeEffect, SaysWhenThereIsNone) {
  const SizeEffect fit =
      fit_size_effect({0.1, 0.2, 0.4, 0.1, 0.2, 0.4}, {3e6, 3.1e6, 3.2e6, 3.2e6, 3e6, 3.3e6});
  EXPECT_TRUE(fit.bounded);
  EXPECT_LT(fit.determination, 0.5);
}

}  // namespace size_effect_test
