#include "libmpm/solver/grid.hpp"

#include <algorithm>
#include <cmath>

namespace mpm {
namespace {

/// Add a point's mass to the four nodes of its cell. x, y: place in units of the cell size.
void scatter_mass(const Grid& grid, double x, double y, double mass, AlignedVector<double>& m_i) {
  const int col = std::min(static_cast<int>(x), grid.cols - 2);
  const int row = std::min(static_cast<int>(y), grid.rows - 2);
  const double xi = x - col;
  const double eta = y - row;
  const auto at = static_cast<std::size_t>(grid.at(row, col));
  const auto above = at + static_cast<std::size_t>(grid.stride);
  m_i[at] += (1 - xi) * (1 - eta) * mass;
  m_i[at + 1] += xi * (1 - eta) * mass;
  m_i[above] += (1 - xi) * eta * mass;
  m_i[above + 1] += xi * eta * mass;
}

AlignedVector<double> lumped_mass(const Scene& scene, const Plan& plan, const Grid& grid) {
  AlignedVector<double> m_i(grid.ux.size(), 0.0);
  const auto points = points_per_pixel(scene);
  const double area = scene.pixel_size * scene.pixel_size;
  const double pixels_per_cell = scene.points_per_cell;
  const auto rows = scene.labels.rows();
  for (Eigen::Index row = 0; row < rows; ++row) {
    for (Eigen::Index col = 0; col < scene.labels.cols(); ++col) {
      const auto& phase = scene.phases[scene.labels(row, col)];
      if (!phase) continue;
      scatter_mass(grid, (static_cast<double>(col) + 0.5) / pixels_per_cell,
                   (static_cast<double>(rows - row) - 0.5) / pixels_per_cell,
                   phase->density * area / points(row, col), m_i);
    }
  }
  for (const auto& point : scene.extra_points) {
    const auto& phase = scene.phases[point.phase];
    if (!phase) continue;
    const Pixel pixel = pixel_at(scene, point.x, point.y);
    scatter_mass(grid, point.x / plan.cell_size, point.y / plan.cell_size,
                 phase->density * area / points(pixel.row, pixel.col), m_i);
  }
  return m_i;
}

}  // namespace

Pixel pixel_at(const Scene& scene, double x, double y) {
  const int rows = static_cast<int>(scene.labels.rows());
  const int cols = static_cast<int>(scene.labels.cols());
  const int col = std::clamp(static_cast<int>(x / scene.pixel_size), 0, cols - 1);
  const int from_below = std::clamp(static_cast<int>(y / scene.pixel_size), 0, rows - 1);
  return {rows - 1 - from_below, col};
}

PixelField<std::uint16_t> points_per_pixel(const Scene& scene) {
  PixelField<std::uint16_t> count = PixelField<std::uint16_t>::Ones(scene.labels.rows(), scene.labels.cols());
  for (const auto& point : scene.extra_points) {
    const Pixel pixel = pixel_at(scene, point.x, point.y);
    ++count(pixel.row, pixel.col);
  }
  return count;
}

Grid make_grid(const Scene& scene, const Plan& plan) {
  Grid grid;
  grid.rows = plan.cells_y + 1;
  grid.cols = plan.cells_x + 1;
  grid.stride = padded(plan.cells_x) + kernels::lane_cells;
  const auto size = static_cast<std::size_t>(grid.rows) * static_cast<std::size_t>(grid.stride);
  for (auto* field : {&grid.ux, &grid.uy, &grid.vx, &grid.vy}) field->assign(size, 0.0);
  grid.impulse_over_mass = lumped_mass(scene, plan, grid);
  const double pixels = scene.points_per_cell * scene.points_per_cell;
  for (double& value : grid.impulse_over_mass) value = value > 0 ? plan.dt / (pixels * value) : 0.0;
  return grid;
}

}  // namespace mpm
