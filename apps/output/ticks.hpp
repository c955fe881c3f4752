/// Round numbers along an axis.
#pragma once

#include <string>
#include <vector>

namespace output {

struct Ticks {
  double step = 1;             ///< 1, 2 or 5 times a power of ten
  std::vector<double> values;  ///< whole multiples of the step in [low, high], rising
};

/// The most ticks that are at most `at_most`.   @pre low < high, both finite, at_most >= 2.
[[nodiscard]] Ticks ticks_between(double low, double high, int at_most);

/// A tick with as many decimals as the step needs; powers of ten where that would be long.
[[nodiscard]] std::string tick_text(double value, double step);

}  // namespace output
