#include "specimen/convert/levels.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

#include "specimen/body/measure.hpp"

namespace specimen {

bool is_coloured(const Picture& picture) {
  const auto has_tint = [](Rgb c) { return c.r != c.g || c.g != c.b; };
  return picture.gray.empty() &&
         std::any_of(picture.colour.data.begin(), picture.colour.data.end(), has_tint);
}

namespace {

/// Bytes that were divided by 255, as programs that compute with fractions keep them, become bytes again.
void restore_bytes(Raster<double>& gray) {
  constexpr double white = 255, rounding = 1e-4;
  const auto is_fraction = [](double v) { return v > 0 && v < 1; };
  const auto is_byte = [](double v) {
    return std::isnan(v) || (v >= 0 && v <= 1 && std::abs(v * white - std::round(v * white)) <= rounding);
  };
  if (!std::all_of(gray.data.begin(), gray.data.end(), is_byte)) return;
  if (std::none_of(gray.data.begin(), gray.data.end(), is_fraction)) return;
  for (double& v : gray.data) v = std::round(v * white);
}

}  // namespace

Picture in_common_form(Picture picture) {
  restore_bytes(picture.gray);
  if (!picture.indices.empty()) picture.bits = 8;  // of what the palette shows
  if (picture.colour.empty() || is_coloured(picture)) return picture;
  picture.gray = Raster<double>(picture.colour.rows, picture.colour.cols);
  std::transform(picture.colour.data.begin(), picture.colour.data.end(), picture.gray.data.begin(),
                 [](Rgb c) { return c.r; });
  picture.colour = {};
  return picture;
}

namespace {

struct Range {
  double low = 0, high = 0;
};

Range range_of(const Raster<double>& gray) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const double v : gray.data)
    if (!std::isnan(v)) range.low = std::min(range.low, v), range.high = std::max(range.high, v);
  if (range.low > range.high) range = {};
  return range;
}

/// Range of all but one in a thousand at either end.
Range usual_range(const Raster<double>& gray) {
  std::vector<double> sorted;
  const std::size_t step = std::max<std::size_t>(1, gray.size() / 1'000'000);
  for (std::size_t i = 0; i < gray.size(); i += step)
    if (!std::isnan(gray.data[i])) sorted.push_back(gray.data[i]);
  if (sorted.empty()) return {};
  const std::size_t tail = sorted.size() / 1000;
  const auto pick = [&](std::size_t i) {
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(i), sorted.end());
    return sorted[i];
  };
  return {pick(tail), pick(sorted.size() - 1 - tail)};
}

/// Whole numbers, or fractions over much of the range, from 0 to 255.
bool are_bytes(const Raster<double>& gray, Range all) {
  if (all.low < 0 || all.high > 255 || all.high <= 1) return false;
  constexpr double much = 32;
  const auto is_whole = [](double v) { return std::isnan(v) || v == std::floor(v); };
  if (std::all_of(gray.data.begin(), gray.data.end(), is_whole)) return true;
  const Range usual = usual_range(gray);
  return usual.high - usual.low > much;
}

/// Largest number that all values are multiples of; 0 where one is negative or no whole number.
double common_step(const Raster<double>& gray) {
  constexpr double largest = 9e15;  // beyond it doubles skip whole numbers
  std::int64_t step = 0;
  for (const double v : gray.data) {
    if (std::isnan(v)) continue;
    if (v < 0 || v > largest || v != std::floor(v)) return 0;
    step = std::gcd(step, static_cast<std::int64_t>(v));
    if (step == 1) return 1;
  }
  return static_cast<double>(step);
}

/// What bytes were multiplied by to fill more bits; 0 where they are no such bytes.
double step_of_bytes(const Raster<double>& gray, Range all) {
  constexpr double most = 255, fewest_levels = 32;  // below them the numbers may be those of labels
  const double step = common_step(gray);
  for (const double usual : {257.0, 256.0})
    if (step > 0 && std::fmod(step, usual) == 0 && all.high <= usual * most) return usual;
  return step > 1 && all.high <= step * most && all.high > step * fewest_levels ? step : 0;
}

}  // namespace

std::string tame_outliers(Raster<double>& gray) {
  const Range all = range_of(gray);
  if (are_bytes(gray, all) || step_of_bytes(gray, all) > 0) return {};
  const Range usual = usual_range(gray);
  const double span = usual.high - usual.low;
  const double low = usual.low - span, high = usual.high + span;  // noise does not reach as far
  if (span <= 0 || (all.low >= low && all.high <= high)) return {};
  std::int64_t count = 0;
  std::size_t first = 0;
  double worst = 0;
  for (std::size_t i = 0; i < gray.size(); ++i) {
    double& v = gray.data[i];
    if (std::isnan(v) || (v >= low && v <= high)) continue;
    if (count++ == 0) first = i, worst = v;
    v = v < low ? usual.low : usual.high;
  }
  const auto cols = static_cast<std::size_t>(gray.cols);
  return counted(count, "pixel") + " far outside of the range of the others (" + short_number(usual.low) +
         " to " + short_number(usual.high) + ") brought to its end, the first in row " +
         std::to_string(first / cols) + ", column " + std::to_string(first % cols) + " with " +
         short_number(worst);
}

namespace {

/// How grey becomes a byte: (v - start) * scale.
struct Scale {
  double start = 0, factor = 1;
  bool spread = false;  ///< to the span of the values: black and white have no meaning of their own
};

/// White of the least depth that holds the values; 0 where none is meant.
double white_of(Range range) {
  if (range.low < 0) return 0;
  for (const double white : {1.0, 1023.0, 4095.0, 16383.0, 65535.0})
    if (range.high <= white) return white;
  return 0;
}

Scale scale_of(const Raster<double>& gray, int bits) {
  constexpr double byte = 255, much = 0.2;
  if (bits < 8) return {0, byte / (std::ldexp(1.0, bits) - 1)};
  const Range range = range_of(gray);
  if (are_bytes(gray, range)) return {};
  if (const double step = step_of_bytes(gray, range); step > 0) return {0, 1 / step};
  const double span = range.high - range.low;
  if (const double white = white_of(range); white > 0 && span >= much * white) return {0, byte / white};
  return {range.low, span > 0 ? byte / span : 0, true};
}

}  // namespace

bool is_spread(const Raster<double>& gray, int bits) { return scale_of(gray, bits).spread; }

Raster<Rgb> as_colour(const Raster<double>& gray, int bits) {
  const Scale scale = scale_of(gray, bits);
  Raster<Rgb> colour(gray.rows, gray.cols);
  std::transform(gray.data.begin(), gray.data.end(), colour.data.begin(), [&](double v) {
    if (std::isnan(v)) return Rgb{};
    const auto level =
        static_cast<std::uint8_t>(std::lround(std::clamp((v - scale.start) * scale.factor, 0.0, 255.0)));
    return Rgb{level, level, level};
  });
  return colour;
}

Raster<Rgb> shown_colours(const Picture& picture) {
  if (picture.gray.empty()) return picture.colour;
  Raster<double> gray = picture.gray;
  (void)tame_outliers(gray);
  return as_colour(gray, picture.bits);
}

}  // namespace specimen
