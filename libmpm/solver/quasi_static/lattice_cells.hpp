/// The cells of a run as a grid for the multigrid: points that lose stiffness, between nodes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "libmpm/kernels/lattice_kernels.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/solver/lattice/lattice_points.hpp"
#include "libmpm/solver/plan.hpp"
#include "libmpm/solver/quasi_static/multigrid.hpp"
#include "libmpm/solver/quasi_static/separate_points.hpp"

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
  void correction_forces(int row, const NodeFieldOf<float>& u, kernels::NodeForces<float> lower,
                         kernels::NodeForces<float> upper) const override;
  void correction_forces(int row, const NodeField& u, kernels::NodeForces<double> lower,
                         kernels::NodeForces<double> upper) const override;
  [[nodiscard]] CellModes cell(int row, int col) const override;
  [[nodiscard]] double contrast() const override;

  [[nodiscard]] const LatticePoints<double>& points() const { return points_; }
  [[nodiscard]] const ExtraPoints& extra_points() const { return extra_; }
  [[nodiscard]] bool is_extra(const PointPlace& at) const { return at.plane >= points_.planes; }
  [[nodiscard]] const CellPoint& extra(const PointPlace& at) const {
    return extra_.points[static_cast<std::size_t>(at.plane - points_.planes)];
  }
  /// Calls visit(PointPlace) for the extra points of a row of cells.
  template <class Visit>
  void each_extra(int row, const Visit& visit) const;
  /// Number of a point, below points_in_all(); those of the lattice as in LatticePoints, then the extra ones.
  [[nodiscard]] std::size_t index(const PointPlace& at) const {
    return is_extra(at) ? points_.stiffness.size() + static_cast<std::size_t>(at.plane - points_.planes)
                        : points_.at(at.row, at.plane, at.cell);
  }
  [[nodiscard]] std::size_t points_in_all() const { return points_.stiffness.size() + extra_.points.size(); }

  /// Pixel of a point of the lattice; those of padding cells lie beyond the picture.
  [[nodiscard]] Pixel pixel(const PointPlace& at) const;
  /// Label of a point; nullptr for void and beyond the picture.
  [[nodiscard]] const std::uint8_t* label(const PointPlace& at) const;
  /// Place in its cell, each in [0, 1].
  struct InCell {
    double xi, eta;
  };
  [[nodiscard]] InCell in_cell(const PointPlace& at) const;
  /// Share of its pixel that a point has [-].
  [[nodiscard]] double share(const PointPlace& at) const;

  /// Share of its stiffness that a point has [-]; of a crack that can close, when it is closed.
  [[nodiscard]] double kept(const PointPlace& at) const;
  /// Share of its tensile strength that a point has lost, whose crack can close [-].
  [[nodiscard]] double cracked(const PointPlace& at) const {
    const auto state = separate_.state(index(at));
    return state ? state->cracked : 0;
  }
  /// Gives a point another share of its stiffness, and a crack that can close.
  /// @return false where there is none.
  bool keep(const PointPlace& at, double share, double cracked = 0);

 protected:
  /// Of a phase with Young's modulus 1 and the plan's Poisson ratio [-].
  [[nodiscard]] const Eigen::Matrix3d& unit_stiffness() const { return unit_stiffness_; }
  /// Takes over what points() held in another run.
  void take_over(const AlignedVector<double>& stiffness, const AlignedVector<double>& shear);

  const Scene& scene_;
  Plan plan_;
  LatticePoints<double> points_;
  ExtraPoints extra_;
  SeparatePoints separate_;

 private:
  /// What points_ hold, in 32 bits.
  struct Single {
    AlignedVector<float> stiffness, shear;
  };

  void round_points();
  /// Stiffness over that of a whole pixel [-].
  [[nodiscard]] double share_of(std::uint8_t label, std::size_t at) const;
  void put_separate(const PointPlace& at, std::uint8_t label, double kept, double cracked);
  void store(std::size_t at, std::uint8_t label, double share);
  template <class Real>
  [[nodiscard]] kernels::CellRow<Real, Real> cell_row(int row, const NodeFieldOf<Real>& u,
                                                      kernels::NodeForces<Real> lower,
                                                      kernels::NodeForces<Real> upper) const;

  PixelField<std::uint16_t> points_of_pixels_;  ///< empty without extra points
  PointStiffness stiffness_;
  std::vector<double> intact_;  ///< what points_ hold of an intact point, by label [Pa]
  Eigen::Matrix3d unit_stiffness_;
  kernels::SweepCells<double> sweep_cells_;
  kernels::SweepCells<float, float> sweep_corrections_;
  Single single_;
};

template <class Visit>
void LatticeCells::each_extra(int row, const Visit& visit) const {
  if (extra_.points.empty()) return;
  const std::size_t end = extra_.row_begin[static_cast<std::size_t>(row) + 1];
  for (std::size_t i = extra_.row_begin[static_cast<std::size_t>(row)]; i < end; ++i)
    visit(PointPlace{row, points_.planes + static_cast<int>(i), extra_.points[i].cell});
}

}  // namespace mpm
