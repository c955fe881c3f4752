#include "libmpm/scene/result.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

namespace result_test {

/// A row whose members are 1, 2, 3 ... in the order of their declaration.
mpm::HistoryRow counted_row() { return {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}; }

TEST(HistoryColumns, ReachEveryMemberOnceInOrder) {
  const mpm::HistoryRow row = counted_row();
  double expected = 1;
  for (const mpm::HistoryColumn& column : mpm::history_columns()) {
    const double value =
        std::visit([&](auto member) { return static_cast<double>(row.*member); }, column.member);
    EXPECT_EQ(value, expected++) << column.name;
  }
  EXPECT_EQ(sizeof(mpm::HistoryRow), mpm::history_columns().size() * 8) << "a member has no column";
}

TEST(HistoryColumns, HaveDistinctNamesAndAUnitEach) {
  std::set<std::string_view> names;
  for (const mpm::HistoryColumn& column : mpm::history_columns()) {
    EXPECT_TRUE(names.insert(column.name).second) << column.name;
    EXPECT_FALSE(column.unit.empty()) << column.name;
    EXPECT_FALSE(column.meaning.empty()) << column.name;
  }
}

}  // namespace result_test
