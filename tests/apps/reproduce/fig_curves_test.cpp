// The verdict of figure 5 follows from the curves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/report/reference_curves.hpp"
#include "apps/reproduce/figure.hpp"
#include "tests/apps/reproduce/fake_results.hpp"
#include "tests/apps/reproduce/tiny_effort.hpp"

namespace fig_curves_test {

using namespace app::reproduce;
using testing::HasSubstr;
using testing::Not;

constexpr double tension_peak = 3e6, compression_peak = 30e6;

/// A curve as GB 50010 has it.
mpm::Result as_in_the_code(const std::string& scene) {
  const bool in_tension = scene == "tension";
  mpm::Result result = test::triangle(in_tension ? tension_peak : compression_peak, 1e-3);
  for (mpm::HistoryRow& row : result.history) {
    const double x = row.strain / result.peak_strain;
    row.stress = result.peak_stress * (in_tension ? output::gb_tension(x, tension_peak)
                                                  : output::gb_compression(x, compression_peak, 45e9));
  }
  return result;
}

Section section_of(const std::function<mpm::Result(const std::string& scene)>& result) {
  const Effort effort = test::tiny_effort();
  const Figure figure = curves_figure();
  TrialResults outcomes;
  for (const Trial& trial : figure.trials(effort)) test::put(outcomes, trial, result(trial.scene));
  return figure.evaluate(effort, outcomes);
}

TEST(FigCurves, AgreesWithCurvesAsTheCodesHaveThem) {
  const Claim claim = section_of(as_in_the_code).claims.front();
  EXPECT_EQ(claim.verdict, Verdict::agrees) << claim.measured;
  EXPECT_THAT(claim.why, Not(HasSubstr("softens")));
}

TEST(FigCurves, DependsWhereOnlyTheRisingBranchIsAsInTheCodes) {
  const Section section = section_of([](const std::string& scene) {
    mpm::Result result = as_in_the_code(scene);
    for (mpm::HistoryRow& row : result.history)
      if (row.strain > result.peak_strain) row.stress = 0;
    return result;
  });
  const Claim claim = section.claims.front();
  EXPECT_EQ(claim.verdict, Verdict::depends);
  EXPECT_THAT(claim.why, HasSubstr("of the peak: tension up to the peak, GB 50010"));
  EXPECT_THAT(claim.why, HasSubstr("concrete that softens"));
  EXPECT_GT(section.data["tension"]["distance"]["GB 50010"]["behind_peak"].get<double>(), 0.1);
}

TEST(FigCurves, DisagreesWhereNothingIsAsInTheCodes) {
  const Section section = section_of([](const std::string& scene) {
    mpm::Result result = test::triangle(scene == "tension" ? tension_peak : compression_peak, 1e-3);
    for (mpm::HistoryRow& row : result.history)
      if (row.strain < 0.99 * result.peak_strain || row.strain > 1.01 * result.peak_strain) row.stress = 0;
    return result;
  });
  EXPECT_EQ(section.claims.front().verdict, Verdict::disagrees) << section.claims.front().measured;
}

TEST(FigCurves, DataAreOfTheRuns) {
  const Section section = section_of(as_in_the_code);
  EXPECT_DOUBLE_EQ(section.data["tension"]["peak_stress_Pa"]["mean"].get<double>(), tension_peak);
  EXPECT_DOUBLE_EQ(section.data["compression"]["peak_stress_Pa"]["standard_deviation"].get<double>(), 0);
  EXPECT_THAT(section.html, HasSubstr("3.00 MPa"));
}

}  // namespace fig_curves_test
