/// Stiffness of cells as matrices of 8 x 8.
#pragma once

#include <Eigen/Core>

namespace mpm {

/// Forces on the nodes of a cell over their displacements [Pa], for a unit of thickness, in the order x of
/// the lower left, lower right, upper left and upper right node, then y of the same.
using CellStiffness = Eigen::Matrix<double, 8, 8>;

/// What a point at a place of a cell adds, as if it stood for all of the cell. xi, eta in [0, 1].
/// @param stiffness  of its phase, see stiffness(const Phase&, Plane) [Pa].
[[nodiscard]] CellStiffness point_stiffness(const Eigen::Matrix3d& stiffness, double xi, double eta);

/// What the bending of a pixel cell adds to its point; see bending_stiffness().
[[nodiscard]] CellStiffness bending_matrix(const Eigen::Matrix3d& stiffness);

}  // namespace mpm
