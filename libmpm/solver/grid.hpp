/// The background grid: nodes in rows, row 0 at the bottom.
#pragma once

#include <cstddef>

#include "libmpm/kernels/aligned.hpp"
#include "libmpm/kernels/lattice_kernels.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/solver/plan.hpp"

namespace mpm {

/// n rounded up to a whole number of lanes.
[[nodiscard]] constexpr int padded(int n) {
  return (n + kernels::lane_cells - 1) / kernels::lane_cells * kernels::lane_cells;
}

/// State of the nodes, shape (rows, stride) each; what lies beyond `cols` is padding without mass.
struct Grid {
  int rows = 0;                             ///< cells_y + 1
  int cols = 0;                             ///< cells_x + 1
  std::ptrdiff_t stride = 0;                ///< between rows
  AlignedVector<double> ux, uy;             ///< displacement [m]
  AlignedVector<double> vx, vy;             ///< velocity, half a step behind the displacement [m/s]
  AlignedVector<double> impulse_over_mass;  ///< dt / (K^2 m_i) [s m/kg]; 0 for a node without mass

  [[nodiscard]] std::ptrdiff_t at(int row, int col = 0) const { return row * stride + col; }
};

/// Grid at rest with the lumped mass of the scene's points (linear weights).
[[nodiscard]] Grid make_grid(const Scene& scene, const Plan& plan);

/// Of the columns for which a property holds the one nearest the middle, the left one of two; the middle when
/// there is none.
template <class Property>
[[nodiscard]] int nearest_to_middle(int cols, Property&& holds) {
  const int middle = cols / 2;
  for (int distance = 0; distance < cols; ++distance)
    for (const int col : {middle - distance, middle + distance})
      if (col >= 0 && col < cols && holds(col)) return col;
  return middle;
}

/// Number of material points that share each pixel: 1, and one more for every extra point in it.
[[nodiscard]] PixelField<std::uint16_t> points_per_pixel(const Scene& scene);

/// Pixel in which a place lies.
struct Pixel {
  int row = 0, col = 0;
};
[[nodiscard]] Pixel pixel_at(const Scene& scene, double x, double y);

}  // namespace mpm
