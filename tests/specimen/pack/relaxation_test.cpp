#include "specimen/pack/relaxation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "specimen/body/raster.hpp"

namespace specimen {
namespace relaxation_test {

constexpr double pi = std::numbers::pi;

std::vector<Ellipse> anywhere(int count, double a, double aspect, const Room& room) {
  Random random(1);
  std::vector<Ellipse> ellipses;
  for (int n = 0; n < count; ++n) {
    ellipses.push_back({random.uniform(0, room.width), random.uniform(0, room.height), a, a * aspect,
                        random.uniform(0, pi)});
  }
  return ellipses;
}

void expect_all_gaps(const std::vector<Ellipse>& ellipses, const Room& room) {
  for (std::size_t i = 0; i < ellipses.size(); ++i) {
    EXPECT_TRUE(clear_of_walls(ellipses[i], room)) << i;
    for (std::size_t j = 0; j < i; ++j) EXPECT_TRUE(separated(ellipses[i], ellipses[j], room.gap)) << i << j;
  }
}

TEST(Relaxation, PartsEllipsesThatWereDroppedAnywhere) {
  const Room room{0.1, 0.08, 0.5e-3};
  for (const double aspect : {1.0, 0.5, 0.1}) {
    std::vector<Ellipse> ellipses = anywhere(60, 5e-3 / std::sqrt(aspect), aspect, room);
    const std::vector<Ellipse> before = ellipses;
    if (aspect == 0.1) ellipses.resize(20);  // needles 32 mm long do not pack well
    const Relaxation relaxation = relax(ellipses, room);
    EXPECT_TRUE(relaxation.solved) << aspect;
    expect_all_gaps(ellipses, room);
    for (std::size_t i = 0; i < ellipses.size(); ++i) {
      EXPECT_EQ(ellipses[i].a, before[i].a);
      EXPECT_EQ(ellipses[i].b, before[i].b);
      EXPECT_GE(ellipses[i].angle, 0);
      EXPECT_LT(ellipses[i].angle, pi);
    }
  }
}

TEST(Relaxation, LeavesAloneWhatKeepsItsGaps) {
  const Room room{1, 1, 0.05};
  std::vector<Ellipse> ellipses{{0.25, 0.25, 0.15, 0.1, 0.3}, {0.7, 0.7, 0.2, 0.1, 1}};
  const std::vector<Ellipse> before = ellipses;
  const Relaxation relaxation = relax(ellipses, room);
  EXPECT_TRUE(relaxation.solved);
  EXPECT_EQ(relaxation.sweeps, 1);
  EXPECT_EQ(ellipses, before);
}

TEST(Relaxation, MovesTheSmallOneAndTurnsWhatIsHitAside) {
  const Room room{1, 1, 0};
  std::vector<Ellipse> ellipses{{0.5, 0.5, 0.3, 0.1, 0}, {0.7, 0.6, 0.05, 0.05, 0}};
  EXPECT_TRUE(relax(ellipses, room).solved);
  EXPECT_GT(std::hypot(ellipses[1].x - 0.7, ellipses[1].y - 0.6),
            3 * std::hypot(ellipses[0].x - 0.5, ellipses[0].y - 0.5));
  EXPECT_GT(ellipses[0].angle, pi / 2);  // pushed down at its right end: just below pi
}

TEST(Relaxation, OfConcentricCirclesFindsAWay) {
  const Room room{1, 1, 0.01};
  std::vector<Ellipse> ellipses(4, Ellipse{0.5, 0.5, 0.1, 0.1, 0});
  EXPECT_TRUE(relax(ellipses, room).solved);
  expect_all_gaps(ellipses, room);
}

TEST(Relaxation, GivesUpWhenThereIsNoRoom) {
  const Room room{0.1, 0.1, 1e-3};
  std::vector<Ellipse> ellipses = anywhere(130, 5e-3, 0.9, room);  // 92 % without their gaps
  const Relaxation relaxation = relax(ellipses, room);
  EXPECT_FALSE(relaxation.solved);
  EXPECT_LE(relaxation.sweeps, 10'000);
}

TEST(Relaxation, OfNothingIsDone) {
  std::vector<Ellipse> none;
  EXPECT_TRUE(relax(none, {1, 1, 0}).solved);
}

TEST(Relaxation, InAPeriodicRoomKeepsTheGapThroughTheEdges) {
  const Room room{0.1, 0.08, 0.5e-3, true};
  std::vector<Ellipse> ellipses = anywhere(110, 5e-3, 0.65, room);  // 70 % of the room
  ASSERT_TRUE(relax(ellipses, room).solved);
  int across_an_edge = 0;
  for (std::size_t i = 0; i < ellipses.size(); ++i) {
    const Ellipse& e = ellipses[i];
    EXPECT_GE(std::min(e.x, e.y), 0);
    EXPECT_LE(e.x, room.width);
    EXPECT_LE(e.y, room.height);
    across_an_edge += !clear_of_walls(e, {room.width, room.height, 0});
    for (std::size_t j = 0; j < i; ++j)
      for (const Point shift : repeats(room)) {
        Ellipse repeated = ellipses[j];
        repeated.x += shift.x;
        repeated.y += shift.y;
        EXPECT_TRUE(separated(e, repeated, room.gap)) << i << ' ' << j;
      }
  }
  EXPECT_GT(across_an_edge, 10);
}

TEST(Relaxation, LeavesFixedAnglesAlone) {
  const Room room{0.1, 0.1, 0.5e-3};
  std::vector<Ellipse> ellipses = anywhere(80, 5e-3, 0.6, room);
  const std::vector<Ellipse> before = ellipses;
  ASSERT_TRUE(relax(ellipses, room, Turning::fixed).solved);
  expect_all_gaps(ellipses, room);
  for (std::size_t i = 0; i < ellipses.size(); ++i) EXPECT_EQ(ellipses[i].angle, before[i].angle);
}

std::vector<Ellipse> alike(int count, double a, double b) {
  return std::vector<Ellipse>(static_cast<std::size_t>(count), Ellipse{0, 0, a, b, 0.3});
}

TEST(Settle, PlacesPlainlyWhereThereIsRoom) {
  const Room room{0.1, 0.1, 1e-3};
  std::vector<Ellipse> ellipses = alike(20, 6e-3, 4e-3);
  Random random(1);
  const Settlement settlement = settle(ellipses, room, Turning::free, random);
  EXPECT_TRUE(settlement.solved);
  EXPECT_FALSE(settlement.relaxed);
  EXPECT_EQ(without_collisions(ellipses, room).size(), ellipses.size());
  EXPECT_NE(ellipses[0].angle, ellipses[1].angle);
}

TEST(Settle, RelaxesWhereThereIsNot) {
  for (const bool periodic : {false, true}) {
    const Room room{0.1, 0.1, 0.2e-3, periodic};
    std::vector<Ellipse> ellipses = alike(85, 6e-3, 4e-3);  // 64 %
    Random random(1);
    const Settlement settlement = settle(ellipses, room, Turning::free, random);
    EXPECT_TRUE(settlement.solved);
    EXPECT_TRUE(settlement.relaxed);
    EXPECT_EQ(without_collisions(ellipses, room).size(), ellipses.size());
  }
}

TEST(Settle, KeepsFixedAngles) {
  const Room room{0.1, 0.1, 0.5e-3, true};
  std::vector<Ellipse> ellipses = alike(70, 6e-3, 4e-3);
  Random random(1);
  EXPECT_TRUE(settle(ellipses, room, Turning::fixed, random).solved);
  for (const Ellipse& e : ellipses) EXPECT_EQ(e.angle, 0.3);
}

TEST(Settle, SaysWhichEllipseIsTooLargeForTheWalls) {
  std::vector<Ellipse> ellipses{{0, 0, 0.02, 0.02, 0}, {0, 0, 0.06, 0.01, 0.3}};
  Random random(1);
  const Settlement settlement = settle(ellipses, {0.1, 0.05, 1e-3}, Turning::fixed, random);
  EXPECT_FALSE(settlement.solved);
  ASSERT_TRUE(settlement.too_large);
  EXPECT_EQ(*settlement.too_large, 1u);
}

TEST(Settle, GivesUpWhenThereIsNoRoomAtAll) {
  std::vector<Ellipse> ellipses = alike(130, 5e-3, 4.5e-3);  // 92 %
  Random random(1);
  EXPECT_FALSE(settle(ellipses, {0.1, 0.1, 1e-3, true}, Turning::free, random).solved);
}

}  // namespace relaxation_test
}  // namespace specimen
