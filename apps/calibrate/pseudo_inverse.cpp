#include "apps/calibrate/pseudo_inverse.hpp"

#include <Eigen/QR>

namespace app {

Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix) {
  auto decomposition = Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>();
  decomposition.setThreshold(1e-6);
  decomposition.compute(matrix);
  return decomposition.pseudoInverse();
}

}  // namespace app
