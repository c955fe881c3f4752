#include "apps/drawing/colours.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "apps/drawing/ticks.hpp"

namespace output {

using specimen::Rgb;

namespace {

/// An ink by its name, and what it looks like on both papers.
struct Look {
  std::string_view name;
  Rgb on_light, on_dark;
};

const Look& look_of(Ink ink) {
  static constexpr std::array<Look, all_inks.size()> looks{
      {{"text", {0x1c, 0x20, 0x24}, {0xe6, 0xe8, 0xea}},
       {"muted", {0x5a, 0x62, 0x6a}, {0xa0, 0xa8, 0xb0}},
       {"grid", {0xe4, 0xe7, 0xea}, {0x2c, 0x32, 0x38}},
       {"axis", {0x8a, 0x92, 0x9a}, {0x70, 0x78, 0x80}},
       {"first", {0x00, 0x60, 0xa8}, {0x5a, 0xb4, 0xf0}},
       {"second", {0xc8, 0x4b, 0x00}, {0xf5, 0x95, 0x50}},
       {"third", {0x00, 0x80, 0x60}, {0x2c, 0xc4, 0x9c}},
       {"fourth", {0xa8, 0x4a, 0x86}, {0xe0, 0x94, 0xc4}},
       {"fifth", {0x7a, 0x6a, 0x2c}, {0xd8, 0xc4, 0x70}}}};
  return looks[static_cast<std::size_t>(ink)];
}

}  // namespace

Rgb on_light_paper(Ink ink) { return look_of(ink).on_light; }

Rgb on_dark_paper(Ink ink) { return look_of(ink).on_dark; }

std::string_view name_of(Ink ink) { return look_of(ink).name; }

Ink ink_of_series(std::size_t number) {
  constexpr auto first = static_cast<std::size_t>(Ink::first);
  return all_inks[first + number % series_inks];
}

std::string hex(Rgb colour) { return fmt::format("#{:02x}{:02x}{:02x}", colour.r, colour.g, colour.b); }

namespace {

/// Control colours: the five classes of RdYlBu, from below zero to above it. It stays apart for colour-blind
/// eyes; its ends are about equally dark, and not so dark that black is lost on them; nothing in it is near
/// white, as are the inner classes of the maps with more. Source: Harrower and Brewer (2003),
/// ColorBrewer.org.
constexpr std::array<Rgb, 5> controls{
    {{0x2c, 0x7b, 0xb6}, {0xab, 0xd9, 0xe9}, {0xff, 0xff, 0xbf}, {0xfd, 0xae, 0x61}, {0xd7, 0x19, 0x1c}}};

/// A colour in CIELAB, where distances are about those that the eye sees.
using Lab = std::array<double, 3>;

/// Source: IEC 61966-2-1 (sRGB), CIE 15 (CIELAB, white D65).
namespace srgb {

constexpr std::array<double, 3> white{0.95047, 1, 1.08883};
constexpr double kink = 6.0 / 29;

double linear(std::uint8_t channel) {
  const double c = channel / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

std::uint8_t channel(double linear) {
  const double c = std::clamp(linear, 0.0, 1.0);
  const double coded = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * coded));
}

Lab to_lab(Rgb colour) {
  const double r = linear(colour.r), g = linear(colour.g), b = linear(colour.b);
  const auto root = [](double share) {
    return share > kink * kink * kink ? std::cbrt(share) : share / (3 * kink * kink) + 4.0 / 29;
  };
  const double x = root((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / white[0]);
  const double y = root((0.2126729 * r + 0.7151522 * g + 0.0721750 * b) / white[1]);
  const double z = root((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / white[2]);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Rgb from_lab(const Lab& lab) {
  const auto cube = [](double root) {
    return root > kink ? root * root * root : 3 * kink * kink * (root - 4.0 / 29);
  };
  const double level = (lab[0] + 16) / 116;
  const double x = white[0] * cube(level + lab[1] / 500);
  const double y = white[1] * cube(level);
  const double z = white[2] * cube(level - lab[2] / 200);
  return {channel(3.2404542 * x - 1.5371385 * y - 0.4985314 * z),
          channel(-0.9692660 * x + 1.8760108 * y + 0.0415560 * z),
          channel(0.0556434 * x - 0.2040259 * y + 1.0572252 * z)};
}

}  // namespace srgb

/// The way from the middle to an end, at the same pace for the eye throughout.
class Branch {
 public:
  static constexpr int middle = static_cast<int>(controls.size()) / 2;
  static constexpr std::size_t knots = middle + 1;

  /// @param step  +1 to the end above zero, -1 to the one below.
  explicit Branch(int step) {
    for (std::size_t i = 0; i < knots; ++i)
      lab_[i] = srgb::to_lab(controls[static_cast<std::size_t>(middle + step * static_cast<int>(i))]);
    for (std::size_t i = 1; i < knots; ++i)
      length_[i] = length_[i - 1] + std::hypot(lab_[i][0] - lab_[i - 1][0], lab_[i][1] - lab_[i - 1][1],
                                               lab_[i][2] - lab_[i - 1][2]);
  }

  /// @param share  of the way, in [0, 1].
  [[nodiscard]] Rgb at(double share) const {
    const double wanted = share * length_.back();
    std::size_t next = 1;
    while (next + 1 < knots && length_[next] < wanted) ++next;
    const double t = (wanted - length_[next - 1]) / (length_[next] - length_[next - 1]);
    Lab lab;
    for (std::size_t k = 0; k < 3; ++k) lab[k] = lab_[next - 1][k] + t * (lab_[next][k] - lab_[next - 1][k]);
    return srgb::from_lab(lab);
  }

 private:
  std::array<Lab, knots> lab_{};
  std::array<double, knots> length_{};  ///< of the way to each knot
};

double percentile(std::vector<double>& values, double share) {
  const auto place = static_cast<std::ptrdiff_t>(std::lround(share * static_cast<double>(values.size() - 1)));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

}  // namespace

Rgb ColourScale::operator()(double value) const {
  static const Branch warm(1);
  static const Branch cool(-1);
  const double middle = std::clamp(0.0, low, high);
  const double reach = std::max(high - middle, middle - low);
  const double share = (std::clamp(value, low, high) - middle) / reach;
  return share < 0 ? cool.at(-share) : warm.at(share);
}

ColourScale scale_of(std::vector<double> values) {
  if (values.empty()) return {0, 1};
  const double above = std::max(percentile(values, 0.99), 0.0);
  const double below = std::max(-percentile(values, 0.01), 0.0);
  if (above == 0 && below == 0) return {0, 1};
  const double most = rounded_up(std::max(above, below), {1, 1.5, 2, 2.5, 3, 4, 5, 6, 8});
  if (below < 0.1 * above) return {0, most};
  if (above < 0.1 * below) return {-most, 0};
  return {-most, most};
}

}  // namespace output
