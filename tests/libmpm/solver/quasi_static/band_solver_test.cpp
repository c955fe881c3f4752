#include "libmpm/solver/quasi_static/band_solver.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

namespace band_solver_test {

using mpm::BandSolver;

TEST(BandSolver, SolvesASymmetricSystem) {
  constexpr int n = 12;
  constexpr int band = 3;
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = std::max(0, i - band); j <= i; ++j) a(i, j) = a(j, i) = i == j ? 9 + i : 1.0 / (1 + i + j);
  BandSolver solver;
  solver.reset(n, band);
  for (int i = 0; i < n; ++i)
    for (int j = std::max(0, i - band); j < std::min(n, i + band + 1); ++j) solver.add(i, j, a(i, j));
  solver.factorise();
  std::vector<double> x(n);
  for (int i = 0; i < n; ++i) x[static_cast<std::size_t>(i)] = i * i - 7.0;
  const Eigen::VectorXd load = Eigen::Map<Eigen::VectorXd>(x.data(), n);
  solver.solve(x);
  EXPECT_LT((a * Eigen::Map<Eigen::VectorXd>(x.data(), n) - load).norm(), 1e-12 * load.norm());
}

TEST(BandSolver, HoldsWhatHasNoStiffness) {
  BandSolver solver;
  solver.reset(3, 1);
  solver.add(0, 0, 2);  // the second unknown has none, the third is alone
  solver.add(2, 2, 4);
  solver.factorise();
  std::vector<double> x{6, 5, 8};
  solver.solve(x);
  EXPECT_DOUBLE_EQ(x[0], 3);
  EXPECT_EQ(x[1], 0);
  EXPECT_DOUBLE_EQ(x[2], 2);
}

}  // namespace band_solver_test
