#include "apps/calibrate/trend_search.hpp"

#include <gtest/gtest.h>

namespace pseudo_inverse_test {

// The four conditions of Penrose (1955), for a full, a deficient and a flat matrix.
TEST(PseudoInverse, KeepsPenrosesConditions) {
  Eigen::MatrixXd full(3, 2), deficient(3, 3), flat(1, 3);
  full << 1, 2, 3, 4, 5, 7;
  deficient << 1, 2, 3, 2, 4, 6, 1, 0, 1;
  flat << 1, -2, 2;
  for (const Eigen::MatrixXd& a : {full, deficient, flat}) {
    const Eigen::MatrixXd b = app::pseudo_inverse(a);
    EXPECT_LT((a * b * a - a).norm(), 1e-12);
    EXPECT_LT((b * a * b - b).norm(), 1e-12);
    EXPECT_LT((a * b - (a * b).transpose()).norm(), 1e-12);
    EXPECT_LT((b * a - (b * a).transpose()).norm(), 1e-12);
  }
}

}  // namespace pseudo_inverse_test
