#include "libmpm/scene/result.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string_view>
#include <vector>

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

/// A run through stresses [MPa] at strains of 1, 2, 3 ... in 1e-4.
mpm::Result run_through(const std::vector<double>& stresses) {
  mpm::Result result;
  result.history.emplace_back();
  for (const double stress : stresses) {
    mpm::HistoryRow row;
    row.strain = 1e-4 * static_cast<double>(result.history.size());
    row.stress = 1e6 * stress;
    if (row.stress > result.peak_stress) {
      result.peak_stress = row.stress;
      result.peak_strain = row.strain;
    }
    result.history.push_back(row);
  }
  return result;
}

TEST(PeakReached, OnlyOnceTheStressHasFallenAgain) {
  EXPECT_TRUE(mpm::peak_reached(run_through({1, 2, 3, 1})));
  EXPECT_TRUE(mpm::peak_reached(run_through({1, 3, 2.8, 2.99}))) << "it had fallen in between";
  EXPECT_FALSE(mpm::peak_reached(run_through({1, 2, 3}))) << "the largest stress is the last";
  EXPECT_FALSE(mpm::peak_reached(run_through({1, 2, 1.5, 3, 2.98}))) << "a drop before is none after";
  EXPECT_FALSE(mpm::peak_reached(run_through({})));
  EXPECT_FALSE(mpm::peak_reached(run_through({-1, -2}))) << "the stress never rose above 0";
}

TEST(PeakOf, IsNoNumberWhereThereIsNone) {
  EXPECT_EQ(mpm::peak_of(run_through({1, 2, 3, 1}), &mpm::Result::peak_stress), 3e6);
  EXPECT_DOUBLE_EQ(mpm::peak_of(run_through({1, 2, 3, 1}), &mpm::Result::peak_strain), 3e-4);
  EXPECT_TRUE(std::isnan(mpm::peak_of(run_through({1, 2, 3}), &mpm::Result::peak_stress)));
  EXPECT_TRUE(std::isnan(mpm::peak_of(run_through({}), &mpm::Result::peak_strain)));
}

TEST(PeakReached, TellsHowFarTheStressHasFallen) {
  EXPECT_DOUBLE_EQ(mpm::fall_after_peak(run_through({1, 4, 3, 3.5})), 0.25);
  EXPECT_EQ(mpm::fall_after_peak(run_through({1, 2, 3})), 0);
}

}  // namespace result_test
