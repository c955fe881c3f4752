#include "apps/report/run_charts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "tests/apps/fake_run.hpp"

namespace run_charts_test {

using namespace output;

TEST(StressChart, IsInMegapascalAndMicrostrainWithThePeakMarked) {
  const FakeRun run = tension_run(30);
  const Chart chart = stress_chart(run.record());
  ASSERT_EQ(chart.series.size(), 1U);
  const mpm::HistoryRow& row = run.result.history[100];
  EXPECT_DOUBLE_EQ(chart.series[0].x[100], 1e6 * row.strain);
  EXPECT_DOUBLE_EQ(chart.series[0].y[100], 1e-6 * row.stress);
  ASSERT_EQ(chart.markers.size(), 1U);
  EXPECT_EQ(chart.markers[0].text, "peak 3.43 MPa at 144 microstrain");
  EXPECT_DOUBLE_EQ(chart.markers[0].x, 144);
}

TEST(StressChart, MarksNoPeakWhereThereIsNone) {
  FakeRun run = tension_run(30);
  run.result.peak_stress = 0;
  EXPECT_TRUE(stress_chart(run.record()).markers.empty());
}

TEST(EnergyChart, ShowsDampingOnlyWhereThereIsAny) {
  FakeRun run = tension_run(30);
  EXPECT_EQ(energy_chart(run.record()).series.size(), 4U);
  run.scene.local_damping = 0.1;
  EXPECT_EQ(energy_chart(run.record()).series.back().name, "damped");
  run.scene.method = mpm::SolverMethod::quasi_static;  // nothing moves
  EXPECT_EQ(energy_chart(run.record()).series.size(), 3U);
  EXPECT_EQ(energy_chart(run.record()).series.back().name, "released");
}

TEST(EnergyChart, HoldsTheLedger) {
  const FakeRun run = tension_run(30);
  const Chart chart = energy_chart(run.record());
  const mpm::HistoryRow& row = run.result.history[200];
  EXPECT_DOUBLE_EQ(chart.series[0].y[200], row.platen_work);
  EXPECT_DOUBLE_EQ(chart.series[1].y[200], row.elastic);
  EXPECT_DOUBLE_EQ(chart.series[2].y[200], row.released);
  EXPECT_DOUBLE_EQ(chart.series[3].y[200], row.kinetic);
}

TEST(StressChart, IsInPercentWhereStrainsAreLargeAndNominalWithoutPlatens) {
  const FakeRun run = impact_run(30);
  const Chart chart = stress_chart(run.record());
  EXPECT_EQ(chart.x.label, "Nominal strain");
  EXPECT_EQ(chart.x.unit, "%");
  EXPECT_EQ(chart.y.label, "Stress on the walls");
  EXPECT_DOUBLE_EQ(chart.series[0].x[100], 100 * run.result.history[100].strain);
  EXPECT_EQ(chart.markers[0].text, "peak 12.5 MPa at 2.00 %");
}

TEST(EnergyChart, BeginsWithTheEnergyOfTheFlight) {
  const FakeRun run = impact_run(30);
  const Chart chart = energy_chart(run.record());
  EXPECT_EQ(chart.series[0].name, "initial energy");
  EXPECT_DOUBLE_EQ(chart.series[0].y.back(), run.result.history.front().kinetic);
  EXPECT_EQ(chart.series.back().name, "left");
}

double failed_at_the_end(const Chart& chart, const std::string& mode) {
  double sum = 0;
  for (const output::Series& series : chart.series)
    if (series.name.ends_with(mode)) sum += series.y.back();
  return sum;
}

TEST(FailureChart, CountsEveryPhaseAndMode) {
  const FakeRun run = compression_run(60);
  const Chart chart = failure_chart(run.record());
  double expected[] = {0, 0};
  for (const std::uint8_t mode : run.result.failure_mode.reshaped())
    if (mode != 0) ++expected[mode - 1];
  EXPECT_GT(expected[0] * expected[1], 0);
  EXPECT_EQ(failed_at_the_end(chart, "in tension"), expected[0]);
  EXPECT_EQ(failed_at_the_end(chart, "in shear"), expected[1]);
  for (const output::Series& series : chart.series)
    EXPECT_TRUE(std::is_sorted(series.y.begin(), series.y.end())) << series.name;
}

TEST(FailureChart, NothingFailedIsAnEmptyChart) {
  EXPECT_TRUE(failure_chart(still_run({"12", "32"}).record()).series.empty());
}

TEST(FailureStrainChart, EveryFailedPixelIsInOneClass) {
  const FakeRun run = tension_run(60);
  const Chart chart = output::failure_strain_chart(run.record());
  ASSERT_FALSE(chart.series.empty());
  double sum = 0;
  for (const output::Series& series : chart.series)
    for (const double count : series.y) sum += count / 2;  // a bar has two corners
  EXPECT_EQ(sum, static_cast<double>((run.result.failure_mode != std::uint8_t{0}).count()));
}

specimen::Specimen with_diameters(const std::vector<double>& diameters) {
  specimen::Specimen specimen;
  for (const double d : diameters) {
    specimen::Inclusion inclusion;
    inclusion.equivalent_diameter = d;
    inclusion.area = std::numbers::pi / 4 * d * d;
    specimen.inclusions.push_back(inclusion);
  }
  return specimen;
}

TEST(SpecimenCharts, TheSieveCurveRisesToAHundred) {
  const output::Chart chart = output::sieve_chart(with_diameters({4e-3, 6e-3, 9e-3, 12e-3}));
  ASSERT_EQ(chart.series.size(), 1U);
  const auto& y = chart.series[0].y;
  EXPECT_TRUE(std::is_sorted(y.begin(), y.end()));
  EXPECT_NEAR(y.back(), 100, 1e-9);
  EXPECT_NEAR(chart.series[0].x.back(), 12, 1e-9);
}

TEST(SpecimenCharts, ReferencesRunFromTheSmallestToTheLargest) {
  const auto references = output::sieve_references(with_diameters({4e-3, 6e-3, 9e-3, 12e-3}));
  ASSERT_EQ(references.size(), 5U);
  EXPECT_EQ(references[0].name, "A16");
  for (const output::Series& one : references) {
    EXPECT_TRUE(std::is_sorted(one.x.begin(), one.x.end())) << one.name;
    EXPECT_TRUE(std::is_sorted(one.y.begin(), one.y.end())) << one.name;
    EXPECT_NEAR(one.x.front(), 4, 1e-6) << one.name;
    EXPECT_NEAR(one.x.back(), 12, 1e-6) << one.name;
    EXPECT_NEAR(one.y.front(), 0, 1e-6) << one.name;
    EXPECT_NEAR(one.y.back(), 100, 1e-9) << one.name;
  }
}

TEST(SpecimenCharts, WithoutAggregatesThereIsNoCurve) {
  EXPECT_TRUE(output::sieve_chart(with_diameters({})).series.empty());
  EXPECT_TRUE(output::sieve_references(with_diameters({})).empty());
  EXPECT_TRUE(output::sieve_references(with_diameters({5e-3, 5e-3})).empty());  // of one size
}

}  // namespace run_charts_test
