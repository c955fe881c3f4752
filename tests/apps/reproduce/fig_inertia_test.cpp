#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "apps/reproduce/figure.hpp"
#include "tests/apps/reproduce/fake_results.hpp"
#include "tests/apps/reproduce/tiny_effort.hpp"

namespace fig_inertia_test {

using namespace app::reproduce;
using testing::HasSubstr;

bool has(const Trial& trial, const std::string& what) {
  return name_of(trial).find(what) != std::string::npos;
}

/// Explicit runs of the paper reach a share of the peak without inertia; one point a cell gives `single`.
TrialResults outcomes_with(const Effort& effort, double share, double single) {
  TrialResults outcomes;
  for (const Trial& trial : inertia_figure().trials(effort)) {
    double peak = has(trial, "quasi_static") ? 4e6 : has(trial, "local_damping") ? 3.9e6 : share * 4e6;
    if (has(trial, "1 x 1")) peak = single;
    test::put(outcomes, trial, test::triangle(peak, 1e-4));
  }
  return outcomes;
}

TEST(FigInertia, RunsEveryWayOfEveryTest) {
  std::set<std::string> names;
  for (const Trial& trial : inertia_figure().trials(test::tiny_effort())) {
    EXPECT_NO_THROW((void)settings_of(trial)) << name_of(trial);
    names.insert(name_of(trial));
  }
  EXPECT_EQ(names.size(), 3U * 7U);
}

TEST(FigInertia, SaysWhatShareOfThePeakIsInertia) {
  const Effort effort = test::tiny_effort();
  const Section section = inertia_figure().evaluate(effort, outcomes_with(effort, 0.6, 5e6));
  EXPECT_THAT(section.html, HasSubstr("way lies 40.0\u00a0% below that without inertia"));
  EXPECT_THAT(section.html, HasSubstr("with damping 2.5\u00a0% below"));
  EXPECT_THAT(section.html, HasSubstr("In no way do they give the paper"));
  EXPECT_DOUBLE_EQ(section.data["compression"][0]["over_that_without_inertia"].get<double>(), 0.6);
  EXPECT_EQ(section.data["tension"].size(), 7U);
  EXPECT_FALSE(section.data["tension"][6].contains("over_that_without_inertia"));
}

TEST(FigInertia, NamesTheWayThatGivesThePeakOfThePaper) {
  const Effort effort = test::tiny_effort();
  EXPECT_THAT(inertia_figure().evaluate(effort, outcomes_with(effort, 1.1, 1.8e6)).html,
              HasSubstr("microstrain), within a standard deviation, with: 1 x 1, explicit."));
}

}  // namespace fig_inertia_test
