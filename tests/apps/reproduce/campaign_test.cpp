#include "apps/reproduce/campaign.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <set>

#include "tests/apps/reproduce/tiny_effort.hpp"

namespace campaign_test {

using namespace app::reproduce;
using app::Watch;

const Watch to_the_end{[](std::size_t, std::size_t) {}, [] { return true; }};

std::vector<double> peaks(const Reproduction& reproduction) {
  std::vector<double> peaks;
  for (const TrialResults::Entry& entry : reproduction.outcomes.entries())
    peaks.push_back(entry.outcome.result.peak_stress);
  return peaks;
}

TEST(Campaign, RunsWhatAFigureNeedsAndNoMore) {
  const auto reproduction = reproduce_figures(select_figures({"12"}), test::tiny_effort(), 2, to_the_end);
  EXPECT_EQ(reproduction.outcomes.entries().size(), 10U);  // five values, tension and compression
  ASSERT_EQ(reproduction.figures.size(), 1U);
  EXPECT_TRUE(reproduction.figures.front().done);
  EXPECT_FALSE(reproduction.interrupted);
  EXPECT_EQ(claims_of(reproduction).size(), 2U);
}

TEST(Campaign, SaysBeforehandWhatItTakes) {
  Effort effort = test::tiny_effort();
  const auto figures = select_figures({"5"});
  EXPECT_EQ(announcement(figures, effort, 2), "") << "it takes a moment";
  effort.specimens = 20000;
  effort.square.emplace_back("generate.pixel_size", "0.5 mm");
  EXPECT_THAT(
      announcement(figures, effort, 1),
      testing::ContainsRegex("^40002 runs of up to [0-9]+ points and [0-9]+ steps, which take about .* "
                             "here, 1 at a time$"));
}

TEST(Campaign, FiguresShareTheirRuns) {
  const Effort effort = test::tiny_effort();
  std::set<std::string> names;
  for (const Figure* figure : select_figures({"5", "6", "12"}))
    for (const Trial& trial : figure->trials(effort)) names.insert(name_of(trial));
  const auto reproduction = reproduce_figures(select_figures({"5", "6", "12"}), effort, 2, to_the_end);
  EXPECT_EQ(reproduction.outcomes.entries().size(), names.size());
  EXPECT_LT(names.size(), 6U + 2U + 10U);
}

TEST(Campaign, DoesNotDependOnTheNumberOfWorkers) {
  const auto one = reproduce_figures(select_figures({"8"}), test::tiny_effort(), 1, to_the_end);
  const auto three = reproduce_figures(select_figures({"8"}), test::tiny_effort(), 3, to_the_end);
  EXPECT_EQ(peaks(one), peaks(three));
  EXPECT_EQ(one.figures.front().section.html, three.figures.front().section.html);
  EXPECT_EQ(one.figures.front().section.data, three.figures.front().section.data);
}

TEST(Campaign, RunsTheSecondRoundOnWhatTheFirstOneGave) {
  const Effort effort = test::tiny_effort();
  const auto reproduction = reproduce_figures(select_figures({"11"}), effort, 2, to_the_end);
  EXPECT_EQ(reproduction.outcomes.entries().size(), 2U * static_cast<std::size_t>(effort.specimens));
  const auto& data = reproduction.figures.front().section.data;
  const double first = data["table_1"]["peak_stress_Pa"]["mean"],
               second = data["calibrated"]["peak_stress_Pa"]["mean"];
  EXPECT_NEAR(second, 1.745e6, 0.1e6) << "from " << first;  // the middle of the paper's peaks
}

TEST(Campaign, KeepsWhatWasDoneWhenItIsInterrupted) {
  std::atomic<int> done = 0;
  const Watch interrupted{[&](std::size_t, std::size_t) { ++done; }, [&] { return done < 12; }};
  const auto reproduction =
      reproduce_figures(select_figures({"1", "12", "13"}), test::tiny_effort(), 1, interrupted);
  EXPECT_TRUE(reproduction.interrupted);
  ASSERT_EQ(reproduction.figures.size(), 3U);
  EXPECT_TRUE(reproduction.figures[0].done);
  EXPECT_TRUE(reproduction.figures[1].done);
  EXPECT_FALSE(reproduction.figures[2].done);
  EXPECT_TRUE(reproduction.figures[2].section.claims.empty());  // nothing is said of runs that are missing
}

TEST(Campaign, TellsHowFarItIs) {
  std::vector<std::size_t> told;
  static_cast<void>(reproduce_figures(select_figures({"12"}), test::tiny_effort(), 1,
                                      {[&](std::size_t done, std::size_t all) {
                                         EXPECT_EQ(all, 10U);
                                         told.push_back(done);
                                       },
                                       [] { return true; }}));
  EXPECT_THAT(told, testing::ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9, 10));
}

}  // namespace campaign_test
