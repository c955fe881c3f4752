#include "apps/scene/ellipse_list.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/apps/refusal.hpp"
#include "tests/damaged.hpp"

namespace ellipse_list_test {

std::vector<specimen::Ellipse> parse(const std::string& text) {
  return app::parse_ellipse_list(text, "list.csv");
}

std::string complaint_about(const std::string& text) {
  try {
    (void)parse(text);
    return "accepted";
  } catch (const app::Rejected& rejected) {
    EXPECT_EQ(rejected.code, app::Exit::data);
    return rejected.what();
  }
}

TEST(EllipseList, ReadsColumnsInAnyOrderAndUnit) {
  const auto ellipses = parse(
      "# two of them\r\nangle_deg, a_mm,b_mm ,x_m,y_um\r\n90,10,8,0.02,30000\r\n\r\n0,5,5,.05,30000\r\n");
  ASSERT_EQ(ellipses.size(), 2u);
  EXPECT_EQ(ellipses[0].a, 10e-3);
  EXPECT_EQ(ellipses[0].b, 8e-3);
  EXPECT_EQ(ellipses[0].x, 0.02);
  EXPECT_EQ(ellipses[0].y, 0.03);
  EXPECT_EQ(ellipses[0].angle, 90 * (std::numbers::pi / 180));
}

TEST(EllipseList, TheAngleMayBeMissing) { EXPECT_EQ(parse("x_mm,y_mm,a_mm,b_mm\n1,2,4,3")[0].angle, 0); }

TEST(EllipseList, PassesOverAByteOrderMark) {
  EXPECT_EQ(parse("\xEF\xBB\xBFx_mm,y_mm,a_mm,b_mm\n1,2,4,3\n").size(), 1u);
}

TEST(EllipseList, NamesWhatIsWrongWithTheHeader) {
  EXPECT_EQ(complaint_about("1,2,4,3\n"),
            "list.csv:1:1: 1: unknown column; write a header such as x_mm,y_mm,a_mm,b_mm,angle_deg\n"
            "list.csv:1:3: 2: unknown column; write a header such as x_mm,y_mm,a_mm,b_mm,angle_deg\n"
            "list.csv:1:5: 4: unknown column; write a header such as x_mm,y_mm,a_mm,b_mm,angle_deg\n"
            "list.csv:1:7: 3: unknown column; write a header such as x_mm,y_mm,a_mm,b_mm,angle_deg");
  EXPECT_EQ(
      complaint_about("x_mm,y,a_mm,b_mm\n"),
      "list.csv:1:6: y: needs the unit of length; write a header such as x_mm,y_mm,a_mm,b_mm,angle_deg");
  EXPECT_EQ(complaint_about("x_mm,y_mm,a_mm\n"),
            "list.csv:1:1: b: column missing; write a header such as x_mm,y_mm,a_mm,b_mm,angle_deg");
  EXPECT_EQ(complaint_about("x_mm,x_mm,y_mm,a_mm,b_mm\n"), "list.csv:1:6: x: column given twice; remove one");
  EXPECT_EQ(complaint_about(""), "list.csv: no header; write a header such as x_mm,y_mm,a_mm,b_mm,angle_deg");
  EXPECT_EQ(complaint_about("x_mm,y_mm,a_mm,b_mm\n"), "list.csv: no ellipses; give one a line");
}

TEST(EllipseList, NamesEveryBadRow) {
  EXPECT_EQ(
      complaint_about("x_mm,y_mm,a_mm,b_mm\n1,2,4\n1,two,4,3\n1,nan,4,3\n1,2,3,4\n1,2,4,0\n1 mm,2,4,3\n"),
      "list.csv:2:1: row: 3 cells; the header has 4\n"
      "list.csv:3:3: y: \"two\"; must be a number, its unit is in the header\n"
      "list.csv:4:3: y: \"nan\"; must be a number, its unit is in the header\n"
      "list.csv:5:1: ellipse 1: its semi-axes a = 3 mm and b = 4 mm must obey a >= b; swap them and add 90 "
      "deg "
      "to the angle\n"
      "list.csv:6:1: ellipse 1: its short semi-axis b = 0 m must be > 0\n"
      "list.csv:7:1: x: \"1 mm\"; must be a number, its unit is in the header");
}

TEST(EllipseList, DamagedIsReadOrRefused) {
  const std::string good =
      "\xEF\xBB\xBFx_mm, y_mm,a_mm,b_mm,angle_deg\r\n# two of them\n10,12,4,3,30\n25,2e1,5.5,2,-10\n";
  std::size_t refused = 0;
  test::damage_text(good, [&](const std::string& text) {
    refused += test::refusal([&] { (void)app::parse_ellipse_list(text, "list.csv"); }) == "nothing" ? 0 : 1;
  });
  EXPECT_GT(refused, 5 * good.size());
}

TEST(EllipseList, GoesNoFurtherWhereNobodyReadsOn) {
  std::string text = "x_mm,y_mm,a_mm,b_mm\n";
  for (int i = 0; i < 5000; ++i) text += "1,2,3,x\n";
  try {
    (void)app::parse_ellipse_list(text, "list.csv");
    FAIL() << "it was read";
  } catch (const app::Rejected& rejected) {
    EXPECT_EQ(rejected.complaints.size(), app::most_complaints);
  }
}

TEST(EllipseList, AMissingFileIsAMatterOfTheDisk) {
  try {
    (void)app::read_ellipse_list("no/such/list.csv");
    FAIL();
  } catch (const app::Rejected& rejected) {
    EXPECT_EQ(rejected.code, app::Exit::io);
    EXPECT_STREQ(rejected.what(),
                 "no/such/list.csv: No such file or directory; must be a file that can be read");
  }
}

}  // namespace ellipse_list_test
