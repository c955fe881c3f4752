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

/// Of a logarithmic axis: powers of ten in [low, high]; where there are fewer than two, 2 and 5 times them as
/// well. Never empty, rising, at most about `at_most`.   @pre 0 < low < high, both finite, at_most >= 2.
[[nodiscard]] std::vector<double> logarithmic_ticks(double low, double high, int at_most);

/// A tick with as many decimals as the step needs; powers of ten where that would be long.
[[nodiscard]] std::string tick_text(double value, double step);

}  // namespace output
