/// The least value of a smooth function within bounds, without its derivatives.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace app {

struct Box {
  std::vector<double> start;
  std::vector<double> low, high;  ///< same length; start lies within
};

/// Where the function is least, to 1e-7, by BOBYQA: quadratic models in a trust region.
/// @throws what the function throws.
/// Source: Powell (2009), as NLopt has it.
[[nodiscard]] std::vector<double> bounded_minimum(
    const Box& box, const std::function<double(const std::vector<double>&)>& function);

/// "BOBYQA (NLopt 2.7.1)".
[[nodiscard]] std::string name_of_minimizer();

}  // namespace app
