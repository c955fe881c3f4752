#include "apps/report/report_data.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace chart_json_test {

using output::chart_json;
using output::inert_text;

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

}  // namespace chart_json_test
