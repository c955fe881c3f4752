#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "specimen/describe/doubts.hpp"

#include "tests/apps/fake_run.hpp"

namespace summary_test {

using nlohmann::json;

TEST(Summary, HoldsTheFiguresOfTheResult) {
  const FakeRun run = tension_run(30);
  const json figures = summary(run.record());
  EXPECT_EQ(figures["peak_stress_Pa"], 3.43e6);
  EXPECT_EQ(figures["peak_strain"], 144e-6);
  EXPECT_EQ(figures["tension_failures"], run.result.tension_failures);
  EXPECT_EQ(figures["shear_failures"], run.result.shear_failures);
  EXPECT_EQ(figures["points"], 900);
  EXPECT_EQ(figures["steps"], 10327);
  EXPECT_EQ(figures["dt_s"], 4.2e-8);
  EXPECT_EQ(figures["wall_s"], 8.4);
  EXPECT_EQ(figures["point_updates_per_s"], 900 * 10327 / 8.4);
  EXPECT_EQ(figures["energy_error"], 2.3e-4);
  EXPECT_EQ(figures["instruction_set"], "avx512");
  EXPECT_EQ(figures["stop_reason"], "strain");
  EXPECT_EQ(figures["nothing_carries"], false);
  EXPECT_EQ(figures["end_strain"], run.result.history.back().strain);
}

TEST(Summary, SaysWhetherThereIsAPeak) {
  EXPECT_EQ(summary(tension_run(30).record())["peak_reached"], true);
  FakeRun rising = tension_run(30);
  std::erase_if(rising.result.history, [](const mpm::HistoryRow& row) { return row.strain > 144e-6; });
  EXPECT_EQ(summary(rising.record())["peak_reached"], false);
}

TEST(Summary, HasNoFigureOfAPeakThatIsNone) {
  const json reached = summary(tension_run(30).record());
  EXPECT_EQ(reached["largest_stress_Pa"], 3.43e6);
  EXPECT_EQ(reached["strain_at_largest_stress"], 144e-6);
  EXPECT_EQ(reached["damage_pictures"][0]["percent_of_peak_strain"], 25);
  FakeRun rising = tension_run(30);
  std::erase_if(rising.result.history, [](const mpm::HistoryRow& row) { return row.strain > 144e-6; });
  const json figures = summary(rising.record());
  EXPECT_TRUE(figures["peak_stress_Pa"].is_null());
  EXPECT_TRUE(figures["peak_strain"].is_null());
  EXPECT_EQ(figures["largest_stress_Pa"], 3.43e6);
  EXPECT_EQ(figures["strain_at_largest_stress"], 144e-6);
  EXPECT_TRUE(figures["damage_pictures"][0]["percent_of_peak_strain"].is_null());
  EXPECT_EQ(figures["damage_pictures"][0]["percent_of_strain_at_largest_stress"], 25);
}

TEST(Summary, HoldsTheSettingAndTheSource) {
  const FakeRun run = compression_run(30);
  const RunRecord record = run.record();
  const json figures = summary(record);
  EXPECT_EQ(figures["direction"], "compression");
  EXPECT_EQ(figures["platen"], "rough");
  EXPECT_EQ(figures["plane"], "plane strain");
  EXPECT_EQ(figures["precision"], "double");
  EXPECT_EQ(figures["threads"], 2);
  EXPECT_EQ(figures["crack_closure"], "unilateral");
  EXPECT_EQ(figures["title"], record.title);
  EXPECT_EQ(figures["scene_hash"], record.scene_hash);
  EXPECT_THAT(figures["version"].get<std::string>(), testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+"));
  EXPECT_EQ(figures["specimen"]["rows"], 30);
  EXPECT_EQ(figures["specimen"]["source"], "generated");
}

TEST(Summary, HoldsTheFlightInPlaceOfThePlatens) {
  const FakeRun run = impact_run(30);
  const json figures = summary(run.record());
  EXPECT_EQ(figures["direction"], "none");
  EXPECT_EQ(figures["kinematics"], "moving");
  EXPECT_EQ(figures["initial_velocity_x_m_per_s"], 9);
  EXPECT_EQ(figures["initial_velocity_y_m_per_s"], -12);
  EXPECT_FALSE(figures.contains("platen"));
  EXPECT_FALSE(figures.contains("velocity_m_per_s"));
  EXPECT_EQ(figures["moving_points"], 870);
  EXPECT_EQ(figures["left_points"], 30);
  EXPECT_EQ(figures["stop_reason"], "time");
  EXPECT_EQ(figures["end_picture"]["file"], "deformed.png");
  EXPECT_FALSE(summary(tension_run(30).record()).contains("end_picture"));
}

TEST(Summary, SharesTheAreaAmongThePhases) {
  const FakeRun run = tension_run(30);
  const json shares = summary(run.record())["specimen"]["phase_fractions"];
  EXPECT_EQ(shares.size(), 3U);
  EXPECT_NEAR(
      shares["aggregate"].get<double>() + shares["mortar"].get<double>() + shares["itz"].get<double>(), 1,
      1e-12);
}

TEST(Summary, ListsThePicturesThatWereDrawnAndThoseThatWereNot) {
  const FakeRun run = tension_run(30, 110);
  const json figures = summary(run.record());
  ASSERT_EQ(figures["damage_pictures"].size(), 4U);
  EXPECT_EQ(figures["damage_pictures"][3]["file"], "damage_100.png");
  EXPECT_EQ(figures["damage_pictures"][3]["strain"], 144e-6);
  ASSERT_FALSE(figures["notes"].empty());
  EXPECT_THAT(figures["notes"].back().get<std::string>(), testing::HasSubstr("125 % and 150 %"));
}

TEST(Summary, WarnsOfADoubtfulSpecimen) {
  const FakeRun run = tension_run(30);
  RunRecord record = run.record();
  EXPECT_EQ(summary(record)["warnings"].size(), specimen::doubts_of(record.specimen).size());
  specimen::Specimen from_picture = record.specimen;
  from_picture.provenance.source = "photo.png";
  from_picture.inclusions.clear();
  const RunRecord doubtful{{from_picture, record.scene, "", "", "", {}}, record.result};
  EXPECT_THAT(summary(doubtful)["warnings"].dump(), testing::HasSubstr("there is no aggregate"));
}

TEST(Summary, ReadsBackFromItsTextBitForBit) {
  const FakeRun run = tension_run(30);
  const json figures = summary(run.record());
  EXPECT_EQ(json::parse(figures.dump()), figures);
}

TEST(Summary, WritesNullForWhatIsNoNumber) {
  FakeRun run = tension_run(30);
  run.result.energy_error = std::nan("");
  EXPECT_TRUE(json::parse(summary(run.record()).dump())["energy_error"].is_null());
}

TEST(Summary, AddsUpOverThePhases) {
  const FakeRun run = compression_run(60);
  std::int64_t tension = 0, shear = 0, points = 0;
  const json figures = summary(run.record());
  for (const json& row : figures["failures_by_phase"]) {
    tension += row["tension"].get<std::int64_t>();
    shear += row["shear"].get<std::int64_t>() + row["crushed"].get<std::int64_t>();
    points += row["points"].get<std::int64_t>();
  }
  EXPECT_EQ(tension, run.result.tension_failures);
  EXPECT_EQ(shear, run.result.shear_failures);
  EXPECT_EQ(points, run.result.points);
}

TEST(Summary, HoldsWhatMayBeWrongOnlyWhereThatWasAskedFor) {
  const FakeRun run = tension_run(40);
  RunRecord record = run.record();
  EXPECT_FALSE(summary(record).contains("error_estimate"));
  record.error_estimate.sources = {{"loading rate", "0.025 m/s", 3.4e6, 150e-6, 0.01, 0.02, 1.5},
                                   {"time step", "CFL 0.25", 3.5e6, 149e-6, 0.002, 0.001, 3}};
  const auto estimate = summary(record)["error_estimate"];
  EXPECT_DOUBLE_EQ(estimate["peak_stress_error"].get<double>(), 0.012);
  EXPECT_DOUBLE_EQ(estimate["peak_strain_error"].get<double>(), 0.021);
  EXPECT_DOUBLE_EQ(estimate["wall_s"].get<double>(), 4.5);
  EXPECT_EQ(estimate["sources"][1]["compared_with"], "CFL 0.25");
}

}  // namespace summary_test
