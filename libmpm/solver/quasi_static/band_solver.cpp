#include "libmpm/solver/quasi_static/band_solver.hpp"

#include <algorithm>
#include <cmath>

namespace mpm {

void BandSolver::reset(int unknowns, int band) {
  unknowns_ = unknowns;
  band_ = band;
  values_.assign(static_cast<std::size_t>(unknowns) * static_cast<std::size_t>(band + 1), 0.0);
}

void BandSolver::add(int row, int col, double value) {
  if (col <= row) at(row, col) += value;
}

void BandSolver::factorise(double tolerance) {
  double largest = 0;
  for (int i = 0; i < unknowns_; ++i) largest = std::max(largest, at(i, i));
  for (int i = 0; i < unknowns_; ++i) {
    const int first = std::max(0, i - band_);
    const double whole = at(i, i);
    for (int j = first; j <= i; ++j) {
      double sum = at(i, j);
      for (int m = std::max(first, j - band_); m < j; ++m) sum -= at(i, m) * at(j, m);
      if (j < i)
        at(i, j) = sum * at(j, j);
      else  // what is left of a singular row is rounding; the diagonal is kept as its inverse, 0 = held
        at(i, i) = sum > tolerance * whole && sum > 1e-14 * largest ? 1 / std::sqrt(sum) : 0;
    }
  }
}

void BandSolver::solve(std::vector<double>& x) const {
  for (int i = 0; i < unknowns_; ++i) {
    double sum = x[static_cast<std::size_t>(i)];
    for (int j = std::max(0, i - band_); j < i; ++j) sum -= at(i, j) * x[static_cast<std::size_t>(j)];
    x[static_cast<std::size_t>(i)] = sum * at(i, i);
  }
  for (int i = unknowns_ - 1; i >= 0; --i) {
    const double value = x[static_cast<std::size_t>(i)] * at(i, i);
    x[static_cast<std::size_t>(i)] = value;
    for (int j = std::max(0, i - band_); j < i; ++j) x[static_cast<std::size_t>(j)] -= at(i, j) * value;
  }
}

}  // namespace mpm
