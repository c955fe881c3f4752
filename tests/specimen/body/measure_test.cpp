#include "specimen/body/measure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/specimen/drawn.hpp"

namespace measure_test {

using specimen::Inclusion;
using specimen::measure_inclusions;
using specimen::Point;
using specimen::Raster;
using std::numbers::pi;

constexpr double d = 0.5e-3;

/// Pixels whose centre lies in the ellipse.
Raster<std::int32_t> draw_ellipse(int rows, int cols, double x, double y, double a, double b, double angle) {
  Raster<std::int32_t> ids(rows, cols, 0);
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < cols; ++c) {
      const double px = (c + 0.5) * d - x, py = (rows - r - 0.5) * d - y;
      const double u = px * std::cos(angle) + py * std::sin(angle),
                   v = -px * std::sin(angle) + py * std::cos(angle);
      if (u * u / (a * a) + v * v / (b * b) <= 1) ids(r, c) = 1;
    }
  return ids;
}

double polygon_area(const std::vector<Point>& p) {
  double twice = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point q = p[(i + 1) % p.size()];
    twice += p[i].x * q.y - q.x * p[i].y;
  }
  return twice / 2;
}

TEST(Measure, FindsTheEllipseThatWasDrawn) {
  for (const double angle : {0.0, 0.4, 1.2, 2.0, 3.0}) {
    const double x = 41.3e-3, y = 33.1e-3, a = 20e-3, b = 11e-3;
    const auto found = measure_inclusions(draw_ellipse(140, 170, x, y, a, b, angle), d);
    ASSERT_EQ(found.size(), 1U);
    const Inclusion& i = found.front();
    EXPECT_EQ(i.id, 1);
    EXPECT_NEAR(i.ellipse.x, x, 0.1 * d);
    EXPECT_NEAR(i.ellipse.y, y, 0.1 * d);
    EXPECT_NEAR(i.ellipse.a / a, 1, 0.005);
    EXPECT_NEAR(i.ellipse.b / b, 1, 0.005);
    EXPECT_NEAR(std::remainder(i.orientation - angle, pi), 0, 0.01);
    EXPECT_EQ(i.orientation, i.ellipse.angle);
    EXPECT_NEAR(i.area / (pi * a * b), 1, 0.005);
    EXPECT_NEAR(pi * i.ellipse.a * i.ellipse.b / i.area, 1, 1e-12);
    EXPECT_NEAR(i.equivalent_diameter, 2 * std::sqrt(a * b), 0.1 * d);
    const double h = (a - b) * (a - b) / ((a + b) * (a + b));  // Ramanujan's perimeter
    EXPECT_NEAR(i.perimeter / (pi * (a + b) * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h)))), 1, 0.02);
  }
}

TEST(Measure, PerimeterIsRightOnAverageOverDirections) {
  double sum = 0;
  const int directions = 24;
  for (int k = 0; k < directions; ++k)
    sum += measure_inclusions(draw_ellipse(200, 200, 50e-3, 50e-3, 40e-3, 2.5e-3, k * pi / directions), d)
               .front()
               .perimeter;
  const double a = 40e-3, b = 2.5e-3, h = (a - b) * (a - b) / ((a + b) * (a + b));
  EXPECT_NEAR(sum / directions / (pi * (a + b) * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h)))), 1, 0.02);
}

TEST(Measure, TheContourRunsCounterClockwiseAlongTheRim) {
  const Inclusion i = measure_inclusions(draw_ellipse(90, 90, 20e-3, 22e-3, 15e-3, 10e-3, 0.5), d).front();
  EXPECT_NEAR(polygon_area(i.contour) / i.area, 1, 0.01);
  for (const Point p : i.contour) {
    const double u = (p.x - 20e-3) * std::cos(0.5) + (p.y - 22e-3) * std::sin(0.5);
    const double v = -(p.x - 20e-3) * std::sin(0.5) + (p.y - 22e-3) * std::cos(0.5);
    EXPECT_NEAR(std::hypot(u / 15e-3, v / 10e-3), 1, 0.08);
  }
}

