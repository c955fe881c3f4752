#include "libmpm/solver/lattice/cell_stiffness.hpp"

#include "libmpm/solver/lattice/lattice_points.hpp"

namespace mpm {

CellStiffness point_stiffness(const Eigen::Matrix3d& stiffness, double xi, double eta) {
  const Eigen::RowVector4d along_x(-(1 - eta), 1 - eta, -eta, eta);
  const Eigen::RowVector4d along_y(-(1 - xi), -xi, 1 - xi, xi);
  // Strain (e_xx, e_yy, gamma_xy) over displacement, times the size of the cell [-].
  Eigen::Matrix<double, 3, 8> b = Eigen::Matrix<double, 3, 8>::Zero();
  b.block<1, 4>(0, 0) = along_x;
  b.block<1, 4>(1, 4) = along_y;
  b.block<1, 4>(2, 0) = along_y;
  b.block<1, 4>(2, 4) = along_x;
  return b.transpose() * stiffness * b;
}

CellStiffness bending_matrix(const Eigen::Matrix3d& stiffness) {
  const Eigen::Vector4d mode(1, -1, -1, 1);
  const Eigen::Matrix4d bending = bending_stiffness(stiffness) * mode * mode.transpose();
  CellStiffness matrix = CellStiffness::Zero();
  matrix.topLeftCorner<4, 4>() = bending;
  matrix.bottomRightCorner<4, 4>() = bending;
  return matrix;
}

}  // namespace mpm
