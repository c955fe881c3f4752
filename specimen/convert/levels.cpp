#include "specimen/convert/levels.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "specimen/body/measure.hpp"

namespace specimen {

bool is_coloured(const Picture& picture) {
  const auto has_tint = [](Rgb c) { return c.r != c.g || c.g != c.b; };
  return picture.gray.empty() &&
         std::any_of(picture.colour.data.begin(), picture.colour.data.end(), has_tint);
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

bool all_multiples(const Raster<double>& gray, double of) {
  return std::all_of(gray.data.begin(), gray.data.end(),
                     [&](double v) { return std::isnan(v) || std::fmod(v, of) == 0; });
}

}  // namespace

std::string tame_outliers(Raster<double>& gray) {
  const Range all = range_of(gray);
  if (are_bytes(gray, all)) return {};
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

Scale scale_of(const Raster<double>& gray) {
  constexpr double sixteen = 65535, low_end = 0.1 * sixteen, high_end = 0.9 * sixteen;
  const Range range = range_of(gray);
  if (are_bytes(gray, range)) return {};
  if (range.low >= 0 && range.high <= sixteen && range.high > sixteen / 2) {
    for (const double step : {257.0, 256.0})
      if (all_multiples(gray, step)) return {0, 1 / step};
    if (range.low < low_end && range.high > high_end) return {0, 1.0 / 257};
  }
  return {range.low, range.high > range.low ? 255 / (range.high - range.low) : 0, true};
}

}  // namespace

bool is_spread(const Raster<double>& gray) { return scale_of(gray).spread; }

Raster<Rgb> as_colour(const Raster<double>& gray) {
  const Scale scale = scale_of(gray);
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
  return as_colour(gray);
}

}  // namespace specimen
