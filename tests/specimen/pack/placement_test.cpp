#include "specimen/pack/placement.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "specimen/body/raster.hpp"

namespace specimen {
namespace placement_test {

TEST(Placement, KeepsTheGapToTheWalls) {
  const Room room{1, 0.5, 0.125};
  EXPECT_TRUE(clear_of_walls({0.375, 0.25, 0.25, 0.125, 0}, room));  // exactly the gap on three sides
  EXPECT_FALSE(clear_of_walls({0.374, 0.25, 0.25, 0.125, 0}, room));
  EXPECT_FALSE(clear_of_walls({0.626, 0.25, 0.25, 0.125, 0}, room));
  EXPECT_FALSE(clear_of_walls({0.5, 0.249, 0.25, 0.125, 0}, room));
  EXPECT_FALSE(clear_of_walls({0.5, 0.251, 0.25, 0.125, 0}, room));
  EXPECT_FALSE(clear_of_walls({0.5, 0.25, 0.25, 0.125, 0.1}, room));  // its long axis rises
}

TEST(Placement, HasRoomJustWhereEveryPairIsSeparated) {
  const Room room{0.1, 0.1, 1e-3};
  Random random(1);
  Placement placement(room, 100);
  std::vector<Ellipse> placed;
  int refused = 0;
  for (int n = 0; n < 2'000; ++n) {
    const double a = random.uniform(1e-3, 10e-3);
    const Ellipse e{random.uniform(0, 0.1), random.uniform(0, 0.1), a, a * random.uniform(0.1, 1),
                    random.uniform(0, std::numbers::pi)};
    bool expected = clear_of_walls(e, room);
    for (const Ellipse& other : placed) expected = expected && separated(e, other, room.gap);
    ASSERT_EQ(placement.has_room_for(e), expected) << n;
    if (expected) {
      placement.place(e);
      placed.push_back(e);
    } else {
      ++refused;
    }
  }
  EXPECT_GT(placed.size(), 20u);
  EXPECT_GT(refused, 1'000);
}

TEST(Placement, DropsWhatCollidesWithAnEarlierOne) {
  const Room room{1, 1, 0.1};
  const Ellipse first{0.3, 0.3, 0.1, 0.1, 0}, near{0.55, 0.3, 0.1, 0.1, 0}, far{0.7, 0.7, 0.1, 0.1, 0};
  EXPECT_EQ(without_collisions({first, near, far}, room), (std::vector<Ellipse>{first, far}));
}

TEST(Placement, InAPeriodicRoomSeesNeighboursThroughTheEdges) {
  const Room room{0.1, 0.08, 1e-3, true};
  EXPECT_EQ(repeats(room).size(), 9u);
  EXPECT_EQ(repeats({0.1, 0.08, 1e-3}).size(), 1u);
  EXPECT_TRUE(clear_of_walls({0, 0, 0.03, 0.02, 0}, room));
  Random random(1);
  Placement placement(room, 100);
  std::vector<Ellipse> placed;
  int refused_through_an_edge = 0;
  for (int n = 0; n < 2'000; ++n) {
    const double a = random.uniform(1e-3, 10e-3);
    const Ellipse e{random.uniform(0, 0.1), random.uniform(0, 0.08), a, a * random.uniform(0.1, 1),
                    random.uniform(0, std::numbers::pi)};
    bool inside = true, everywhere = true;
    for (const Ellipse& other : placed)
      for (int across = -2; across <= 2; ++across)
        for (int up = -2; up <= 2; ++up) {
          Ellipse repeated = other;
          repeated.x += across * room.width;
          repeated.y += up * room.height;
          const bool clear = separated(e, repeated, room.gap);
          everywhere = everywhere && clear;
          if (across == 0 && up == 0) inside = inside && clear;
        }
    ASSERT_EQ(placement.has_room_for(e), everywhere) << n;
    refused_through_an_edge += inside && !everywhere;
    if (!everywhere) continue;
    placement.place(e);
    placed.push_back(e);
  }
  EXPECT_GT(placed.size(), 20u);
  EXPECT_GT(refused_through_an_edge, 30);
}

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

}  // namespace placement_test
}  // namespace specimen
