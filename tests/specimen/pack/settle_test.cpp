#include "specimen/pack/relaxation.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace specimen {
namespace settle_test {

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

}  // namespace settle_test
}  // namespace specimen
