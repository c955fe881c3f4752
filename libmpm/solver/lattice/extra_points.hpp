/// Material points beside those of the pixels. They are few, so they are swept one by one.
#pragma once

#include <cstdint>
#include <vector>

#include "libmpm/material/failure.hpp"
#include "libmpm/kernels/kernels.hpp"
#include "libmpm/solver/plan.hpp"
#include "libmpm/scene/scene.hpp"

namespace mpm {

/// Displacements of the nodes of a cell [m]: lower left, lower right, upper left, upper right.
struct CellDisplacement {
  double ux[4], uy[4];
};

/// Stress of a phase at a place of a cell under the displacements of its nodes [Pa]. xi, eta in [0, 1].
[[nodiscard]] Stress<double> stress_in_cell(const Eigen::Matrix3d& stiffness, const CellDisplacement& u,
                                            double xi, double eta, double cell_size);

/// An extra point in its cell.
struct CellPoint {
  int cell = 0;            ///< column of cells
  double xi = 0, eta = 0;  ///< place in the cell, in [0, 1]
  double share = 1;        ///< of its pixel's volume [-]
  PointState state;
  Eigen::Matrix3d stiffness;  ///< of its phase [Pa]
  std::size_t index = 0;      ///< in Scene::extra_points
};

struct ExtraPoints {
  std::vector<CellPoint> points;       ///< sorted by row of cells
  std::vector<std::size_t> row_begin;  ///< shape (cells_y + 1); empty when there are no extra points
};

[[nodiscard]] ExtraPoints make_extra_points(const Scene& scene, const Plan& plan);

/// Forces of a point on the four nodes of its cell, in the scale of the sweeps.
struct CellForces {
  double x[4], y[4];
};
[[nodiscard]] CellForces forces_in_cell(const Stress<double>& stress, double xi, double eta, double scale);

}  // namespace mpm
