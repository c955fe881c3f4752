#include "apps/report/key_figures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "libmpm/scene/result.hpp"
#include "tests/apps/fake_run.hpp"

namespace key_figures_test {

using namespace output;
using testing::ElementsAre;
using testing::Pair;

TEST(SecantModulus, IsTakenAtFortyPercentOfThePeak) {
  mpm::Result result;
  result.peak_stress = 10;
  for (const double stress : {0.0, 3.0, 4.5, 10.0})
    result.history.push_back({.strain = stress * stress + stress, .stress = stress});
  EXPECT_DOUBLE_EQ(secant_modulus(result), 4.5 / (4.5 * 4.5 + 4.5));
}

TEST(SecantModulus, IsNoNumberWithoutARun) {
  EXPECT_TRUE(std::isnan(secant_modulus({})));
  mpm::Result at_rest;
  at_rest.history.push_back({});
  EXPECT_TRUE(std::isnan(secant_modulus(at_rest)));
}

TEST(PhaseShares, NameThePhasesThatAreThere) {
  const FakeRun run = still_run({"1222", "1222"});
  EXPECT_THAT(phase_shares(run.specimen.mask), ElementsAre(Pair("aggregate", 0.25), Pair("mortar", 0.75)));
}

TEST(Notes, EndWithThePicturesThatAreMissing) {
  const FakeRun run = tension_run(30, 110);
  RunRecord record = run.record();
  record.notes = {"first"};
  EXPECT_THAT(all_notes(record),
              ElementsAre("first",
                          "The run ended at 110 % of the peak strain: there is no picture of damage at "
                          "125 % and 150 %."));
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

TEST(CurveCsv, NamesEveryColumnWithItsUnit) {
  EXPECT_EQ(output::curve_csv({}),
            "time_s,strain,stress_Pa,stress_top_Pa,stress_bottom_Pa,platen_work_J_per_m,kinetic_J_per_m,"
            "elastic_J_per_m,released_J_per_m,damped_J_per_m,left_J_per_m,tension_failures,shear_failures,"
            "left_points,moving_points\n");
}

TEST(CurveCsv, ReadsBackAsTheSameNumbers) {
  const std::vector<mpm::HistoryRow> history{
      {0.1, 1.0 / 3, -1e6 / 7, 5e-324, 1e300, 0, -0.0, 1e-17, 2.0 / 3, 1e22, std::int64_t{1} << 60, 3},
      {std::nan(""), 1, 2, 3, 4, 5, 6, 7, 8, 9, -1, 0}};
  const std::vector<std::string> lines = split(output::curve_csv(history), '\n');
  ASSERT_EQ(lines.size(), 3U);
  for (std::size_t i = 0; i < history.size(); ++i) {
    const std::vector<std::string> cells = split(lines[i + 1], ',');
    ASSERT_EQ(cells.size(), mpm::history_columns().size());
    for (std::size_t k = 0; k < cells.size(); ++k)
      std::visit(
          [&](auto member) {
            const auto expected = history[i].*member;
            if constexpr (std::is_same_v<decltype(expected), const std::int64_t>)
              EXPECT_EQ(std::strtoll(cells[k].c_str(), nullptr, 10), expected);
            else if (std::isnan(expected))
              EXPECT_EQ(cells[k], "nan");
            else
              EXPECT_EQ(std::strtod(cells[k].c_str(), nullptr), expected);
          },
          mpm::history_columns()[k].member);
  }
}

TEST(FailureTable, CountsByPhaseAndMode) {
  FakeRun run = still_run({"1223", "2233"});
  run.result.failure_mode << 0, 1, 1, 2,  //
      2, 0, 0, 1;
  run.result.crush_strain = run.result.failure_strain;
  run.result.crush_strain(0, 1) = 1e-3F;
  const auto rows = failures_by_phase(run.record());
  ASSERT_EQ(rows.size(), 3U) << "phases that the mask does not hold have no row";
  EXPECT_EQ(rows[0].phase, "aggregate");
  EXPECT_EQ(rows[0].intact(), 1);
  EXPECT_EQ(rows[1].phase, "mortar");
  EXPECT_EQ(rows[1].points, 4);
  EXPECT_EQ(rows[1].tension, 2);
  EXPECT_EQ(rows[1].shear, 1);
  EXPECT_EQ(rows[1].crushed, 1);
  EXPECT_EQ(rows[1].intact(), 1);
  EXPECT_EQ(rows[2].phase, "itz");
  EXPECT_EQ(rows[2].tension, 1);
  EXPECT_EQ(rows[2].shear, 1);
}

TEST(FailureTable, GivesTheRestToTheExtraPoints) {
  const FakeRun run = compression_run(60);
  const auto rows = failures_by_phase(run.record());
  const FailureCount extra = failures_of_extra_points(run.record(), rows);
  EXPECT_EQ(extra.points, 2628);
  EXPECT_EQ(extra.tension, 700);
  EXPECT_EQ(extra.shear, 60);
}

}  // namespace key_figures_test
