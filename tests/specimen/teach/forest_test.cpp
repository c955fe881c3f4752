#include "specimen/teach/forest.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "specimen/body/raster.hpp"

namespace forest_test {

using specimen::Forest;
using specimen::Lessons;

/// Two features that matter (their sum decides), six that do not; so many strokes of each class.
Lessons sample(int pixels, int strokes, std::uint64_t seed, bool balanced = true) {
  specimen::Random random(seed);
  Lessons lessons;
  lessons.features = 8;
  while (static_cast<int>(lessons.pixels()) < pixels) {
    std::vector<float> values;
    for (int f = 0; f < 8; ++f) values.push_back(static_cast<float>(random.uniform(-1, 1)));
    const int of_class = values[2] + values[5] > 0 ? 1 : 0;
    if (!balanced && of_class == 1 && random.uniform() < 0.95) continue;
    lessons.values.insert(lessons.values.end(), values.begin(), values.end());
    lessons.classes.push_back(static_cast<std::uint8_t>(of_class));
    lessons.strokes.push_back(2 * static_cast<int>(random.uniform(0, strokes - 1e-9)) + of_class);
  }
  return lessons;
}

double share_right(const Forest& forest, const Lessons& lessons) {
  std::vector<float> shares(lessons.pixels() * static_cast<std::size_t>(forest.classes));
  specimen::ask_forest(forest, lessons.values.data(), static_cast<int>(lessons.pixels()), shares.data());
  double right = 0;
  for (std::size_t i = 0; i < lessons.pixels(); ++i)
    right += (shares[2 * i + 1] > 0.5F) == (lessons.classes[i] == 1);
  return right / static_cast<double>(lessons.pixels());
}

TEST(Forest, LearnsWhatDecides) {
  const auto taught = specimen::grow_forest(sample(2000, 10, 1), 2, {}, 1);
  EXPECT_GT(share_right(taught.forest, sample(2000, 1, 2)), 0.93);
}

TEST(Forest, TellsHowWellItSortsStrokesThatItDidNotSee) {
  const Lessons fresh = sample(2000, 1, 2);
  const auto taught = specimen::grow_forest(sample(2000, 10, 1), 2, {}, 1);
  for (const double right : taught.right) EXPECT_NEAR(right, share_right(taught.forest, fresh), 0.05);
  // Of one stroke each, every tree has seen all.
  for (const double right : specimen::grow_forest(sample(200, 1, 1), 2, {}, 1).right)
    EXPECT_TRUE(std::isnan(right));
}

TEST(Forest, RareClassIsLearntAsWellAsACommonOne) {
  const auto taught = specimen::grow_forest(sample(3000, 10, 1, false), 2, {}, 1);
  Lessons rare = sample(4000, 1, 3);
  std::vector<float> shares(2 * rare.pixels());
  specimen::ask_forest(taught.forest, rare.values.data(), 4000, shares.data());
  double found = 0, all = 0;
  for (std::size_t i = 0; i < rare.pixels(); ++i)
    if (rare.classes[i] == 1) ++all, found += shares[2 * i + 1] > 0.5F;
  EXPECT_GT(found / all, 0.6);
}

TEST(Forest, IsTheSameOnAnyNumberOfThreadsAndAnotherWithAnotherSeed) {
  const Lessons lessons = sample(600, 5, 1);
  const Forest one = specimen::grow_forest(lessons, 2, {}, 1).forest;
  EXPECT_EQ(one, specimen::grow_forest(lessons, 2, {}, 4).forest);
  EXPECT_NE(one, specimen::grow_forest(lessons, 2, {.seed = 2}, 1).forest);
}

TEST(Forest, SharesSumUpToOneForAnyNumberOfPixels) {
  const Forest forest = specimen::grow_forest(sample(600, 5, 1), 2, {}, 1).forest;
  const Lessons fresh = sample(77, 1, 4);
  std::vector<float> all(2 * 77);
  specimen::ask_forest(forest, fresh.values.data(), 77, all.data());
  for (std::size_t i = 0; i < 77; ++i) {
    EXPECT_NEAR(all[2 * i] + all[2 * i + 1], 1, 1e-5);
    std::array<float, 2> alone{};
    specimen::ask_forest(forest, fresh.values.data() + i * 8, 1, alone.data());
    EXPECT_EQ(alone[0], all[2 * i]);
  }
}

TEST(Forest, WalksEndAtLeavesOfTheirTree) {
  const Forest forest = specimen::grow_forest(sample(600, 5, 1), 2, {.trees = 7, .depth = 3}, 1).forest;
  EXPECT_EQ(forest.roots.size(), 7U);
  EXPECT_LE(forest.nodes.size(), 7U * 15U);
  for (std::size_t i = 0; i < forest.nodes.size(); ++i)
    if (forest.nodes[i].leaf < 0)
      EXPECT_GT(forest.nodes[i].next, static_cast<std::int32_t>(i));
    else
      EXPECT_EQ(forest.nodes[i].next, static_cast<std::int32_t>(i));
}

}  // namespace forest_test
