/// Material points of the lattice in the layout of the sweeps; and extra points, which are few and computed
/// one by one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "libmpm/kernels/aligned.hpp"
#include "libmpm/kernels/lattice_kernels.hpp"
#include "libmpm/material/failure.hpp"
#include "libmpm/material/strength.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/solver/plan.hpp"

namespace mpm {

/// Constants of the points, in planes by their place in the cell: shape (cells_y, K K, stride).
/// The sweeps work with strain times cell size. With one Poisson ratio the stress is also divided by Young's
/// modulus; without, it is multiplied by the point's share of its pixel. `scale` turns a stress [Pa] into
/// that measure.
template <class Real>
struct LatticePoints {
  int planes = 0;                        ///< K K
  std::ptrdiff_t stride = 0;             ///< between planes: padded cells_x
  AlignedVector<Real> stiffness, shear;  ///< shear: empty with one Poisson ratio
  /// Empty where the plan has no use for them. cracked: see PointState. With one Poisson ratio the sweeps see
  /// the stress of the intact point, so that thresholds grow as the stiffness is lost.
  AlignedVector<float> tension, crush, cracked;

  [[nodiscard]] std::ptrdiff_t row(int cell_row) const { return cell_row * planes * stride; }
  [[nodiscard]] std::size_t at(int cell_row, int plane, int cell) const {
    return static_cast<std::size_t>(row(cell_row) + plane * stride + cell);
  }
};

/// Points of a scene with their thresholds drawn.
template <class Real>
[[nodiscard]] LatticePoints<Real> make_points(const Scene& scene, const Plan& plan,
                                              const StrengthFactors& factors);

/// What the place of a point says of it, and how it is written there.
struct PointKind {
  const Phase* phase = nullptr;
  double factor = 1;  ///< on its strength [-]
  double share = 1;   ///< of its pixel [-]
};
template <class Real>
[[nodiscard]] PointState read_point(const LatticePoints<Real>& points, std::size_t at, const Scene& scene,
                                    const Plan& plan, const PointKind& kind);
template <class Real>
void write_point(LatticePoints<Real>& points, std::size_t at, const Scene& scene, const Plan& plan,
                 const PointKind& kind, const PointState& point);

/// Factor from a stress [Pa] to the measure of the sweeps.
[[nodiscard]] double threshold_scale(const Plan& plan, const Phase& phase, double share);

/// Displacements of the nodes of a cell [m]: lower left, lower right, upper left, upper right.
struct CellDisplacement {
  double ux[4], uy[4];
};

/// Stiffness of a pixel cell against each of its two bending modes, per unit of the difference of the strains
/// of opposite edges [Pa]; see the kernel.
[[nodiscard]] double bending_stiffness(const Eigen::Matrix3d& stiffness);

/// Amplitude of the bending mode of a component of the displacement, over the size of the cell [-].
[[nodiscard]] inline double bending(const double (&u)[4], double cell_size) {
  return (u[0] - u[1] - u[2] + u[3]) / cell_size;
}

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
