#include "specimen/pack/placement.hpp"

#include <gtest/gtest.h>

#include <set>

#include "specimen/body/raster.hpp"

namespace specimen {
namespace spatial_grid_test {

bool meet(const Box& p, const Box& q) {
  return p.left <= q.right && q.left <= p.right && p.bottom <= q.top && q.bottom <= p.top;
}

// Boxes from a hundredth of the room to a third, some of them beyond its walls.
Box random_box(Random& random) {
  const double x = random.uniform(-0.1, 2.1), y = random.uniform(-0.1, 1.1);
  const double half = random.uniform() < 0.9 ? 0.01 : 0.3;
  return {x - half, y - half * random.uniform(), x + half, y + half};
}

TEST(SpatialGrid, VisitsEveryBoxThatMeetsAndNoneTwice) {
  for (const double cell : {0.02, 0.1, 5.0}) {
    Random random(1);
    SpatialGrid grid(2, 1, cell);
    std::vector<Box> boxes;
    for (int n = 0; n < 300; ++n) {
      const Box box = random_box(random);
      std::multiset<int> visited;
      EXPECT_TRUE(grid.visit_near(box, [&](int other) {
        visited.insert(other);
        return true;
      }));
      for (int other = 0; other < n; ++other) {
        ASSERT_LE(visited.count(other), 1u);
        if (meet(box, boxes[other])) {
          ASSERT_EQ(visited.count(other), 1u);
        }
      }
      boxes.push_back(box);
      grid.add(box);
    }
  }
}

TEST(SpatialGrid, VisitsFewOthers) {
  Random random(2);
  SpatialGrid grid(2, 1, 0.02);
  long visits = 0;
  for (int n = 0; n < 5000; ++n) {
    const double x = random.uniform(0, 2), y = random.uniform(0, 1);
    const Box box{x - 0.01, y - 0.01, x + 0.01, y + 0.01};
    grid.visit_near(box, [&](int) {
      ++visits;
      return true;
    });
    grid.add(box);
  }
  EXPECT_LT(visits, 5000 * 20);  // of 5000 * 2500 pairs
}

TEST(SpatialGrid, StopsWhenTold) {
  SpatialGrid grid(1, 1, 0.1);
  for (int n = 0; n < 5; ++n) grid.add({0.4, 0.4, 0.6, 0.6});
  int visits = 0;
  EXPECT_FALSE(grid.visit_near({0.5, 0.5, 0.5, 0.5}, [&](int) { return ++visits < 2; }));
  EXPECT_EQ(visits, 2);
  grid.clear();
  EXPECT_TRUE(grid.visit_near({0, 0, 1, 1}, [](int) { return false; }));
}

}  // namespace spatial_grid_test
}  // namespace specimen
