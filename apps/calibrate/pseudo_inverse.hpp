/// Inverse of a matrix that may have none.
#pragma once

#include <Eigen/Core>

namespace app {

/// Moore and Penrose's inverse: what it gives is the least-squares solution, the smallest where there are
/// many. Singular values below 1e-6 of the largest count as zero.
[[nodiscard]] Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix);

}  // namespace app
