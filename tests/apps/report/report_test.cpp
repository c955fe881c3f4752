#include "apps/report/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "apps/report/report_parts.hpp"
#include "tests/apps/fake_run.hpp"

namespace report_test {

using output::report_html;
using testing::HasSubstr;
using testing::Not;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(Report, NeedsNoNetworkAndRunsItsOwnScriptOnly) {
  const FakeRun run = tension_run(60);
  const std::string page = report_html(run.record());
  EXPECT_THAT(page, HasSubstr("content=\"default-src 'none'; style-src 'unsafe-inline'; img-src data:; "
                              "script-src 'sha256-"));
  EXPECT_EQ(count(page, "<script"), 2U);
  EXPECT_EQ(count(page, "<script type=\"application/json\" id=\"data\">"), 1U);
  EXPECT_EQ(count(page, "src=\""), count(page, "src=\"data:image/png;base64,"));
}

TEST(Report, HasNoFilmOfARunWithoutAny) {
  EXPECT_THAT(report_html(still_run({"12", "32"}).record()), Not(HasSubstr("film-screen")));
  EXPECT_THAT(report_html(tension_run(60).record()), HasSubstr("film-screen"));
}

TEST(Report, ShowsKeyFiguresWithUnits) {
  const FakeRun run = tension_run(60);
  const std::string page = report_html(run.record());
  EXPECT_THAT(page, HasSubstr("Peak stress</th><td>3.43</td><td class=\"unit\">MPa"));
  EXPECT_THAT(page, HasSubstr("Strain at the peak</th><td>144</td><td class=\"unit\">microstrain"));
  EXPECT_THAT(page, HasSubstr("peak 3.43 MPa at 144 microstrain"));
}

TEST(Report, CallsNothingAPeakThatIsNone) {
  FakeRun run = tension_run(60);
  std::erase_if(run.result.history, [](const mpm::HistoryRow& row) { return row.strain > 144e-6; });
  const std::string page = report_html(run.record());
  EXPECT_THAT(page, HasSubstr("Largest stress, no peak</th><td>3.43</td>"));
  EXPECT_THAT(page, HasSubstr("no peak: largest 3.43 MPa at 144 microstrain"));
  EXPECT_THAT(page, Not(HasSubstr("Peak stress</th>")));
  EXPECT_THAT(page, Not(HasSubstr("of the peak strain")));
  EXPECT_EQ(count(page, "% of the strain at the largest stress, which is no peak</b>"), 3U);
}

TEST(Report, CallsAnErrorTheLeastWhereARunComparedWithHasNoPeak) {
  const FakeRun run = tension_run(60);
  RunRecord record = run.record();
  record.error_estimate.sources = {{"time step", "CFL 0.25", 3.4e6, 1.4e-4, 0.01, 0.02, 1, true}};
  EXPECT_THAT(report_html(record), HasSubstr("At most 1.0 % in stress and 2.0 % in strain"));
  record.error_estimate.sources.push_back({"pixel size", "2 mm", 4.2e6, 1.9e-4, 0.2, 0.3, 1, false});
  const std::string page = report_html(record);
  EXPECT_THAT(page, HasSubstr("At least 21 % in stress and 32 % in strain"));
  EXPECT_THAT(page, HasSubstr("and more where a run that was compared with ended before its peak"));
  EXPECT_THAT(page, HasSubstr("&gt; 4.200"));
}

TEST(Report, TellsAFaultInItsSectionAndWritesTheRest) {
  const std::string whole = output::standing("A", [] { return std::string("as it is"); });
  EXPECT_EQ(whole, "as it is");
  const std::string faulty =
      output::standing("A & B", []() -> std::string { throw std::runtime_error("x < 1"); });
  EXPECT_THAT(faulty, HasSubstr("<h2>A &amp; B</h2>"));
  EXPECT_THAT(faulty, HasSubstr("This section could not be made: x &lt; 1."));
}

TEST(Report, StandsWhereAggregatesAreFinerThanAnySieve) {
  FakeRun run = tension_run(60);
  ASSERT_GT(run.specimen.inclusions.size(), 1U);
  run.specimen.inclusions.front().equivalent_diameter = 0.1e-3;
  const std::string page = report_html(run.record());
  EXPECT_THAT(page, HasSubstr("Energies and failures"));
  EXPECT_THAT(page, Not(HasSubstr("could not be made")));
  for (specimen::Inclusion& inclusion : run.specimen.inclusions) inclusion.equivalent_diameter = 0.1e-3;
  run.specimen.inclusions.front().equivalent_diameter = 0.2e-3;
  EXPECT_THAT(report_html(run.record()), HasSubstr("Energies and failures"));
}

TEST(Report, ShowsEveryPictureInColourAndGrey) {
  const FakeRun run = tension_run(60);
  const std::string page = report_html(run.record());
  EXPECT_EQ(count(page, "<img "), 2U * 6 + 1);
  EXPECT_EQ(count(page, "% of the peak strain</b>"), 6U);
}

TEST(Report, SaysWhichPicturesAreMissing) {
  const FakeRun run = tension_run(60, 110);
  const std::string page = report_html(run.record());
  EXPECT_EQ(count(page, "% of the peak strain</b>"), 4U);
  EXPECT_THAT(page, HasSubstr("The run ended at 110 % of the peak strain: there is no picture of damage at "
                              "125 % and 150 %."));
}

TEST(Report, ShowsTheDamageAtTheEndBetweenTwoStages) {
  const std::string page = report_html(tension_run(60, 124).record());
  EXPECT_EQ(count(page, "% of the peak strain</b>"), 4U);
  EXPECT_THAT(page, HasSubstr("<b>At the end</b>, 124 % of the peak strain"));
  EXPECT_THAT(report_html(tension_run(60, 100).record()), Not(HasSubstr("At the end")));
}

TEST(Report, StandsWithoutAnyDamagePicture) {
  const FakeRun run = still_run({"12", "32"});
  EXPECT_THAT(report_html(run.record()), HasSubstr("no picture of damage was drawn"));
}

TEST(Report, MagnifiesSmallMasksByWholeFactors) {
  const FakeRun run = tension_run(150);
  EXPECT_THAT(report_html(run.record()), HasSubstr("pixels\" width=\"300\" height=\"300\""));
}

TEST(Report, EscapesEverythingFromOutside) {
  const std::string evil = "</script><script>alert(1)</script>";
  FakeRun run = tension_run(30);
  run.specimen.mask.phases.at(2) = evil;
  run.specimen.provenance = {evil, evil, evil, 1, evil};
  run.result.instruction_set = evil;
  RunRecord record = run.record();
  record.title = record.scene_toml = record.scene_hash = evil;
  record.notes = {evil};
  const std::string page = report_html(record);
  EXPECT_EQ(count(page, "<script"), 2U);  // those of the page
  EXPECT_THAT(page, HasSubstr("<title>&lt;/script&gt;&lt;script&gt;alert(1)&lt;/script&gt;</title>"));
  EXPECT_GE(count(page, "&lt;script&gt;"), 9U);
}

TEST(Report, HasATitleWhereTheUserGaveNone) {
  const FakeRun run = tension_run(30);
  RunRecord record = run.record();
  record.title = "";
  EXPECT_THAT(report_html(record), HasSubstr("<h1>Tension of a specimen of 150 × 150 mm</h1>"));
}

TEST(Report, TellsOfClosureAndExtraPoints) {
  const FakeRun run = compression_run(60);
  const std::string page = report_html(run.record());
  EXPECT_THAT(page, HasSubstr("Crushed later"));
  EXPECT_THAT(page, HasSubstr("Extra ITZ points have no pixel"));
  EXPECT_THAT(page, HasSubstr("Extra points</th><td>2628</td><td>700</td>"));
}

TEST(Report, ShowsTheSpecimenAtTheEndWhereItsPointsMove) {
  const FakeRun run = impact_run(60);
  const std::string page = report_html(run.record());
  EXPECT_EQ(count(page, "<img "), 2U * 6 + 1 + 2);
  EXPECT_EQ(count(page, "alt=\"The specimen at the end\""), 2U);
  EXPECT_THAT(report_html(tension_run(60).record()), Not(HasSubstr("At the end")));
}

TEST(Report, ShowsTheEndEvenWhereThereIsNoPeak) {
  FakeRun run = still_run({"12", "32"});
  run.result.end_x.setConstant(2, 2, 1e-3F);
  run.result.end_y = run.result.end_x;
  const std::string page = report_html(run.record());
  EXPECT_THAT(page, HasSubstr("no picture of damage was drawn"));
  EXPECT_THAT(page, HasSubstr("At the end"));
}

TEST(Report, TellsOfAnImpactWithoutPlatens) {
  const FakeRun run = impact_run(60);
  RunRecord record = run.record();
  record.title = "";
  const std::string page = report_html(record);
  EXPECT_THAT(page, HasSubstr("<h1>Impact of a specimen of 150 × 150 mm</h1>"));
  EXPECT_THAT(page, HasSubstr("Impact at 15 m/s, rough wall at the bottom, plane strain"));
  EXPECT_THAT(page, HasSubstr("Peak stress on the walls</th><td>12.5</td><td class=\"unit\">MPa"));
  EXPECT_THAT(page, HasSubstr("Nominal strain at the peak</th><td>2.00</td><td class=\"unit\">%"));
  EXPECT_THAT(page, HasSubstr("Left the grid</th><td>60</td>"));
  EXPECT_THAT(page, HasSubstr("moving points (GIMP, MUSL, FLIP)"));
  EXPECT_THAT(page, Not(HasSubstr("Work of the platens")));
  EXPECT_THAT(page, Not(HasSubstr("Platen strain")));
}

TEST(Report, TellsWhenPointsBeganToMove) {
  FakeRun run = tension_run(30);
  EXPECT_THAT(report_html(run.record()), Not(HasSubstr("Hand-over to")));
  run.scene.kinematics = mpm::Kinematics::automatic;
  EXPECT_THAT(report_html(run.record()), HasSubstr("Hand-over to moving points</th><td colspan=\"2\">none"));
  for (std::size_t i = 200; i < run.result.history.size(); ++i) run.result.history[i].moving_points = 900;
  EXPECT_THAT(report_html(run.record()), HasSubstr("Hand-over to moving points</th><td>202</td>"));
}

TEST(Report, StaysBelowTwoMegabytes) {
  const FakeRun run = tension_run(300);
  EXPECT_LT(report_html(run.record()).size(), 2'000'000U);
}

TEST(Report, IsTheSameForTheSameRun) {
  const FakeRun run = tension_run(30);
  EXPECT_EQ(report_html(run.record()), report_html(run.record()));
}

}  // namespace report_test
