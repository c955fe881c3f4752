/// A small grid with points at given places, for tests of the sweeps of moving points one by one.
#pragma once

#include <cmath>
#include <random>
#include <string>

#include "libmpm/kernels/instruction_set.hpp"
#include "libmpm/solver/moving/moving_grid.hpp"
#include "libmpm/solver/moving/moving_points.hpp"
#include "tests/libmpm/moving_scenes.hpp"

namespace samples {

template <class Real>
struct Stage {
  using Points = mpm::MovingPoints<Real>;
  using Grid = mpm::MovingGrid<Real>;

  mpm::Scene scene;
  mpm::Plan plan;
  mpm::MovingGeometry geometry;
  mpm::moving::Sweeps<Real> sweeps;
  Points points;
  Grid grid;
  mpm::TileSums<Real> momentum, force;
  mpm::moving::Step<Real> step{};
  bool folds = false;  ///< all four edges are supports

  /// 7 x 5 cells of 0.1 m; GIMP points are half a cell wide.
  explicit Stage(const Method& method, const std::string& instruction_set = "")
      : scene(scene_of(method)),
        plan(plan_of(scene)),
        geometry(mpm::moving_geometry(scene, plan)),
        sweeps(mpm::chosen_moving_kernels(instruction_set).template sweeps<Real>(plan.moving.features)),
        points(geometry.tiles_y, geometry.tiles_x, sweeps.lanes, mpm::record_layout(plan.moving.optional)),
        grid(mpm::make_moving_grid<Real>(geometry)),
        momentum(geometry, 3, every_row(geometry)),
        force(geometry, 2, every_row(geometry)) {
    step.half_size = static_cast<Real>(plan.moving.half_size);
    step.hx = step.hy = static_cast<Real>(plan.cell_size);
    step.dt = Real(1e-4);
    step.hy_after = step.hy;
    step.flip_ratio = static_cast<Real>(method.flip_ratio);
  }

  static mpm::Scene scene_of(const Method& method) {
    mpm::Scene result = soft_body(10, 14, 0.05, 0.25);
    result.motion.margin = 0;
    method.give_to(result);
    return result;
  }
  static mpm::Plan plan_of(const mpm::Scene& of) {
    mpm::Plan result = mpm::plan(of);
    result.moving.optional.deformation = true;
    return result;
  }
  /// Each row a band of its own: the sums of all are kept.
  static std::vector<int> every_row(const mpm::MovingGeometry& of) {
    std::vector<int> ends;
    for (int row = 1; row <= of.tiles_y; ++row) ends.push_back(row);
    return ends;
  }
  typename Points::Loose point_at(double x, double y) const {
    typename Points::Loose point;
    const double tile_x = x / plan.cell_size - geometry.tile_offset;
    const double tile_y = y / plan.cell_size - geometry.tile_offset;
    point.tile = {static_cast<int>(std::floor(tile_y)), static_cast<int>(std::floor(tile_x))};
    auto& v = point.values;
    v[mpm::moving::xi] = static_cast<Real>(tile_x - point.tile.col);
    v[mpm::moving::eta] = static_cast<Real>(tile_y - point.tile.row);
    v[mpm::moving::mass] = v[mpm::moving::volume] = 1;
    v[mpm::moving::lame] = 2;
    v[mpm::moving::shear] = 3;
    const int f = points.layout().deformation;
    if (f >= 0) v[static_cast<std::size_t>(f)] = v[static_cast<std::size_t>(f + 3)] = 1;
    return point;
  }
  /// `count` points, each with its own mass, velocity and stress, anywhere in the middle part of the grid.
  void scatter_anywhere(int count, double part = 1) {
    const unsigned seed = 1;
    std::mt19937 random(seed);  // its numbers are the same everywhere, unlike those of distributions
    const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
    for (int i = 0; i < count; ++i) {
      const double x = (0.5 + part * (uniform() - 0.5)) * scene.width();
      auto point = point_at(x, (0.5 + part * (uniform() - 0.5)) * scene.height());
      point.id = static_cast<std::uint32_t>(i);
      point.values[mpm::moving::mass] = static_cast<Real>(0.5 + uniform());
      point.values[mpm::moving::volume] = static_cast<Real>(0.5 + uniform());
      for (const int f :
           {mpm::moving::vx, mpm::moving::vy, mpm::moving::sxx, mpm::moving::syy, mpm::moving::sxy})
        point.values[static_cast<std::size_t>(f)] = static_cast<Real>(2 * uniform() - 1);
      if (const int a = points.layout().affine; a >= 0)
        for (int k = 0; k < 4; ++k)
          point.values[static_cast<std::size_t>(a + k)] = static_cast<Real>(2 * uniform() - 1);
      points.insert(point);
    }
  }

