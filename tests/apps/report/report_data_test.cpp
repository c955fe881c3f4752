#include "apps/report/report_data.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "tests/apps/fake_run.hpp"

namespace report_data_test {

using output::chart_json;
using output::deflated_base64;
using output::film_data;
using output::has_film;
using output::inert_text;
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

TEST(ChartJson, SaysWhatTheChartSays) {
  output::Chart chart{"Title", {"Strain", "%"}, {"Stress", "MPa", true}, {}, {}};
  chart.series.push_back({"line", {0, 1}, {2, 1.23456789}, output::Ink::second, true});
  chart.markers.push_back({1, 2, "here"});
  const auto json = chart_json(chart, {{"code", {0}, {1}}});
  EXPECT_EQ(json["x"]["label"], "Strain [%]");
  EXPECT_EQ(json["y"]["logarithmic"], true);
  EXPECT_EQ(json["series"][0]["ink"], "second");
  EXPECT_EQ(json["series"][0]["dashed"], true);
  EXPECT_DOUBLE_EQ(json["series"][0]["y"][1], 1.234568);
  EXPECT_EQ(json["markers"][0]["text"], "here");
  EXPECT_EQ(json["references"][0]["name"], "code");
}

TEST(ChartJson, NumbersThatAreNotFiniteLeaveAGap) {
  output::Chart chart{"Title", {"x", ""}, {"y", ""}, {}, {}};
  constexpr double infinity = std::numeric_limits<double>::infinity();
  chart.series.push_back({"", {0, 1, 2}, {infinity, std::numeric_limits<double>::quiet_NaN(), 1e-320}});
  const auto y = chart_json(chart)["series"][0]["y"];
  EXPECT_TRUE(y[0].is_null());
  EXPECT_TRUE(y[1].is_null());
  EXPECT_EQ(y[2], 1e-320);
}

TEST(ChartJson, InertTextEndsNoElement) {
  const nlohmann::ordered_json json = {{"</script>", "<b>&\xff"}};
  const std::string text = inert_text(json);
  EXPECT_EQ(text.find_first_of("<>&"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(text)["</script>"], "<b>&\xEF\xBF\xBD");
}

TEST(FilmData, CarriesWhatThePixelsAre) {
  const FakeRun run = tension_run(60);
  ASSERT_TRUE(has_film(run.record()));
  const auto film = film_data(run.record());
  EXPECT_EQ(film["rows"], 60);
  EXPECT_EQ(film["cols"], 60);
  EXPECT_DOUBLE_EQ(film["pixel_mm"], 2.5);
  EXPECT_EQ(film["phases"].size(), run.specimen.mask.phases.size());
  EXPECT_TRUE(film["phases"][0]["tensile_MPa"].is_null());  // voids
  EXPECT_DOUBLE_EQ(film["phases"][2]["tensile_MPa"], 1e-6 * run.scene.phases[2]->tensile_scale);
  EXPECT_TRUE(film["crush"].is_null());
  EXPECT_FALSE(film["strength"].is_null());
}

TEST(FilmData, HasCrushingWithCrackClosure) {
  EXPECT_FALSE(film_data(compression_run(60).record())["crush"].is_null());
}

TEST(FilmData, StrengthsAreLeftOutOfLargePictures) {
  const auto film = film_data(tension_run(720).record());  // 518,400 pixels
  EXPECT_TRUE(film["strength"].is_null());
  EXPECT_FALSE(film["failure"].is_null());
}

TEST(FilmData, ARunThatNeverBeganHasNone) { EXPECT_FALSE(has_film(still_run({"12", "32"}).record())); }

TEST(Deflate, IsTheFormatOfZlib) {
  // Of Python: base64.b64encode(zlib.compress(b"aaaaaaaaaa"))
  EXPECT_EQ(deflated_base64(std::string_view("aaaaaaaaaa")), "eJxLTIQBABThA8s=");
  EXPECT_EQ(deflated_base64(std::string_view()), "eJwDAAAAAAE=");
}

TEST(Deflate, TakesTheBytesOfArrays) {
  const std::vector<std::uint16_t> values{0x6161, 0x6161, 0x6161, 0x6161, 0x6161};
  EXPECT_EQ(deflated_base64(std::span<const std::uint16_t>(values)),
            deflated_base64(std::string_view("aaaaaaaaaa")));
}

}  // namespace report_data_test
