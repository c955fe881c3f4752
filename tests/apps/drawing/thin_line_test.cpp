#include "apps/drawing/ticks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace thin_line_test {

using output::Place;

TEST(UnbrokenLines, StopWhereAValueIsNoNumber) {
  const double gap = std::nan("");
  const auto lines = output::unbroken_lines({0, 1, 2, 3, 4, 5, 6}, {0, 1, gap, 3, gap, 5, 6});
  ASSERT_EQ(lines.size(), 2U);  // the point at 3 stands alone
  EXPECT_EQ(lines[0].size(), 2U);
  EXPECT_EQ(lines[1].front().x, 5);
}

TEST(UnbrokenLines, AreNoneForNoPoints) { EXPECT_TRUE(output::unbroken_lines({}, {}).empty()); }

TEST(ThinLine, LeavesAShortLineAsItIs) {
  const std::vector<Place> line{{0, 0}, {10, 5}, {20, 0}};
  EXPECT_EQ(output::thin_line(line).size(), 3U);
}

TEST(ThinLine, KeepsEndsAndExtremesInOrder) {
  std::vector<Place> line;
  for (int i = 0; i < 100000; ++i) line.push_back({i / 1000.0, 50 + 40 * std::sin(0.37 * i)});
  line[54321].y = -1000;  // a spike one sample wide
  const std::vector<Place> thin = output::thin_line(line);
  EXPECT_LE(thin.size(), 4U * 200);
  EXPECT_EQ(thin.front().x, line.front().x);
  EXPECT_EQ(thin.back().x, line.back().x);
  EXPECT_TRUE(std::is_sorted(thin.begin(), thin.end(), [](Place a, Place b) { return a.x < b.x; }));
  EXPECT_TRUE(std::any_of(thin.begin(), thin.end(), [](Place p) { return p.y == -1000; }));
}

}  // namespace thin_line_test
