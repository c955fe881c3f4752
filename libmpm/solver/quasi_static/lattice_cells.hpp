/// The cells of a run as a grid for the multigrid: points that lose stiffness, between nodes.
#pragma once

#include <vector>

#include "libmpm/kernels/lattice_kernels.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/solver/lattice/lattice_points.hpp"
#include "libmpm/solver/plan.hpp"
#include "libmpm/solver/quasi_static/multigrid.hpp"

namespace mpm {

/// All that a FineGrid is but its support. Forces count the points of a cell K x K times, as the sweeps do.
class LatticeCells : public FineGrid {
 public:
  /// All points intact. The scene must outlive this.
  /// @param plan  whose cells may go beyond the picture; there is nothing.
  LatticeCells(const Scene& scene, const Plan& plan, const StrengthFactors& factors);

  [[nodiscard]] CellShape shape() const override { return {plan_.cells_x, plan_.cells_y}; }
  void forces(int row, const NodeField& u, kernels::NodeForces<double> lower,
              kernels::NodeForces<double> upper) const override;
  void forces(int row, const NodeFieldOf<float>& u, kernels::NodeForces<float> lower,
              kernels::NodeForces<float> upper) const override;
  [[nodiscard]] CellModes cell(int row, int col) const override;
  [[nodiscard]] double contrast() const override;

  [[nodiscard]] const LatticePoints<double>& points() const { return points_; }
  /// Pixel of a point; those of padding cells lie beyond the picture.
  [[nodiscard]] Pixel pixel(int row, int plane, int cell) const;
  /// Label of the pixel of a point; nullptr for void and beyond the picture.
  [[nodiscard]] const std::uint8_t* label(int row, int plane, int cell) const;
  /// Share of its stiffness that a point has [-].
  [[nodiscard]] double kept(int row, int plane, int cell) const {
    const std::uint8_t* of = label(row, plane, cell);
    return of != nullptr ? share_of(*of, points_.at(row, plane, cell)) : 0;
  }
  /// Gives a point another share of its stiffness.   @return false where there is none.
  bool keep(int row, int plane, int cell, double share);

 protected:
  /// Of a phase with Young's modulus 1 and the plan's Poisson ratio [-].
  [[nodiscard]] const Eigen::Matrix3d& unit_stiffness() const { return unit_stiffness_; }
  /// Takes over what points() held in another run.
  void take_over(const AlignedVector<double>& stiffness, const AlignedVector<double>& shear);

  const Scene& scene_;
  Plan plan_;
  LatticePoints<double> points_;

 private:
  /// What points_ hold, in 32 bits.
  struct Single {
    AlignedVector<float> stiffness, shear;
  };

  void round_points();
  [[nodiscard]] double share_of(std::uint8_t label, std::size_t at) const;

  PointStiffness stiffness_;
  std::vector<double> intact_;  ///< what points_ hold of an intact point, by label [Pa]
  Eigen::Matrix3d unit_stiffness_;
  kernels::SweepCells<double> sweep_cells_;
  kernels::SweepCells<float, float> sweep_corrections_;
  Single single_;
};

}  // namespace mpm
