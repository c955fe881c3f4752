#include "apps/calibrate/trend_search.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace bounded_minimum_test {

double bowl(const std::vector<double>& x) {
  double value = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double from = x[i] - 0.3 * static_cast<double>(i + 1);
    value += from * from;
  }
  return value;
}

TEST(BoundedMinimum, FindsTheBottom) {
  for (const std::size_t n : {1u, 2u, 3u}) {
    const app::Box box{std::vector(n, 0.0), std::vector(n, -2.0), std::vector(n, 2.0)};
    const std::vector<double> x = app::bounded_minimum(box, bowl);
    for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(x[i], 0.3 * static_cast<double>(i + 1), 1e-5);
  }
}

TEST(BoundedMinimum, StopsAtABound) {
  const std::vector<double> x = app::bounded_minimum({{0, 0}, {-2, -2}, {2, 0.25}}, bowl);
  EXPECT_NEAR(x[0], 0.3, 1e-5);
  EXPECT_NEAR(x[1], 0.25, 1e-9);
}

TEST(BoundedMinimum, PassesOnWhatTheFunctionThrows) {
  EXPECT_THROW(
      (void)app::bounded_minimum({{0}, {-1}, {1}},
                                 [](const std::vector<double>&) -> double { throw std::out_of_range("x"); }),
      std::out_of_range);
}

}  // namespace bounded_minimum_test
