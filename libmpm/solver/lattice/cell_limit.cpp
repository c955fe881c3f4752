#include "libmpm/solver/lattice/cell_limit.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "libmpm/solver/grid.hpp"
#include "libmpm/solver/lattice/lattice_points.hpp"

namespace mpm {
namespace {

using CellMatrix = Eigen::Matrix<double, 8, 8>;  ///< of (ux, uy) of the lower left, lower right, upper left,
                                                 ///< upper right node [Pa], for a unit of thickness

/// Strain (e_xx, e_yy, gamma_xy) over displacement at a place of a cell, times the size of the cell [-].
Eigen::Matrix<double, 3, 8> strain_matrix(double xi, double eta) {
  const std::array<double, 4> along_x{-(1 - eta), 1 - eta, -eta, eta};
  const std::array<double, 4> along_y{-(1 - xi), -xi, 1 - xi, xi};
  Eigen::Matrix<double, 3, 8> b = Eigen::Matrix<double, 3, 8>::Zero();
  for (int node = 0; node < 4; ++node) {
    const auto i = static_cast<std::size_t>(node);
    b(0, 2 * node) = b(2, 2 * node + 1) = along_x[i];
    b(1, 2 * node + 1) = b(2, 2 * node) = along_y[i];
  }
  return b;
}

/// @param area  of the point over that of the cell [-].
void add_point(CellMatrix& cell, const Eigen::Matrix3d& c, double xi, double eta, double area) {
  const auto b = strain_matrix(xi, eta);
  cell += area * b.transpose() * c * b;
}

/// A pixel cell: its middle as a point, and its bending.
void add_bending(CellMatrix& cell, const Eigen::Matrix3d& c, double area) {
  const Eigen::Vector4d mode(1, -1, -1, 1);
  const double k = area * bending_stiffness(c);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      for (int component = 0; component < 2; ++component)
        cell(2 * i + component, 2 * j + component) += k * mode(i) * mode(j);
}

/// Stiffness of the cells of intact points, row by row from below.
std::vector<CellMatrix> cell_matrices(const Scene& scene, const Plan& plan) {
  std::vector<CellMatrix> cells(
      static_cast<std::size_t>(plan.cells_x) * static_cast<std::size_t>(plan.cells_y), CellMatrix::Zero());
  const auto cell_at = [&](int row, int col) -> CellMatrix& {
    return cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(plan.cells_x) +
                 static_cast<std::size_t>(col)];
  };
  const int k = scene.points_per_cell;
  const auto rows = static_cast<int>(scene.labels.rows());
  const auto count = points_per_pixel(scene);
  for (int row = 0; row < rows; ++row) {
    const int from_below = rows - 1 - row;
    for (int col = 0; col < scene.labels.cols(); ++col)
      if (const auto& phase = scene.phases[scene.labels(row, col)]) {
        CellMatrix& cell = cell_at(from_below / k, col / k);
        const Eigen::Matrix3d c = stiffness(*phase, scene.plane);
        add_point(cell, c, (col % k + 0.5) / k, (from_below % k + 0.5) / k, 1.0 / (k * k * count(row, col)));
        if (scene.pixel_cells) add_bending(cell, c, 1.0 / count(row, col));
      }
  }
  const ExtraPoints extra = make_extra_points(scene, plan);
  for (std::size_t row = 0; row + 1 < extra.row_begin.size(); ++row)
    for (std::size_t i = extra.row_begin[row]; i < extra.row_begin[row + 1]; ++i) {
      const CellPoint& point = extra.points[i];
      add_point(cell_at(static_cast<int>(row), point.cell), point.stiffness, point.xi, point.eta,
                point.share / (k * k));
    }
  return cells;
}

double stiffness_of_node(const CellMatrix& cell, int node) {
  return cell(2 * node, 2 * node) + cell(2 * node + 1, 2 * node + 1);
}

/// Largest square of a frequency of a cell whose nodes have these masses [1/s^2]; nodes without mass stand
/// still.
double largest_square(CellMatrix cell, const std::array<double, 4>& masses) {
  for (int i = 0; i < 8; ++i) {
    const double mass = masses[static_cast<std::size_t>(i / 2)];
    const double scale = mass > 0 ? 1 / std::sqrt(mass) : 0;
    cell.row(i) *= scale;
    cell.col(i) *= scale;
  }
  return Eigen::SelfAdjointEigenSolver<CellMatrix>(cell, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

}  // namespace

double cell_limit(const Scene& scene, const Plan& plan) {
  const std::vector<CellMatrix> cells = cell_matrices(scene, plan);
  const Grid grid = make_grid(scene, plan);
  const auto node_of = [&](std::size_t cell, int node) {
    const int row = static_cast<int>(cell) / plan.cells_x + node / 2;
    const int col = static_cast<int>(cell) % plan.cells_x + node % 2;
    return static_cast<std::size_t>(grid.at(row, col));
  };
  std::vector<double> node_stiffness(grid.ux.size(), 0.0);
  for (std::size_t cell = 0; cell < cells.size(); ++cell)
    for (int node = 0; node < 4; ++node)
      node_stiffness[node_of(cell, node)] += stiffness_of_node(cells[cell], node);
  const double points = scene.points_per_cell * scene.points_per_cell;
  double largest = 0;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    std::array<double, 4> masses{};
    for (int node = 0; node < 4; ++node) {
      const std::size_t at = node_of(cell, node);
      const double whole =
          grid.impulse_over_mass[at] > 0 ? plan.dt / (points * grid.impulse_over_mass[at]) : 0;
      const double share = stiffness_of_node(cells[cell], node) / node_stiffness[at];
      masses[static_cast<std::size_t>(node)] = node_stiffness[at] > 0 ? share * whole : 0;
    }
    largest = std::max(largest, largest_square(cells[cell], masses));
  }
  return largest > 0 ? damped_share(scene.local_damping) * 2 / std::sqrt(largest)
                     : std::numeric_limits<double>::infinity();
}

}  // namespace mpm
