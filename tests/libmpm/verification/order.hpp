/// Order of convergence from the errors of a series of grids.
#pragma once

#include <cmath>
#include <vector>

namespace samples {

/// Slope of log(error) over log(size), fitted by least squares.
inline double fitted_order(const std::vector<double>& sizes, const std::vector<double>& errors) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const double lx = std::log(sizes[i]);
    const double ly = std::log(errors[i]);
    n += 1;
    x += lx;
    y += ly;
    xx += lx * lx;
    xy += lx * ly;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace samples
