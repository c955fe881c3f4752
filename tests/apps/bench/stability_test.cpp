#include "apps/bench/stability.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "apps/text/complaint.hpp"
#include "tests/apps/bench/made_up_cases.hpp"

namespace stability_test {

using namespace app::bench;
using testing::HasSubstr;

TEST(Stability, HoldsWhenEveryCaseHolds) {
  EXPECT_TRUE(test::run_made_up({0}).holds());
  EXPECT_FALSE(test::run_made_up({0, 1}).holds());
  EXPECT_FALSE(test::run_made_up({2}).holds());
  EXPECT_FALSE(test::run_made_up({}).holds()) << "nothing was shown";
}

TEST(Stability, TakesWhatACaseThrowsForItsFinding) {
  const StabilityOutcome outcome = test::run_made_up({2, 0}, 2);
  EXPECT_EQ(outcome.rows[0].finding.seen, "it threw: no memory");
  EXPECT_TRUE(outcome.rows[0].done);
  EXPECT_TRUE(outcome.rows[1].finding.holds) << "the others go on";
}

TEST(Stability, DoesNotHoldWhenItWasInterrupted) {
  const StabilityOutcome outcome =
      test::run_made_up({0, 0}, 1, [calls = 0]() mutable { return ++calls < 2; });
  EXPECT_TRUE(outcome.interrupted);
  EXPECT_TRUE(outcome.rows[0].done);
  EXPECT_FALSE(outcome.rows[1].done);
  EXPECT_FALSE(outcome.holds());
}

// The quick ones, each of which stands for a group.
TEST(Stability, QuickCasesHold) {
  std::size_t last = 0;
  const StabilityOutcome outcome = run_stability(
      {{"density-contrast", "nothing-carries", "weibull", "checkerboard", "point-on-a-node",
        "point-beside-a-node", "step-chains", "worst-point", "stepwise", "gap-gimp", "single-precision"},
       1},
      {[&](std::size_t done, std::size_t all) {
         EXPECT_EQ(all, 11U);
         EXPECT_EQ(done, last + 1);
         last = done;
       },
       {}});
  EXPECT_EQ(last, 11U);
  for (const StabilityRow& row : outcome.rows)
    EXPECT_TRUE(row.finding.holds) << row.name << ": " << row.finding.seen;
}

TEST(StabilityTable, HoldsEveryCaseOnceWithWhatMustHappen) {
  std::set<std::string> names;
  for (const StabilityCase& one : stability_cases()) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_EQ(one.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), std::string::npos)
        << one.name;
    EXPECT_FALSE(one.must.empty()) << one.name;
    EXPECT_TRUE(one.run) << one.name;
  }
  EXPECT_GE(names.size(), 40U);
}

TEST(StabilityTable, KeepsAGroupTogether) {
  std::vector<std::string> groups;
  for (const StabilityCase& one : stability_cases())
    if (groups.empty() || groups.back() != one.group) groups.push_back(one.group);
  EXPECT_EQ(std::set<std::string>(groups.begin(), groups.end()).size(), groups.size());
}

TEST(StabilityTable, SelectsInItsOwnOrder) {
  EXPECT_EQ(select_cases({}).size(), stability_cases().size());
  const auto some = select_cases({"weibull", "contrast", "weibull"});
  ASSERT_EQ(some.size(), 2U);
  EXPECT_EQ(some[0]->name, "contrast");
  EXPECT_EQ(some[1]->name, "weibull");
}

TEST(StabilityTable, RefusesANameThatIsNone) {
  try {
    (void)select_cases({"contrast", "weibul"});
    FAIL() << "a misspelt name must not choose anything";
  } catch (const app::Rejected& rejected) {
    EXPECT_EQ(rejected.code, app::Exit::usage);
    EXPECT_THAT(rejected.what(), HasSubstr("--case: weibul; must be one of contrast, "));
    EXPECT_THAT(rejected.what(), HasSubstr("did you mean weibull?"));
  }
}

}  // namespace stability_test
