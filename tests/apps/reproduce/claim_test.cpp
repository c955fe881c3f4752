#include "apps/reproduce/figure.hpp"

#include <gtest/gtest.h>

namespace claim_test {

using namespace app::reproduce;

TEST(Claim, AgreesWhereItHoldsInAllCases) {
  EXPECT_EQ(verdict_of({true, true}), Verdict::agrees);
  EXPECT_EQ(verdict_of({true, false}), Verdict::depends);
  EXPECT_EQ(verdict_of({false, false}), Verdict::disagrees);
}

TEST(Claim, AboutChanceAgreesWhereItHoldsMostly) {
  EXPECT_EQ(verdict_of_share(0.8), Verdict::agrees);
  EXPECT_EQ(verdict_of_share(0.79), Verdict::depends);
  EXPECT_EQ(verdict_of_share(0.21), Verdict::depends);
  EXPECT_EQ(verdict_of_share(0.2), Verdict::disagrees);
}

TEST(Claim, HasAWordForEachVerdict) {
  EXPECT_EQ(word_of(Verdict::agrees), "agrees");
  EXPECT_EQ(word_of(Verdict::disagrees), "disagrees");
  EXPECT_EQ(word_of(Verdict::depends), "depends");
}

}  // namespace claim_test
