#include "apps/drawing/ticks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "apps/text/figures.hpp"

namespace output {
namespace {

double round_step(double width) { return rounded_up(width, {1, 2, 5}); }

std::vector<double> multiples(double step, double low, double high) {
  std::vector<double> values;
  const double slack = 1e-9 * (high - low);
  for (double k = std::ceil((low - slack) / step); k * step <= high + slack; ++k) values.push_back(k * step);
  return values;
}

}  // namespace

double rounded_up(double value, std::initializer_list<double> factors) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : factors)
    if (factor * power >= value * (1 - 1e-9)) return factor * power;
  return 10 * power;
}

Ticks ticks_between(double low, double high, int at_most) {
  double step = round_step((high - low) / at_most);
  std::vector<double> values = multiples(step, low, high);
  while (static_cast<int>(values.size()) > at_most) {
    step = round_step(step * 1.5);
    values = multiples(step, low, high);
  }
  return {step, values};
}

std::vector<double> logarithmic_ticks(double low, double high, int at_most) {
  const double slack = 1e-9;
  const int first = static_cast<int>(std::ceil(std::log10(low) - slack));
  const int last = static_cast<int>(std::floor(std::log10(high) + slack));
  std::vector<double> values;
  if (last - first >= 1) {
    const int stride = 1 + (last - first) / at_most;
    for (int power = first; power <= last; power += stride) values.push_back(std::pow(10.0, power));
    return values;
  }
  for (int power = first - 1; power <= last + 1; ++power)
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double value = factor * std::pow(10.0, power);
      if (value >= low * (1 - slack) && value <= high * (1 + slack)) values.push_back(value);
    }
  constexpr std::size_t few = 3;
  if (values.size() >= few) return values;
  values = ticks_between(low, high, at_most).values;  // less than a decade is almost even
  if (values.empty()) values.push_back(std::sqrt(low * high));
  return values;
}

std::string tick_text(double value, double step) {
  if (value == 0) return "0";
  const int decimals = -static_cast<int>(std::floor(std::log10(step) + 1e-9));
  if (decimals > 4 || decimals < -7) {
    const int digits = 1 + static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-9)) + decimals;
    return rounded(value, std::max(1, digits));
  }
  return with_decimals(value, std::max(0, decimals));
}

namespace {

/// Half a pixel wide, for renderers that draw at twice the size.
double column_of(const Place& place) { return std::floor(2 * place.x); }

/// Keep what can be seen of places [begin, end), which lie in one column.
void keep_extremes(const std::vector<Place>& places, std::size_t begin, std::size_t end,
                   std::vector<Place>& kept) {
  const auto first = places.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto last = places.begin() + static_cast<std::ptrdiff_t>(end);
  const auto [low, high] =
      std::minmax_element(first, last, [](const Place& a, const Place& b) { return a.y < b.y; });
  std::array indices{first, low, high, last - 1};
  std::sort(indices.begin(), indices.end());
  const auto distinct = std::unique(indices.begin(), indices.end());
  for (auto it = indices.begin(); it != distinct; ++it) kept.push_back(**it);
}

}  // namespace

std::vector<std::vector<Place>> unbroken_lines(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<std::vector<Place>> lines(1);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (std::isfinite(x[i]) && std::isfinite(y[i]))
      lines.back().push_back({x[i], y[i]});
    else if (!lines.back().empty())
      lines.emplace_back();
  }
  std::erase_if(lines, [](const std::vector<Place>& line) { return line.size() < 2; });
  return lines;
}

std::vector<Place> thin_line(const std::vector<Place>& places) {
  std::vector<Place> kept;
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= places.size(); ++i)
    if (i == places.size() || column_of(places[i]) != column_of(places[begin])) {
      keep_extremes(places, begin, i, kept);
      begin = i;
    }
  return kept;
}

StrainUnit strain_unit(double largest_strain) {
  if (largest_strain >= 0.01) return {"%", 1e2};
  return {"microstrain", 1e6};
}

double largest_strain(const mpm::Result& result) {
  double largest = 0;
  for (const mpm::HistoryRow& row : result.history)
    if (std::isfinite(row.strain)) largest = std::max(largest, row.strain);
  return largest;
}

StrainUnit strain_unit(const mpm::Result& result) { return strain_unit(largest_strain(result)); }

const char* reference_strain(const mpm::Result& result) {
  return mpm::peak_reached(result) ? "the peak strain" : "the strain at the largest stress, which is no peak";
}

std::string strain_words(const mpm::Result& result, double strain, int decimals) {
  const StrainUnit unit = strain_unit(result);
  std::string words = rounded(unit.per_strain * strain) + " " + unit.name;
  if (result.peak_strain > 0)
    words += ", " + percent(strain / result.peak_strain, decimals) + " of " + reference_strain(result);
  return words;
}

}  // namespace output
