#include "apps/scene/stroke_list.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/refusal.hpp"

namespace stroke_list_test {

using ::testing::HasSubstr;

std::string complaint_about(const std::string& text, const std::string& path = "s.csv") {
  try {
    (void)app::parse_stroke_list(text, path);
    return "accepted";
  } catch (const app::Rejected& rejected) {
    EXPECT_EQ(rejected.code, app::Exit::data);
    return rejected.what();
  }
}

TEST(StrokeList, RowsOfATableAreThePointsOfTheirStrokes) {
  const auto lines = app::parse_stroke_list(
      "# two of them\nphase,stroke,x_px,y_px,width_px\nmortar,1,10,20.5,9\nmortar,1,30,20.5,9\ncut,2,5,6,1\n",
      "s.csv");
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].phase, "mortar");
  EXPECT_EQ(lines[0].width, 9);
  EXPECT_EQ(lines[0].points, (std::vector<std::pair<double, double>>{{10, 20.5}, {30, 20.5}}));
  EXPECT_EQ(lines[0].where, "s.csv: stroke 1");
  EXPECT_EQ(lines[1].phase, "cut");
  EXPECT_EQ(app::parse_stroke_list("stroke,phase,x_px,y_px\n1,void,1,2\n", "S.CSV")[0].width, 3);
}

TEST(StrokeList, MistakesOfATableAreNamedWithTheirPlace) {
  EXPECT_EQ(complaint_about("stroke,phase,x_mm,y_px\n1,void,1,2\n"),
            "s.csv:1:14: x_mm: unknown column; write the header stroke,phase,width_px,x_px,y_px");
  EXPECT_THAT(complaint_about("stroke,phase,x_px\n"), HasSubstr("y_px: column missing"));
  EXPECT_THAT(complaint_about("stroke,phase,x_px,y_px\n1,void,one,2\n"), HasSubstr("s.csv:2:8: x_px"));
  EXPECT_THAT(complaint_about("stroke,phase,x_px,y_px\n1,a phase,1,2\n"),
              HasSubstr("must be the name of a phase"));
  EXPECT_EQ(complaint_about("stroke,phase,x_px,y_px\n1,void,1,2\n1,mortar,1,2\n"),
            "s.csv:3:1: phase: mortar; stroke 1 began as void; give each stroke a number of its own");
  EXPECT_EQ(complaint_about("stroke,phase,width_px,x_px,y_px\n1,void,3,1,2\n1,void,5,1,2\n"),
            "s.csv:3:1: width_px: 5; stroke 1 began with 3; give each stroke a number of its own");
  EXPECT_THAT(complaint_about("stroke,phase,x_px,y_px\n"), HasSubstr("no strokes"));
}

TEST(StrokeList, FeaturesAreStrokes) {
  const auto lines = app::parse_stroke_list(
      R"({"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {"phase": "mortar", "width": 5},
         "geometry": {"type": "LineString", "coordinates": [[1, 2], [3, 4]]}},
        {"type": "Feature", "properties": {"classification": {"name": "Aggregate"}},
         "geometry": {"type": "MultiLineString", "coordinates": [[[1, 2], [3, 4]], [[7, 8]]]}},
        {"type": "Feature", "properties": {"phase": "void"},
         "geometry": {"type": "MultiPoint", "coordinates": [[9, 9], [8, 8]]}}]})",
      "s.geojson");
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_EQ(lines[0].width, 5);
  EXPECT_EQ(lines[1].phase, "aggregate");
  EXPECT_EQ(lines[2].points.size(), 1U);
  EXPECT_EQ(lines[4].points[0].first, 8);
  EXPECT_EQ(lines[4].where, "s.geojson: feature 3");
}

TEST(StrokeList, MistakesOfFeaturesAreNamed) {
  const auto about = [](const std::string& text) { return complaint_about(text, "s.json"); };
  EXPECT_EQ(about("{"), "s.json: is no JSON; strokes are GeoJSON, CSV or a picture");
  EXPECT_EQ(about("[3]"), "s.json: feature 1: no geometry; must be a feature with a line");
  EXPECT_EQ(about(R"([{"geometry": {"type": "Point", "coordinates": [1, 2]}}])"),
            "s.json: feature 1: no phase; its property phase must be the name of a phase: letters, digits, _ "
            "and -");
  const auto with = [&](const std::string& geometry) {
    return about(R"([{"properties": {"phase": "void"}, "geometry": )" + geometry + "}]");
  };
  EXPECT_THAT(with(R"({"type": "Polygon", "coordinates": []})"),
              HasSubstr("feature 1: Polygon; strokes are of type"));
  EXPECT_THAT(with(R"({"type": "LineString", "coordinates": [[1]]})"),
              HasSubstr("[1]; a position must be [x, y] in pixels"));
  EXPECT_THAT(with(R"({"type": "LineString"})"), HasSubstr("coordinates must be a list"));
  EXPECT_THAT(
      about(
          R"([{"properties": {"phase": "void", "width": "x"}, "geometry": {"type": "Point", "coordinates": [1, 2]}}])"),
      HasSubstr("its property width must be a number of pixels"));
  EXPECT_THAT(about("[]"), HasSubstr("no strokes"));
  EXPECT_THAT(about(R"([{"properties": {"classification": {"name": 3}}, "geometry": {}}])"),
              HasSubstr("feature 1: no phase"));
  EXPECT_THAT(about(std::string(33, '[') + std::string(33, ']')), HasSubstr("brackets deeper than 32"));
  EXPECT_THAT(
      about(R"([{"properties": {"phase": "[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[["}, "geometry": {}}])"),
      HasSubstr("must be the name of a phase"));
}

TEST(StrokeList, WrittenLinesAreReadAsTheSame) {
  const std::vector<specimen::StrokeLine> lines{{"mortar", 2.5, {{1, 2}, {3.25, 1.0 / 3}}},
                                                {"one-grain", 3, {{7, 8}}},
                                                {"mortar", 1, {{0, 0}, {0.1, 1e-7}}}};
  const auto again = app::parse_stroke_list(app::stroke_list_text(lines), "s.csv");
  ASSERT_EQ(again.size(), lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(again[i].phase, lines[i].phase);
    EXPECT_EQ(again[i].width, lines[i].width);
    EXPECT_EQ(again[i].points, lines[i].points);
  }
}

}  // namespace stroke_list_test