  [[nodiscard]] double value(const typename Points::Slot& slot, int field) const {
    return static_cast<double>(points.value(slot, field));
  }
  mpm::moving::TileRow<Real> tiles(int row) {
    auto tiles = points.tile_row(row, static_cast<Real>(geometry.bottom_of(row)));
    if (folds) tiles.folds = {0, geometry.tiles_x - 1, row == 0, row == geometry.tiles_y - 1};
    return tiles;
  }
  void scatter() {
    for (int row = 0; row < points.rows(); ++row)
      sweeps.scatter(tiles(row), step, momentum.sums(row), force.sums(row));
    for (int row = 0; row < geometry.nodes_y; ++row) {
      const std::size_t at = grid.at(row);
      sweeps.sum_momentum(momentum.node_row(row), Real(0), &grid.mass[at], &grid.vx[at], &grid.vy[at]);
    }
  }
  /// Place of a node in the picture [m].
  [[nodiscard]] double node_x(int col) const { return (col - geometry.before) * plan.cell_size; }
  [[nodiscard]] double node_y(int row) const { return (row - geometry.before) * plan.cell_size; }

  /// Quantity `which` of `quantities` at a node, summed over the tiles that hold it.
  [[nodiscard]] double node_sum(mpm::TileSums<Real>& sums, int quantities, int which, int row, int col) {
    double sum = 0;
    for (int b = 0; b < geometry.reach; ++b)
      for (int a = 0; a < geometry.reach; ++a) {
        const int tile_row = row - b;
        const int tile_col = col - a;
        if (tile_row < 0 || tile_row >= geometry.tiles_y || tile_col < 0 || tile_col >= geometry.tiles_x)
          continue;
        const auto in = sums.sums(tile_row);
        sum += static_cast<double>(
            in.values[((b * geometry.reach + a) * quantities + which) * in.length + tile_col]);
      }
    return sum;
  }
  template <class Visit>
  void for_each_node(Visit&& visit) {
    for (int row = 0; row < geometry.nodes_y; ++row)
      for (int col = 0; col < geometry.nodes_x; ++col) visit(row, col);
  }
  template <class Visit>
  void for_each_point(Visit&& visit) {
    for (int row = 0; row < points.rows(); ++row) points.for_each(row, visit);
  }
  [[nodiscard]] double point_x(const typename Points::Slot& slot) const {
    return (slot.block * points.lanes() + slot.lane + geometry.tile_offset +
            static_cast<double>(points.value(slot, mpm::moving::xi))) *
           plan.cell_size;
  }
  [[nodiscard]] double point_y(const typename Points::Slot& slot) const {
    return (slot.row + geometry.tile_offset + static_cast<double>(points.value(slot, mpm::moving::eta))) *
           plan.cell_size;
  }
  [[nodiscard]] mpm::moving::NodeVectors<Real> fresh(int tile_row) const {
    const std::size_t at = grid.at(tile_row);
    return {&grid.fresh_x[at], &grid.fresh_y[at], grid.stride};
  }
  [[nodiscard]] mpm::moving::NodeVectors<Real> change(int tile_row) const {
    const auto& features = plan.moving.features;
    if (features.transfer == mpm::moving::Return::apic && features.stencil == mpm::moving::Stencil::linear)
      return fresh(tile_row);
    const std::size_t at = grid.at(tile_row);
    return {&grid.change_x[at], &grid.change_y[at], grid.stride};
  }
};

}  // namespace samples
