#include "apps/drawing/colours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace ink_test {

using output::Ink;
using specimen::Rgb;

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

}  // namespace ink_test
