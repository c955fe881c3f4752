#include "libmpm/solver/lattice/cell_limit.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "libmpm/solver/grid.hpp"
#include "libmpm/solver/lattice/cell_stiffness.hpp"
#include "libmpm/solver/lattice/lattice_points.hpp"

namespace mpm {
namespace {

/// Stiffness of the cells of intact points, row by row from below.
std::vector<CellStiffness> cell_matrices(const Scene& scene, const Plan& plan) {
  std::vector<CellStiffness> cells(
      static_cast<std::size_t>(plan.cells_x) * static_cast<std::size_t>(plan.cells_y), CellStiffness::Zero());
  const auto cell_at = [&](int row, int col) -> CellStiffness& {
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
        CellStiffness& cell = cell_at(from_below / k, col / k);
        const Eigen::Matrix3d c = stiffness(*phase, scene.plane);
        cell +=
            point_stiffness(c, (col % k + 0.5) / k, (from_below % k + 0.5) / k) / (k * k * count(row, col));
        if (scene.pixel_cells) cell += bending_matrix(c) / count(row, col);
      }
  }
  const ExtraPoints extra = make_extra_points(scene, plan);
  for (std::size_t row = 0; row + 1 < extra.row_begin.size(); ++row)
    for (std::size_t i = extra.row_begin[row]; i < extra.row_begin[row + 1]; ++i) {
      const CellPoint& point = extra.points[i];
      cell_at(static_cast<int>(row), point.cell) +=
          point.share / (k * k) * point_stiffness(point.stiffness, point.xi, point.eta);
    }
  return cells;
}

double stiffness_of_node(const CellStiffness& cell, int node) {
  return cell(node, node) + cell(node + 4, node + 4);
}

/// Largest square of a frequency of a cell whose nodes have these masses [1/s^2]; nodes without mass stand
/// still.
double largest_square(CellStiffness cell, const std::array<double, 4>& masses) {
  for (int i = 0; i < 8; ++i) {
    const double mass = masses[static_cast<std::size_t>(i % 4)];
    const double scale = mass > 0 ? 1 / std::sqrt(mass) : 0;
    cell.row(i) *= scale;
    cell.col(i) *= scale;
  }
  return Eigen::SelfAdjointEigenSolver<CellStiffness>(cell, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

}  // namespace

double cell_limit(const Scene& scene, const Plan& plan) {
  const std::vector<CellStiffness> cells = cell_matrices(scene, plan);
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
