#include "apps/bench/problem_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/apps/complaint_about.hpp"

namespace problem_table_test {

using namespace app::bench;

TEST(ProblemTable, HoldsTheProblemsByName) {
  const std::vector<Problem> all = select_problems({});
  EXPECT_EQ(all.size(), 10U);
  for (const Problem& problem : all) {
    for (const std::string& text : {problem.title, problem.quantity, problem.answer, problem.remark})
      EXPECT_FALSE(text.empty()) << problem.name;
    for (const Method& method : problem.methods) {
      EXPECT_EQ(method.sizes.size(), method.runs.size()) << problem.name << " " << method.name;
      EXPECT_GE(method.sizes.size(), 2U) << problem.name << " " << method.name;
      for (std::size_t i = 1; i < method.sizes.size(); ++i)
        EXPECT_LT(method.sizes[i], method.sizes[i - 1]) << problem.name << " " << method.name;
    }
  }
  ASSERT_EQ(select_problems({"bar", "tension"}).size(), 2U);
  EXPECT_EQ(select_problems({"bar"})[0].name, "bar");
}

TEST(ProblemTable, RefusesWhatIsNotThere) {
  try {
    (void)select_problems({"bra"});
    FAIL();
  } catch (const app::Rejected& rejected) {
    EXPECT_EQ(rejected.code, app::Exit::usage);
    EXPECT_EQ(text(rejected.complaints.at(0)),
              "--problem: bra; must be tension, modulus, bar, manufactured, inclusion, hole, layers, spin, "
              "collision or flight; did you mean bar?");
  }
}

}  // namespace problem_table_test
