#include "apps/study/study_members.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "apps/study/study_file.hpp"
#include "apps/study/study_values.hpp"

namespace study_points_test {

using namespace app;
using testing::ElementsAre;

StudyPlan plan_of(const std::string& text) { return parse_study("scene = \"a.toml\"\n" + text, "s.toml"); }

TEST(StudyPoints, SobolBeginsAsPublished) {
  // The first points of the sequence but its origin, as Joe and Kuo list them.
  const auto points = sobol_points(3, 7);
  EXPECT_THAT(points[0], ElementsAre(0.5, 0.5, 0.5));
  EXPECT_THAT(points[1], ElementsAre(0.75, 0.25, 0.25));
  EXPECT_THAT(points[2], ElementsAre(0.25, 0.75, 0.75));
  EXPECT_THAT(points[3], ElementsAre(0.375, 0.375, 0.625));
  EXPECT_THAT(points[4], ElementsAre(0.875, 0.875, 0.125));
}

TEST(StudyPoints, SobolGrows) {
  const auto few = sobol_points(5, 10), many = sobol_points(5, 20);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
}

TEST(StudyPoints, SobolFillsEveryEighthOfEveryAxisAlike) {
  for (std::size_t axis = 0; axis < 21; ++axis) {
    std::vector<int> counts(8);
    for (const auto& point : sobol_points(21, 63)) ++counts[static_cast<std::size_t>(8 * point[axis])];
    ++counts[0];  // the origin, which is left out
    EXPECT_THAT(counts, testing::Each(8)) << axis;
  }
}

TEST(StudyPoints, LatinHypercubeHasOnePointInEveryStratum) {
  const auto points = latin_hypercube(4, 50, 7);
  for (std::size_t axis = 0; axis < 4; ++axis) {
    std::set<int> strata;
    for (const auto& point : points) strata.insert(static_cast<int>(50 * point[axis]));
    EXPECT_EQ(strata.size(), 50U);
    if (axis == 0) continue;
    const auto together = std::count_if(points.begin(), points.end(), [&](const auto& point) {
      return static_cast<int>(50 * point[0]) == static_cast<int>(50 * point[axis]);
    });
    EXPECT_LT(together, 6) << "the axes are shuffled on their own: one pair in 50 meets by chance";
  }
  EXPECT_EQ(points, latin_hypercube(4, 50, 7));
  EXPECT_NE(points, latin_hypercube(4, 50, 8));
}

TEST(StudyPoints, OfAGridTheLastParameterChangesFirst) {
  const auto points = points_of(plan_of(
      "[vary]\n\"solver.cfl\" = [0.5, 0.8]\n\"loading.velocity\" = [\"1 m/s\", \"2 m/s\", \"3 m/s\"]\n"));
  ASSERT_EQ(points.size(), 6U);
  EXPECT_THAT(points[1], ElementsAre(Value{0.5}, Value{std::string("2 m/s")}));
  EXPECT_THAT(points[3], ElementsAre(Value{0.8}, Value{std::string("1 m/s")}));
}

TEST(StudyPoints, LevelsAreSampledEvenlyAndRangesInProportion) {
  const StudyPlan plan = plan_of(
      "sampling = \"sobol\"\nsamples = 31\n[vary]\n\"generate.seed\" = [1, 2]\n"
      "\"loading.velocity\" = {low = \"1 m/s\", high = \"3 m/s\"}\n");
  const auto points = points_of(plan);
  EXPECT_THAT(points[0], ElementsAre(Value{std::int64_t{2}}, Value{std::string("2 m/s")}));
  EXPECT_THAT(points[1], ElementsAre(Value{std::int64_t{2}}, Value{std::string("1.5 m/s")}));
  const auto ones = std::count_if(points.begin(), points.end(),
                                  [](const auto& point) { return point[0] == Value{std::int64_t{1}}; });
  EXPECT_EQ(ones, 15);  // the origin would be the sixteenth
}

TEST(StudyPoints, RefusesAGridOfFarTooManyPoints) {
  std::string text = "[vary]\n";
  for (const char* key : {"solver.cfl", "solver.local_damping", "generate.fraction"})
    text += std::string("\"") + key + "\" = {from = 0.1, to = 0.5, steps = 100}\n";
  try {
    (void)points_of(plan_of(text));
    FAIL();
  } catch (const Rejected& rejected) {
    EXPECT_EQ(app::text(rejected.complaints.front()),
              "s.toml:3:16: vary: a grid of 1000000 points; must have at most 100000; choose sampling = "
              "\"sobol\" and a number of samples");
  }
}

}  // namespace study_points_test
