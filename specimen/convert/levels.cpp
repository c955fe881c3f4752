#include "specimen/convert/levels.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>

#include "specimen/body/measure.hpp"
#include "specimen/convert/guess.hpp"

namespace specimen {

bool is_coloured(const Picture& picture) {
  const auto has_tint = [](Rgb c) { return c.r != c.g || c.g != c.b; };
  return picture.gray.empty() &&
         std::any_of(picture.colour.data.begin(), picture.colour.data.end(), has_tint);
}

namespace {

/// Whether all values pass a test.
template <class Test>
bool all_of(const GreyLevels& gray, const Test& test) {
  return gray.data.visit([&](const auto& values) {
    return std::all_of(values.begin(), values.end(), [&](auto v) { return test(static_cast<double>(v)); });
  });
}

/// Bytes that were divided by 255, as programs that compute with fractions keep them, become bytes again.
void restore_bytes(GreyLevels& gray) {
  constexpr double white = 255, rounding = 1e-4;
  const auto is_fraction = [](double v) { return v > 0 && v < 1; };
  const auto is_byte = [](double v) {
    return std::isnan(v) || (v >= 0 && v <= 1 && std::abs(v * white - std::round(v * white)) <= rounding);
  };
  if (!all_of(gray, is_byte) || all_of(gray, [&](double v) { return !is_fraction(v); })) return;
  gray = gray.with([&](auto raster) {
    using T = typename decltype(raster.data)::value_type;
    for (T& v : raster.data) v = static_cast<T>(std::round(static_cast<double>(v) * white));
    return raster;
  });
}

/// Whole numbers in 8 or 16 bits where they fit.
void narrow(GreyLevels& gray) {
  const auto into = [&](auto raster) {
    using T = typename decltype(raster.data)::value_type;
    gray.data.visit([&](const auto& values) {
      std::transform(values.begin(), values.end(), raster.data.begin(),
                     [](auto v) { return static_cast<T>(v); });
    });
    gray = std::move(raster);
  };
  constexpr double byte = 255, two_bytes = 65535;
  double high = 0;
  const auto is_whole = [&](double v) {
    high = std::max(high, v);
    return v >= 0 && v <= two_bytes && v == std::floor(v);
  };
  const bool is_narrow = gray.data.visit([](const auto& values) { return sizeof(values.front()) <= 2; });
  if (is_narrow || !all_of(gray, is_whole)) return;
  if (high <= byte)
    into(Raster<std::uint8_t>(gray.rows, gray.cols));
  else
    into(Raster<std::uint16_t>(gray.rows, gray.cols));
}

/// The indices of a palette become names of what they show, where each shows something of its own.
void name_values(Picture& picture) {
  if (picture.indices.empty()) return;
  picture.bits = 8;  // of what is shown
  if (shares_colours(picture)) return;
  picture.names = names_by_palette(picture);
  picture.indices = {};
}

}  // namespace

Picture in_common_form(Picture picture) {
  name_values(picture);
  restore_bytes(picture.gray);
  narrow(picture.gray);
  if (picture.colour.empty() || is_coloured(picture)) return picture;
  Raster<std::uint8_t> gray(picture.colour.rows, picture.colour.cols);
  std::transform(picture.colour.data.begin(), picture.colour.data.end(), gray.data.begin(),
                 [](Rgb c) { return c.r; });
  picture.gray = std::move(gray);
  picture.colour = {};
  return picture;
}

namespace {

struct Range {
  double low = 0, high = 0;
};

Range range_of(const GreyLevels& gray) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  gray.data.visit([&](const auto& values) {
    if (values.empty()) return;
    auto low = std::numeric_limits<typename std::decay_t<decltype(values)>::value_type>::max(), high = low;
    bool any = false;
    for (const auto v : values) {
      if (v != v) continue;  // not a number
      if (!any) low = high = v;
      any = true;
      low = std::min(low, v), high = std::max(high, v);
    }
    if (any) range = {static_cast<double>(low), static_cast<double>(high)};
  });
  if (range.low > range.high) range = {};
  return range;
}

/// Range of all but one in a thousand at either end.
Range usual_range(const GreyLevels& gray) {
  std::vector<double> sorted;
  const std::size_t step = std::max<std::size_t>(1, gray.size() / 1'000'000);
  for (std::size_t i = 0; i < gray.size(); i += step)
    if (const double v = gray.data[i]; !std::isnan(v)) sorted.push_back(v);
  if (sorted.empty()) return {};
  const std::size_t tail = sorted.size() / 1000;
  const auto pick = [&](std::size_t i) {
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(i), sorted.end());
    return sorted[i];
  };
  return {pick(tail), pick(sorted.size() - 1 - tail)};
}

