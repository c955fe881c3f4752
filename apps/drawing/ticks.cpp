#include "apps/drawing/ticks.hpp"

#include <algorithm>
#include <cmath>

#include "apps/text/text.hpp"

namespace output {
namespace {

/// Smallest of 1, 2, 5 times a power of ten that is not below a width.
double round_up(double width) {
  const double power = std::pow(10.0, std::floor(std::log10(width)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= width * (1 - 1e-9)) return factor * power;
  return 10 * power;
}

std::vector<double> multiples(double step, double low, double high) {
  std::vector<double> values;
  const double slack = 1e-9 * (high - low);
  for (double k = std::ceil((low - slack) / step); k * step <= high + slack; ++k) values.push_back(k * step);
  return values;
}

}  // namespace

Ticks ticks_between(double low, double high, int at_most) {
  double step = round_up((high - low) / at_most);
  std::vector<double> values = multiples(step, low, high);
  while (static_cast<int>(values.size()) > at_most) {
    step = round_up(step * 1.5);
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

}  // namespace output
