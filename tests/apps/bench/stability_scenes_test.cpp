#include "apps/bench/stability_scenes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace stability_scenes_test {

using app::bench::Judge;
using testing::HasSubstr;
using testing::Not;

TEST(StabilityJudge, HoldsWhenAllHolds) {
  const auto finding =
      Judge().near("modulus", 20.1, 20, 1e-2).below("ledger", 1e-9, 1e-6).note("fast").finding();
  EXPECT_TRUE(finding.holds);
  EXPECT_EQ(finding.seen,
            "modulus 20.1, exact 20, off by 5.0e-03 (at most 1e-02); ledger 1e-09 (at most 1e-06); fast");
}

TEST(StabilityJudge, ShowsWhatDoesNotHold) {
  const auto finding = Judge().must(true, "one").below("two", 3, 2).must(true, "three").finding();
  EXPECT_FALSE(finding.holds);
  EXPECT_EQ(finding.seen, "one; NOT AS IT MUST BE: two 3 (at most 2); three");
}

TEST(StabilityJudge, TakesNoNumberForGood) {
  const double nan = std::nan("");
  EXPECT_FALSE(Judge().near("a", nan, 1, 1e9).finding().holds);
  EXPECT_FALSE(Judge().near("a", 1, nan, 1e9).finding().holds);
  EXPECT_FALSE(Judge().near("a", 1, 0, 1e9).finding().holds);
  EXPECT_FALSE(Judge().below("a", nan, 1e9).finding().holds);
}

TEST(StabilityJudge, HoldsNothingWithoutAJudgement) {
  EXPECT_FALSE(Judge().finding().holds);
  EXPECT_FALSE(Judge().note("a figure").finding().holds);
}

}  // namespace stability_scenes_test
