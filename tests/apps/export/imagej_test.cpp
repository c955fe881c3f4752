#include "apps/export/imagej.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <numbers>

#include "specimen/body/error.hpp"
#include "tests/apps/export/small_mask.hpp"

namespace imagej_test {

using specimen::Point;
using testing::HasSubstr;
using testing::StartsWith;

std::uint32_t number(const std::string& bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value = value << 8 | static_cast<unsigned char>(bytes.at(at + i));
  return value;
}

float real(const std::string& bytes, std::size_t at) { return std::bit_cast<float>(number(bytes, at, 4)); }

/// Corners in pixels as the file tells them with fractions.
std::vector<Point> corners_in(const std::string& roi) {
  const std::size_t n = number(roi, 16, 2);
  std::vector<Point> corners;
  for (std::size_t k = 0; k < n; ++k)
    corners.push_back({static_cast<double>(real(roi, 64 + 4 * n + 4 * k)),
                       static_cast<double>(real(roi, 64 + 8 * n + 4 * k))});
  return corners;
}

/// 40 x 30 pixels of 0.5 mm.
specimen::LabelledMask mask() {
  return test::mask_of(std::vector<std::string>(30, std::string(40, '2')), 0.5e-3);
}

TEST(Roi, TellsAPolygonInPixelsFromTheTopLeftCorner) {
  const std::string roi = exchange::polygon_roi({{1e-3, 2e-3}, {3.25e-3, 2e-3}, {1e-3, 14.5e-3}}, mask());
  EXPECT_EQ(roi.size(), 64U + 12 * 3);
  EXPECT_EQ(roi.substr(0, 4), "Iout");
  EXPECT_EQ(number(roi, 4, 2), 228U);
  EXPECT_EQ(number(roi, 6, 1), 0U) << "a polygon";
  EXPECT_EQ(number(roi, 8, 2), 1U) << "top";
  EXPECT_EQ(number(roi, 10, 2), 2U) << "left";
  EXPECT_EQ(number(roi, 12, 2), 26U) << "bottom";
  EXPECT_EQ(number(roi, 14, 2), 7U) << "right";
  EXPECT_EQ(number(roi, 16, 2), 3U) << "corners";
  EXPECT_EQ(number(roi, 50, 2), 128U) << "with fractions";
  EXPECT_EQ(number(roi, 64, 2), 0U) << "x from the left of the box";
  EXPECT_EQ(number(roi, 66, 2), 5U) << "4.5, rounded";
  EXPECT_EQ(number(roi, 70, 2), 25U) << "y from the top of the box";
  const std::vector<Point> corners = corners_in(roi);
  EXPECT_EQ(corners[0], (Point{2, 26}));
  EXPECT_EQ(corners[1], (Point{6.5, 26}));
  EXPECT_EQ(corners[2], (Point{2, 1}));
}

TEST(Roi, FollowsAnExactEllipseWithinATwentiethOfAPixel) {
  specimen::Inclusion inclusion;
  inclusion.id = 12;
  inclusion.ellipse = {10e-3, 7e-3, 5e-3, 2e-3, std::numbers::pi / 6};
  const auto rois = exchange::inclusion_rois({inclusion}, mask());
  ASSERT_EQ(rois.size(), 1U);
  EXPECT_EQ(rois[0].name, "inclusion_0012.roi");
  const std::vector<Point> corners = corners_in(rois[0].bytes);
  double twice_area = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Point p = corners[k], q = corners[(k + 1) % corners.size()];
    twice_area += p.y * q.x - p.x * q.y;  // y points down
    const double x = 0.5e-3 * p.x - 10e-3, y = (30 - p.y) * 0.5e-3 - 7e-3;
    const double c = std::cos(std::numbers::pi / 6), s = std::sin(std::numbers::pi / 6);
    EXPECT_NEAR(std::hypot((c * x + s * y) / 5e-3, (c * y - s * x) / 2e-3), 1, 1e-5);
  }
  const double exact = std::numbers::pi * 10 * 4;  // [pixels^2]
  EXPECT_LT(0.5 * twice_area, exact);
  EXPECT_GT(0.5 * twice_area, exact - 0.05 * 2 * std::numbers::pi * 10);
}

TEST(Roi, TakesTheContourWhereThereIsOne) {
  specimen::Inclusion inclusion;
  inclusion.contour = {{0, 0}, {1e-3, 0}, {1e-3, 1e-3}, {0, 1e-3}};
  EXPECT_EQ(corners_in(exchange::inclusion_rois({inclusion}, mask())[0].bytes),
            (std::vector<Point>{{0, 30}, {2, 30}, {2, 28}, {0, 28}}));
}

TEST(Roi, KeepsTheNumberOfVeryManyCornersWhereItHasRoom) {
  const std::string roi = exchange::polygon_roi(std::vector<Point>(70'000, Point{1e-3, 1e-3}), mask());
  EXPECT_EQ(number(roi, 16, 2), 0U);
  EXPECT_EQ(number(roi, 18, 4), 70'000U);
}

TEST(InclusionTable, HasUnitsInItsHeaderAndALineAnInclusion) {
  specimen::Inclusion inclusion;
  inclusion.id = 7;
  inclusion.ellipse = {10e-3, 20.5e-3, 3e-3, 2e-3, std::numbers::pi / 6};
  inclusion.area = 18.75e-6;
  inclusion.perimeter = 16e-3;
  inclusion.equivalent_diameter = 4.9e-3;
  inclusion.orientation = std::numbers::pi / 4;
  EXPECT_EQ(exchange::inclusion_table({inclusion}),
            "id,x_mm,y_mm,a_mm,b_mm,angle_deg,area_mm2,perimeter_mm,equivalent_diameter_mm,orientation_deg\n"
            "7,10,20.5,3,2,30,18.75,16,4.9,45\n");
}

TEST(InclusionTable, OfNoneIsAHeader) {
  EXPECT_EQ(exchange::inclusion_table({}).find('\n'), exchange::inclusion_table({}).size() - 1);
}

const std::vector<exchange::NamedBytes> files{{"b.roi", std::string(500, 'x')}, {"a.roi", "second"}};

TEST(Zip, HoldsTheFilesByName) {
  const std::string archive = exchange::zipped("a.zip", files);
  EXPECT_THAT(archive, StartsWith("PK\x03\x04"));
  EXPECT_THAT(archive, HasSubstr("b.roi"));
  EXPECT_THAT(archive.substr(archive.find("b.roi")), HasSubstr("a.roi")) << "in their order";
  EXPECT_LT(archive.size(), 500U) << "compressed";
}

TEST(Zip, SaysNothingOfTheTime) {
  const std::string archive = exchange::zipped("a.zip", files);
  EXPECT_EQ(archive.substr(10, 4), std::string("\0\0\x21\0", 4)) << "midnight, 1 January 1980";
}

TEST(Zip, NamesTheFileThatItCannotMake) {
  try {
    (void)exchange::zipped("a.zip", {{"same", "1"}, {"same", "2"}});
    FAIL();
  } catch (const specimen::Error& error) {
    EXPECT_EQ(error.fault, specimen::Fault::write);
    EXPECT_STREQ(error.what(), "a.zip: cannot be written as ZIP: File already exists");
  }
}

}  // namespace imagej_test
