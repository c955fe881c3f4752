#include "apps/drawing/drawing_files.hpp"

#include <gtest/gtest.h>

namespace drawing_svg_test {

using namespace output;

TEST(Svg, WritesEachShape) {
  const Drawing drawing{
      100,
      50,
      "t",
      {Stroke{{{1, 2}, {3.25, 4}}, Ink::first, 2, true}, Dot{{5, 6}, 4, Ink::text},
       Words{{7, 8}, "w", 13, Anchor::end, Ink::muted}, Area{{{9, 8}, {7, 6}, {9, 4}}, {255, 128, 0}}}};
  EXPECT_EQ(
      svg_of(drawing),
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 100 50\" role=\"img\" aria-label=\"t\">\n"
      "<polyline class=\"stroke-first\" stroke-width=\"2\" stroke-dasharray=\"6 4\" points=\"1.0,2.0 "
      "3.2,4.0\"/>\n"
      "<circle class=\"fill-text\" cx=\"5.0\" cy=\"6.0\" r=\"4\"/>\n"
      "<text class=\"fill-muted\" x=\"7.0\" y=\"8.0\" font-size=\"13\" text-anchor=\"end\">w</text>\n"
      "<polygon points=\"9.0,8.0 7.0,6.0 9.0,4.0\" fill=\"#ff8000\"/>\n"
      "</svg>\n");
}

TEST(Svg, EscapesWords) {
  const std::string svg = svg_of({1, 1, "\"><script>", {Words{{0, 0}, "</text><script>"}}});
  EXPECT_EQ(svg.find("<script>"), std::string::npos);
}

}  // namespace drawing_svg_test
