/// A direct solver for the coarsest grid, whose matrix is a band.
#pragma once

#include <cstddef>
#include <vector>

namespace mpm {

/// Cholesky decomposition of a symmetric positive semidefinite band matrix. An unknown without stiffness is
/// held at zero.
class BandSolver {
 public:
  /// Begins a matrix of zeros. @param band  number of diagonals beside the main one.
  void reset(int unknowns, int band);
  /// @pre |row - col| <= band.
  void add(int row, int col, double value);
  /// @param tolerance  share of its diagonal below which what is left of a row counts as nothing [-].
  void factorise(double tolerance = 1e-12);
  /// In place.   @pre factorised.
  void solve(std::vector<double>& x) const;
  [[nodiscard]] int unknowns() const { return unknowns_; }

 private:
  [[nodiscard]] double& at(int row, int col) {
    return values_[static_cast<std::size_t>(row) * static_cast<std::size_t>(band_ + 1) +
                   static_cast<std::size_t>(row - col)];
  }
  [[nodiscard]] double at(int row, int col) const {
    return values_[static_cast<std::size_t>(row) * static_cast<std::size_t>(band_ + 1) +
                   static_cast<std::size_t>(row - col)];
  }

  int unknowns_ = 0, band_ = 0;
  std::vector<double> values_;  ///< lower triangle by rows: the diagonal, then what is left of it
};

}  // namespace mpm
