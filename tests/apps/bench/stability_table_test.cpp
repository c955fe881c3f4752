#include "apps/bench/stability.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "apps/text/complaint.hpp"

namespace stability_table_test {

using namespace app::bench;
using testing::HasSubstr;

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

}  // namespace stability_table_test
