#include "apps/live/live_view.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "apps/report/report.hpp"
#include "tests/apps/fake_run.hpp"

namespace watching_test {

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// On its way: half of its rows, nothing failed yet.
FakeRun beginning() {
  FakeRun run = tension_run(40);
  run.result.history.resize(5);
  run.result.failure_mode.setZero();
  run.result.failure_strain.setConstant(std::numeric_limits<float>::quiet_NaN());
  return run;
}

RunRecord going_on(const FakeRun& run) {
  RunRecord record = run.record();
  record.goes_on = true;
  return record;
}

TEST(Watching, PageIsTheReportWithABar) {
  const FakeRun run = beginning();
  const std::string page = output::watching_html(going_on(run), {4, 0.4, "42 % <b>"});
  EXPECT_TRUE(holds(page, "data-number=\"4\""));
  EXPECT_TRUE(holds(page, "42 % &lt;b&gt;"));
  EXPECT_TRUE(holds(page, "id=\"film\""));
  EXPECT_FALSE(holds(page, "Ended because"));
  EXPECT_TRUE(holds(page, "Stress now"));
  EXPECT_FALSE(holds(page, "Stress at the end"));
  for (const char* part : {"facts", "failures", "solution"})
    EXPECT_TRUE(holds(page, "id=\"part-" + std::string(part) + "\"")) << part;
  EXPECT_TRUE(holds(page, "id=\"chart-failure-strain\"")) << "there may be failures later on";
}

TEST(Watching, OnlyThePageOfARunThatGoesOnAsksAServer) {
  const FakeRun run = beginning();
  EXPECT_TRUE(holds(output::watching_html(going_on(run), {}), "connect-src 'self'"));
  EXPECT_TRUE(holds(output::watching_html(going_on(run), {}), "fetch("));
  EXPECT_FALSE(holds(output::report_html(run.record()), "connect-src"));
  EXPECT_FALSE(holds(output::report_html(run.record()), "fetch("));
}

TEST(Watching, UpdateHoldsWhatChanges) {
  const FakeRun run = tension_run(40);
  const std::string text = output::watching_update(going_on(run), {9, 0.5, "</script>"});
  EXPECT_FALSE(holds(text, "<"));
  const nlohmann::json update = nlohmann::json::parse(text);
  EXPECT_EQ(update.at("number"), 9);
  EXPECT_EQ(update.at("words"), "</script>");
  EXPECT_TRUE(update.at("goes_on"));
  EXPECT_EQ(update.at("film").at("end_strain"), run.result.history.back().strain);
  EXPECT_FALSE(update.at("film").contains("labels")) << "the specimen stays the same";
  EXPECT_FALSE(update.at("charts").contains("sieve"));
  EXPECT_EQ(update.at("charts").at("energy").at("series").at(0).at("x").size(), run.result.history.size());
  EXPECT_TRUE(holds(update.at("parts").at("failures"), "Mortar"));
}

TEST(Watching, LastUpdateBringsTheTable) {
  const FakeRun run = tension_run(40);
  const nlohmann::json update = nlohmann::json::parse(output::watching_update(run.record(), {}));
  EXPECT_FALSE(update.at("goes_on"));
  EXPECT_TRUE(update.at("csv").is_string());
}

TEST(Watching, ThereMayBeNoFilmYet) {
  FakeRun run = beginning();
  run.result.history.resize(1);
  run.result.history.front().strain = 0;
  EXPECT_TRUE(nlohmann::json::parse(output::watching_update(going_on(run), {})).at("film").is_null());
}

}  // namespace watching_test
