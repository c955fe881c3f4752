/// The background grid of moving points: tiles, nodes, and supports at its edges (platens, walls, planes of
/// symmetry).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "libmpm/kernels/aligned.hpp"
#include "libmpm/kernels/moving_kernels.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/solver/plan.hpp"

namespace mpm {

/// Rows and columns of cells, tiles and nodes. The grid reaches beyond the picture by the plan's margins; its
/// rows are stretched so that the top one stays at the top platen.
struct MovingGeometry {
  int cells_x = 0, cells_y = 0;  ///< of the grid
  int tiles_x = 0, tiles_y = 0;
  int nodes_x = 0, nodes_y = 0;  ///< a row and a column beyond each edge for quadratic shapes
  int reach = 0;                 ///< nodes of a tile along an axis
  int before = 0;                ///< rows of nodes below the lower edge of the grid; columns alike
  double tile_offset = 0;        ///< place of the first tile's left edge, in cells
  double left = 0, bottom = 0;   ///< corner of the grid in the picture [m]

  /// Lower edge of a row of tiles over the height of a cell.
  [[nodiscard]] double bottom_of(int tile_row) const { return tile_row + tile_offset; }
};
[[nodiscard]] MovingGeometry moving_geometry(const Scene& scene, const Plan& plan);

/// State of the nodes in a step, shape (nodes_y, stride) each.
template <class Real>
struct MovingGrid {
  std::ptrdiff_t stride = 0;
  AlignedVector<Real> mass;                ///< [kg/m]
  AlignedVector<Real> vx, vy;              ///< velocity mapped from the points [m/s]
  AlignedVector<Real> fresh_x, fresh_y;    ///< velocity at the end of the step [m/s]
  AlignedVector<Real> change_x, change_y;  ///< its change in the step [m/s]
  AlignedVector<Real> strain_x, strain_y;  ///< velocity that strains the points [m/s]

  [[nodiscard]] std::size_t at(int row, int col = 0) const {
    return static_cast<std::size_t>(row * stride + col);
  }
};
template <class Real>
[[nodiscard]] MovingGrid<Real> make_moving_grid(const MovingGeometry& geometry);

/// Sums of the rows of tiles for their nodes: `quantities` planes for each node of a tile, with zeros round
/// them. Within a band of rows, which one thread sweeps upwards, a row gives way to the next one that needs
/// its place once its nodes are done, so that sums stay in the cache; those at the ends of a band are kept.
template <class Real>
class TileSums {
 public:
  TileSums() = default;
  /// @param band_ends  rows of tiles at which the bands end, rising.
  TileSums(const MovingGeometry& geometry, int quantities, const std::vector<int>& band_ends);

  [[nodiscard]] moving::Sums<Real> sums(int tile_row);
  /// The sums that meet in a row of nodes.
  [[nodiscard]] moving::NodeRow<Real> node_row(int row) const;
  /// Sums of a row without points.
  void clear(int tile_row);
  /// Sums of a row with points are about to be written.
  void mark_filled(int tile_row) { is_zero_[place(tile_row)] = 0; }

 private:
  [[nodiscard]] std::size_t place(int tile_row) const { return places_[static_cast<std::size_t>(tile_row)]; }
  [[nodiscard]] const Real* row(int tile_row) const;

  int tiles_y_ = 0, reach_ = 0, nodes_ = 0;
  std::ptrdiff_t length_ = 0;
  std::size_t row_size_ = 0;
  std::vector<std::size_t> places_;  ///< of the rows of tiles, in units of row_size_
  AlignedVector<Real> values_;
  std::vector<std::uint8_t> is_zero_;  ///< by place
  AlignedVector<Real> zeros_;
};

struct Support {
  bool active = false;     ///< there is a support
  bool separates = false;  ///< the specimen may separate from it
  bool rough = false;      ///< no sliding
  double velocity = 0;     ///< of its own in this step, in the direction of x or y [m/s]
  double before = 0;       ///< in the step before [m/s]

  /// Velocity along an axis that a support gives to a node, and that which the node is taken to have had
  /// [m/s].
  struct Held {
    double velocity = 0, before = 0;
  };
  /// Velocity of a node normal to the support; nothing if the node separates or there is no support.
  ///
  /// For a node that stays at a support, the old velocity is that of the support, not the mean of the points
  /// beside it; otherwise FLIP would remove the velocity differences of these points step by step. So a plane
  /// of symmetry replaces the other half of a body. A node that comes into contact has the velocity mapped
  /// from its points.
  /// @param brought  velocity mapped from the points [m/s].   @param change  change by the forces of the step
  /// [m/s].
  /// @param outward  +1 at the right and upper edge, else -1.   @param touched  in the step before.
  [[nodiscard]] std::optional<Held> caught(double brought, double change, int outward, bool touched) const {
    if (!active) return std::nullopt;
    const bool stays = touched && outward * (before + change - velocity) > 0;
    if (!separates || stays) return Held{velocity, before};
    if (outward * (brought + change - velocity) > 0) return Held{velocity, brought};
    return std::nullopt;
  }
};

/// The four edges.
struct Supports {
  Support left, right, bottom, top;
};

/// Supports of a scene; the top platen stands still.
[[nodiscard]] Supports supports_of(const Scene& scene);

}  // namespace mpm