TEST(Measure, RowZeroIsTheTopOfTheSpecimen) {
  Raster<std::int32_t> ids(10, 20, 0);
  ids(0, 3) = 1;
  const Inclusion i = measure_inclusions(ids, d).front();
  EXPECT_DOUBLE_EQ(i.ellipse.x, 3.5 * d);
  EXPECT_DOUBLE_EQ(i.ellipse.y, 9.5 * d);
  EXPECT_EQ(i.contour.size(), 4U);
  EXPECT_DOUBLE_EQ(i.area, d * d);
  EXPECT_EQ(i.orientation, 0);
}

TEST(Measure, TheContourGoesRoundEveryPieceAndPastCorners) {
  Raster<std::int32_t> ids(6, 6, 0);
  ids(0, 0) = 1;
  for (int r = 1; r < 4; ++r)
    for (int c = 1; c < 4; ++c) ids(r, c) = 1;  // touches the first one at a corner
  ids(5, 5) = 2;
  const auto found = measure_inclusions(ids, 1);
  ASSERT_EQ(found.size(), 2U);
  const auto loops = specimen::loops_of(found[0].contour);
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_EQ(loops[0].size(), 12U);  // the larger one first
  EXPECT_EQ(loops[1].size(), 4U);
  EXPECT_EQ(found[0].area, 10);
}

/// A thick ring, and a grain in two pieces.
TEST(Measure, HolesAndPiecesAreInTheOutlineAndItsArea) {
  Raster<std::int32_t> ids(80, 130, 0);
  specimen_test::draw_disc(ids, 40, 40, 30, 1);
  specimen_test::draw_disc(ids, 40, 40, 15, 0);
  specimen_test::draw_disc(ids, 20, 100, 10, 2);
  specimen_test::draw_disc(ids, 60, 100, 14, 2);
  specimen_test::draw_disc(ids, 60, 100, 5, 0);
  specimen_test::draw_disc(ids, 60, 95, 2, 0);
  const auto found = measure_inclusions(ids, 1);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(specimen::loops_of(found[0].contour).size(), 2U);
  EXPECT_EQ(specimen::loops_of(found[1].contour).size(), 3U);
  for (const Inclusion& i : found) EXPECT_NEAR(polygon_area(i.contour), i.area, 0.01 * i.area);
  EXPECT_NEAR(found[0].perimeter, 2 * pi * (30 + 15), 0.03 * 2 * pi * 45);
}

TEST(Measure, NothingIsNothing) { EXPECT_TRUE(measure_inclusions(Raster<std::int32_t>(3, 3, 0), d).empty()); }

TEST(Notes, FiguresReadWell) {
  EXPECT_EQ(specimen::grouped(0), "0");
  EXPECT_EQ(specimen::grouped(999), "999");
  EXPECT_EQ(specimen::grouped(1234567), "1,234,567");
  EXPECT_EQ(specimen::grouped(-123456), "-123,456");
  EXPECT_EQ(specimen::counted(1, "island"), "1 island");
  EXPECT_EQ(specimen::counted(1234, "island"), "1,234 islands");
  EXPECT_EQ(specimen::counted(3, "class"), "3 classes");
  EXPECT_EQ(specimen::share_text(32, 1000), "3.2 %");
  EXPECT_EQ(specimen::share_text(4, 100000), "0.004 %");
  EXPECT_EQ(specimen::share_text(0, 10), "0 %");
  EXPECT_EQ(specimen::length_text(0.5e-3), "0.5 mm");
  EXPECT_EQ(specimen::area_text(2.5e-6), "2.5 mm2");
  EXPECT_EQ(specimen::short_number(0.1 + 0.2), "0.3");
}

}  // namespace measure_test
