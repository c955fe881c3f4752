#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "apps/reproduce/figure.hpp"
#include "tests/apps/reproduce/fake_results.hpp"

namespace fig_objectivity_test {

using namespace app::reproduce;
using testing::HasSubstr;
using testing::Not;

Effort effort_of(int specimens) {
  Effort effort;
  effort.specimens = specimens;
  return effort;
}

/// Results in which the peak of either law grows by a share whenever the pixels are halved.
TrialResults outcomes_with(const Effort& effort, double band_growth, double energy_growth) {
  TrialResults outcomes;
  for (const Trial& trial : objectivity_figure().trials(effort)) {
    const std::string name = name_of(trial);
    const bool brittle = name.find("brittle") != std::string::npos;
    double halvings = 0;
    for (const char* size : {"=0.5 mm", "=0.25 mm", "=0.125 mm", "=0.0625 mm"}) {
      ++halvings;
      if (name.find(size) == std::string::npos) continue;
      mpm::Result result = test::triangle(3e6 * (1 + halvings * (brittle ? -0.2 : band_growth)), 2e-4);
      result.history.back().released = 1 + halvings * (brittle ? -0.2 : energy_growth);
      test::put(outcomes, trial, result);
    }
    if (name.find("=1 mm") != std::string::npos) test::put(outcomes, trial, test::triangle(3e6, 2e-4));
  }
  return outcomes;
}

std::string html_with(double band_growth, double energy_growth) {
  const Effort effort = effort_of(2);
  return objectivity_figure().evaluate(effort, outcomes_with(effort, band_growth, energy_growth)).html;
}

TEST(FigObjectivity, RunsEveryFieldAtEveryPixelSizeWithBothLaws) {
  std::set<std::string> names;
  for (const Trial& trial : objectivity_figure().trials(effort_of(20))) names.insert(name_of(trial));
  EXPECT_EQ(names.size(), 2U * 5U * 5U);
  EXPECT_EQ(objectivity_figure().trials(effort_of(2)).size(), 2U * 5U * 2U);
}

TEST(FigObjectivity, SettingsSuitTheSchema) {
  for (const Trial& trial : objectivity_figure().trials(effort_of(1)))
    EXPECT_NO_THROW((void)settings_of(trial)) << name_of(trial);
}

TEST(FigObjectivity, SaysWhetherThePeakAndTheEnergySettle) {
  EXPECT_THAT(html_with(0.01, 0.01), HasSubstr("no longer depend on the pixel"));
  EXPECT_THAT(html_with(0.01, 0.2), HasSubstr("the energy does still"));
  EXPECT_THAT(html_with(0.2, 0.01), HasSubstr("The peak still depends on the pixel"));
  EXPECT_THAT(html_with(0.2, 0.01), Not(HasSubstr("no longer")));
}

TEST(FigObjectivity, GivesTheChangeOfTheFinest) {
  const Effort effort = effort_of(2);
  const auto data = objectivity_figure().evaluate(effort, outcomes_with(effort, 0.01, 0.01)).data;
  EXPECT_NEAR(data["crack band"]["peak_change_of_the_finest"].get<double>(), 1.04 / 1.03 - 1, 1e-12);
  EXPECT_NEAR(data["at one blow"]["energy_change_of_the_finest"].get<double>(), 0.2 / 0.4 - 1, 1e-12);
  EXPECT_EQ(data["crack band"]["peak_stress_Pa"].size(), 5U);
}

}  // namespace fig_objectivity_test