/// Whole numbers, or fractions over much of the range, from 0 to 255.
bool are_bytes(const GreyLevels& gray, Range all) {
  if (all.low < 0 || all.high > 255 || all.high <= 1) return false;
  constexpr double much = 32;
  const auto is_whole = [](double v) { return std::isnan(v) || v == std::floor(v); };
  if (all_of(gray, is_whole)) return true;
  const Range usual = usual_range(gray);
  return usual.high - usual.low > much;
}

/// Largest number that all values are multiples of; 0 where one is negative or no whole number.
double common_step(const GreyLevels& gray) {
  constexpr double largest = 9e15;  // beyond it doubles skip whole numbers
  std::int64_t step = 0;
  const auto share = [&](double v) {
    if (std::isnan(v)) return true;
    if (v < 0 || v > largest || v != std::floor(v)) return false;
    const auto whole = static_cast<std::int64_t>(v);
    if (step == 0 || whole % step != 0) step = std::gcd(step, whole);
    return step != 1;
  };
  const bool all = all_of(gray, share);
  return all || step == 1 ? static_cast<double>(step) : 0;
}

/// What bytes were multiplied by to fill more bits; 0 where they are no such bytes.
double step_of_bytes(const GreyLevels& gray, Range all) {
  constexpr double most = 255, fewest_levels = 32;  // below them the numbers may be those of labels
  const double step = common_step(gray);
  for (const double usual : {257.0, 256.0})
    if (step > 0 && std::fmod(step, usual) == 0 && all.high <= usual * most) return usual;
  return step > 1 && all.high <= step * most && all.high > step * fewest_levels ? step : 0;
}

}  // namespace

std::string tame_outliers(GreyLevels& gray) {
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
    const double v = std::as_const(gray).data[i];
    if (std::isnan(v) || (v >= low && v <= high)) continue;
    if (count++ == 0) first = i, worst = v;
    gray.data[i] = v < low ? usual.low : usual.high;
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

Scale scale_of(const GreyLevels& gray, int bits) {
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

bool is_spread(const GreyLevels& gray, int bits) { return scale_of(gray, bits).spread; }

Raster<Rgb> as_colour(const GreyLevels& gray, int bits) {
  const Scale scale = scale_of(gray, bits);
  Raster<Rgb> colour(gray.rows, gray.cols);
  gray.data.visit([&](const auto& values) {
    std::transform(values.begin(), values.end(), colour.data.begin(), [&](auto value) {
      const auto v = static_cast<double>(value);
      if (std::isnan(v)) return Rgb{};
      const auto level =
          static_cast<std::uint8_t>(std::lround(std::clamp((v - scale.start) * scale.factor, 0.0, 255.0)));
      return Rgb{level, level, level};
    });
  });
  return colour;
}

Raster<Rgb> shown_colours(const Picture& picture) {
  if (picture.gray.empty()) return picture.colour;
  GreyLevels gray = picture.gray;
  (void)tame_outliers(gray);
  return as_colour(gray, picture.bits);
}

}  // namespace specimen
