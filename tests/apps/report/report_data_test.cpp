#include "apps/report/report_data.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/apps/fake_run.hpp"

namespace report_data_test {

using output::report_data;

TEST(ReportData, HoldsTheChartsOfThePage) {
  const FakeRun run = tension_run(60);
  const auto data = nlohmann::json::parse(report_data(run.record()));
  EXPECT_EQ(data["strain"]["name"], "microstrain");
  const auto& stress = data["charts"]["stress"];
  const auto& line = stress["series"][0];
  ASSERT_EQ(line["y"].size(), run.result.history.size());
  const std::size_t middle = run.result.history.size() / 2;
  EXPECT_NEAR(line["y"][middle], 1e-6 * run.result.history[middle].stress, 1e-6);
  EXPECT_NEAR(line["x"][middle], 1e6 * run.result.history[middle].strain, 1e-4);
  EXPECT_EQ(stress["references"].size(), 2U);
  EXPECT_EQ(stress["markers"].size(), 1U);
  for (const char* id : {"energy", "failure", "failure-strain", "sieve"})
    EXPECT_TRUE(data["charts"].contains(id)) << id;
  EXPECT_FALSE(data["film"].is_null());
}

TEST(ReportData, CannotEndItsElement) {
  FakeRun run = tension_run(60);
  run.specimen.mask.phases[2] = "</script><script>alert('&')\xff";
  const std::string text = report_data(run.record());
  EXPECT_EQ(text.find_first_of("<>&"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(text)["film"]["phases"][2]["name"],
            "</script><script>alert('&')\xEF\xBF\xBD");
}

TEST(ReportData, NumbersThatAreNotFiniteLeaveAGap) {
  FakeRun run = tension_run(60);
  run.result.history[1].stress = std::numeric_limits<double>::quiet_NaN();
  const auto data = nlohmann::json::parse(report_data(run.record()));
  EXPECT_TRUE(data["charts"]["stress"]["series"][0]["y"][1].is_null());
}

}  // namespace report_data_test
