#include "apps/drawing/colours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "specimen/picture/image_colour.hpp"

namespace colours_test {

using output::ColourScale;
using output::scale_of;
using specimen::Rgb;
using Triple = std::array<double, 3>;
using output::Ink;

/// By the specimen library, that is by OpenCV: L* in [0, 100].
Triple lab_of(Rgb colour) {
  specimen::Raster<Rgb> one(1, 1, colour);
  const specimen::Lab lab = specimen::to_lab(one).data.front();
  return {lab.l(), lab.a(), lab.b()};
}

double distance(Rgb a, Rgb b) {
  const Triple left = lab_of(a), right = lab_of(b);
  return std::hypot(left[0] - right[0], left[1] - right[1], left[2] - right[2]);
}

double lightness(Rgb colour) { return lab_of(colour)[0]; }

/// As an eye without red, green or blue cones has it.   Source: Machado, Oliveira, Fernandes (2009),
/// severity 1.
using Matrix = std::array<Triple, 3>;
constexpr Matrix protan{
    {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix deutan{
    {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
constexpr Matrix tritan{
    {{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}};

Rgb seen_by(const Matrix& eye, Rgb colour) {
  const Triple linear{std::pow(colour.r / 255.0, 2.2), std::pow(colour.g / 255.0, 2.2),
                      std::pow(colour.b / 255.0, 2.2)};
  std::array<std::uint8_t, 3> seen{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double light = eye[k][0] * linear[0] + eye[k][1] * linear[1] + eye[k][2] * linear[2];
    seen[k] = static_cast<std::uint8_t>(std::lround(255 * std::pow(std::clamp(light, 0.0, 1.0), 1 / 2.2)));
  }
  return {seen[0], seen[1], seen[2]};
}

TEST(ColourScale, GoesThroughTheControlColours) {
  const ColourScale scale{-2, 2};
  EXPECT_EQ(scale(-2), (Rgb{0x2c, 0x7b, 0xb6}));
  EXPECT_EQ(scale(0), (Rgb{0xff, 0xff, 0xbf}));
  EXPECT_EQ(scale(2), (Rgb{0xd7, 0x19, 0x1c}));
  for (const Rgb inner : {Rgb{0xfd, 0xae, 0x61}, Rgb{0xab, 0xd9, 0xe9}}) {
    double least = 1000;
    for (double x = -2; x <= 2; x += 0.005) least = std::min(least, distance(scale(x), inner));
    EXPECT_LT(least, 2);
  }
}

TEST(ColourScale, EqualStepsAreEqualForTheEye) {
  const ColourScale scale{-1, 1};
  for (const double from : {-1.0, 0.0}) {
    std::vector<double> steps;
    for (int i = 0; i < 16; ++i)
      steps.push_back(distance(scale(from + i / 16.0), scale(from + (i + 1) / 16.0)));
    const auto [least, most] = std::minmax_element(steps.begin(), steps.end());
    EXPECT_GT(*least, 0.6 * *most) << "a straight way through sRGB has steps of a fourth of others";
  }
}

TEST(ColourScale, DarkensToEndsThatAreAboutEquallyDark) {
  const ColourScale scale{-1, 1};
  for (double x = 0.05; x <= 1; x += 0.05) {
    EXPECT_LT(lightness(scale(x)), lightness(scale(x - 0.05)));
    EXPECT_LT(lightness(scale(-x)), lightness(scale(0.05 - x)) + 1);
  }
  EXPECT_NEAR(lightness(scale(-1)), lightness(scale(1)), 5);
  EXPECT_GT(distance(scale(-1), {0, 0, 0}), 50) << "cracks are black";
  for (double x = -1; x <= 1; x += 0.01)
    EXPECT_GT(distance(scale(x), {255, 255, 255}), 15) << "voids are white";
}

TEST(ColourScale, TellsTheSignToColourBlindEyes) {
  const ColourScale scale{-1, 1};
  for (const Matrix& eye : {protan, deutan, tritan})
    for (const double x : {0.25, 0.5, 0.75, 1.0})
      EXPECT_GT(distance(seen_by(eye, scale(x)), seen_by(eye, scale(-x))), 25) << x;
}

TEST(ColourScale, OfOneSignHasTheColoursOfThatSign) {
  const ColourScale both{-3, 3};
  const ColourScale above{0, 3}, below{-3, 0};
  EXPECT_EQ(above(1.7), both(1.7));
  EXPECT_EQ(below(-1.7), both(-1.7));
  const ColourScale high{2, 4}, low{-4, -2};
  EXPECT_EQ(high(2), both(0));
  EXPECT_EQ(high(4), both(3));
  EXPECT_EQ(low(-4), both(-3));
  EXPECT_EQ(low(-2), both(0));
}

TEST(ColourScale, ThatIsNotEvenKeepsItsStepsEven) {
  const ColourScale scale{-1, 3};
  EXPECT_EQ(scale(-1), (ColourScale{-3, 3}(-1)));
  EXPECT_EQ(scale(3), (ColourScale{-3, 3}(3)));
}

TEST(ColourScale, WhatLiesBeyondHasTheColourOfTheEnd) {
  const ColourScale scale{-1, 2};
  EXPECT_EQ(scale(1e300), scale(2));
  EXPECT_EQ(scale(-1e300), scale(-1));
}

/// -below ... above in equal steps, and two values far out.
std::vector<double> ramp(double below, double above) {
  std::vector<double> values{-1e6 * below, 1e6 * above};
  for (int i = 0; i <= 1000; ++i) values.push_back(-below + i * (above + below) / 1000);
  return values;
}

void expect_ends(const ColourScale& scale, double low, double high) {
  EXPECT_DOUBLE_EQ(scale.low, low);
  EXPECT_DOUBLE_EQ(scale.high, high);
}

TEST(ScaleOf, HasRoundEndsThatLeaveOutTheOutermost) {
  expect_ends(scale_of(ramp(4.7, 4.7)), -5, 5);
  expect_ends(scale_of(ramp(1, 3.3)), -4, 4);
  expect_ends(scale_of(ramp(0, 0.12)), 0, 0.15);
  expect_ends(scale_of(ramp(88, 0)), -100, 0);
}

TEST(ScaleOf, BeginsAtZeroWhereOneSignIsTooSmallToMatter) {
  expect_ends(scale_of(ramp(0.3, 5)), 0, 5);
  expect_ends(scale_of(ramp(0.9, 5)), -5, 5);
  expect_ends(scale_of(ramp(5, 0.3)), -5, 0);
}

TEST(ScaleOf, KnowsFewValuesAndNone) {
  expect_ends(scale_of({}), 0, 1);
  expect_ends(scale_of({0, 0, 0}), 0, 1);
  expect_ends(scale_of({-2.1}), -2.5, 0);
}

/// Source: WCAG 2.1, relative luminance.
double luminance(Rgb colour) {
  const auto linear = [](std::uint8_t channel) {
    const double c = channel / 255.0;
    return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour.r) + 0.7152 * linear(colour.g) + 0.0722 * linear(colour.b);
}

double contrast(Rgb a, Rgb b) {
  const double first = luminance(a) + 0.05, second = luminance(b) + 0.05;
  return std::max(first, second) / std::min(first, second);
}

TEST(Ink, CanBeReadOnBothPapers) {
  const Rgb light{255, 255, 255}, dark{0x14, 0x18, 0x1c};
  for (const Ink ink : output::all_inks) {
    const bool is_text = ink == Ink::text || ink == Ink::muted;
    const double least = ink == Ink::grid ? 1.1 : is_text ? 4.5 : 3;
    EXPECT_GE(contrast(output::on_light_paper(ink), light), least) << output::name_of(ink);
    EXPECT_GE(contrast(output::on_dark_paper(ink), dark), least) << output::name_of(ink);
  }
}

TEST(Ink, HasANameEach) {
  std::set<std::string_view> names;
  for (const Ink ink : output::all_inks) names.insert(output::name_of(ink));
  EXPECT_EQ(names.size(), output::all_inks.size());
  EXPECT_FALSE(names.contains(""));
}

TEST(Ink, IsWrittenInHexadecimal) { EXPECT_EQ(output::hex({0, 0x0a, 0xff}), "#000aff"); }

}  // namespace colours_test
