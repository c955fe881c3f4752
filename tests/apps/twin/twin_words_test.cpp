#include "apps/twin/twin_words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/apps/small_twins.hpp"

namespace app {
namespace twin_words_test {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(TwinWords, GiveFiguresInTheUnitsOfTheirNames) {
  const TwinTask task = test::small_task();
  specimen::Misfit misfit;
  misfit.fraction = {0.45, 0.4498, 0.001, 0.449, 0.451};
  misfit.median_diameter = {9e-3, 9.5e-3, 0.25e-3, 9.1e-3, 9.9e-3};
  misfit.specific_perimeter = {250, 250, 0, 250, 250};
  const std::vector<FigureRow> rows = figure_rows(task, misfit);
  EXPECT_EQ(rows[0].name, "Aggregate fraction (%)");
  EXPECT_EQ(rows[0].original, "45.00");
  EXPECT_EQ(rows[0].difference, "-0.02");
  EXPECT_EQ(rows[1].mean, "9.50");
  EXPECT_EQ(rows[1].deviation, "0.25");
  EXPECT_EQ(rows[1].range, "9.10 to 9.90");
  EXPECT_EQ(rows[1].difference, "+0.50");
  EXPECT_EQ(rows.back().original, "0.2500");
  EXPECT_EQ(rows.back().difference, "0.0000");
}

TEST(TwinWords, JudgeCurvesWhereThereIsAScatter) {
  specimen::Misfit misfit;
  misfit.s2_rms = {0.02, 0.01, 0.03};
  misfit.s2_largest = {0.04, 0.01, 0.03};
  misfit.sizes = {0.04, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  const std::vector<CurveRow> rows = curve_rows(misfit);
  EXPECT_EQ(rows[0].verdict, "");
  EXPECT_EQ(rows[0].largest, "-");
  EXPECT_EQ(rows[3].name, "S2, root mean square (%)");
  EXPECT_EQ(rows[3].original, "2.00");
  EXPECT_EQ(rows[3].verdict, "within the twins");
  EXPECT_EQ(rows[4].verdict, "farther than any twin");
}

TEST(TwinWords, SayTheDirectionOnlyWhereTwinsKeepIt) {
  TwinTask task = test::small_task();
  const auto names = [&] {
    std::vector<std::string> all;
    for (const FigureRow& row : figure_rows(task, {})) all.push_back(row.name);
    return all;
  };
  EXPECT_THAT(names(), Not(Contains("Direction of the long axes (degrees)")));
  task.plan.oriented = true;
  task.descriptors.orientation = {0.5, 0.9, 1e-5};
  EXPECT_THAT(names(), Contains("Direction of the long axes (degrees)"));
  EXPECT_THAT(twin_notes(task, {}),
              Contains(StartsWith("long axes point to 29 degrees with strength 0.90 (Rayleigh "
                                  "test on doubled angles: p < 0.001)")));
}

TEST(TwinWords, TellWhatToKeepInMind) {
  TwinTask task = test::small_task();
  EXPECT_THAT(twin_notes(task, {}), Contains(HasSubstr("the border cuts no aggregate")));
  EXPECT_THAT(twin_notes(task, {}), Contains(HasSubstr("long axes have no direction in common")));
  EXPECT_THAT(twin_notes(task, {}), Not(Contains(HasSubstr("voids"))));
  specimen::AggregateSample& sample = task.descriptors.sample;
  sample.aggregates.resize(3);
  sample.cut = 2;
  sample.cut_share = 0.6;
  sample.parts = 1;
  task.plan.cut = true;
  task.plan.gap = 0.1e-3;
  task.descriptors.void_fraction = 0.03;
  task.descriptors.merged = 1;
  const std::vector<std::string> notes = twin_notes(task, {{1, "a", {}, true, 4}, {2, "b", {}, false, 7}});
  EXPECT_EQ(
      notes.front(),
      "the border cuts 2 aggregates, with 60.0 % of the aggregate area; sizes and shapes are those of 2 "
      "whole "
      "ones, weighted against that loss; 1 of the cut ones, of which more is seen than the largest whole one "
      "has, counts with what is seen, and a larger picture would tell more; the border of the twins cuts "
      "aggregates too");
  EXPECT_THAT(notes, Contains(HasSubstr("those of the twins 0.1 mm")));
  EXPECT_THAT(notes, Contains("sizes and shapes are those of 3 aggregates only: their tails are not known"));
  EXPECT_THAT(notes, Contains(StartsWith("1 aggregate of the original is so far from convex")));
  EXPECT_THAT(notes, Contains(StartsWith("3.0 % of the original are voids")));
  EXPECT_THAT(notes, Contains(StartsWith("1 twin did not fit by plain placement")));
  EXPECT_THAT(notes, Contains("up to 7 aggregates of a twin are smaller than its pixels and left out"));
}

TEST(TwinWords, NameWhatWasMade) {
  const TwinTask task = test::small_task();
  EXPECT_EQ(twins_text(task, 2), "2 twins of cut, 40 mm x 40 mm, pixels of 0.5 mm, seeds 5 to 6");
  EXPECT_EQ(twins_text(task, 1), "1 twin of cut, 40 mm x 40 mm, pixels of 0.5 mm, seed 5");
}

}  // namespace twin_words_test
}  // namespace app
