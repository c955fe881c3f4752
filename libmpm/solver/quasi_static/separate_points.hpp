/// Points that the sweeps over rows of cells leave out, for equilibrium: extra points, which stand at any
/// place of their cell, and those with cracks that close again, whose stiffness depends on the displacements.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "libmpm/kernels/lattice_kernels.hpp"
#include "libmpm/solver/lattice/lattice_points.hpp"
#include "libmpm/solver/quasi_static/coarse_cell.hpp"

namespace mpm {

/// Stiffness of a cracked point under a strain, by the law of CrackClosure::unilateral: the derivative of its
/// stress. That stress is in proportion to the strain as long as its direction stays, so that it is this
/// stiffness times the strain.
/// @param elastic   of its phase, see stiffness(const Phase&, Plane) [Pa].
/// @param cracked   share of its tensile strength that is lost [-].
/// @param strain    e_xx, e_yy, gamma_xy, in any unit.
[[nodiscard]] Eigen::Matrix3d cracked_stiffness(const Eigen::Matrix3d& elastic, double cracked,
                                                const Eigen::Vector3d& strain);

/// A point: of the lattice, see LatticePoints; an extra point has the plane K K + its number in the order of
/// make_extra_points().
struct PointPlace {
  int row = 0, plane = 0, cell = 0;
};

class SeparatePoints {
 public:
  struct Place {
    PointPlace at;
    std::size_t index = 0;   ///< of the point, any number below that of the constructor
    double xi = 0, eta = 0;  ///< in its cell, in [0, 1]
  };
  /// What the point is made of.
  struct Kind {
    Eigen::Matrix3d elastic;       ///< of its phase, times its share of its pixel [Pa]
    bool resists_bending = false;  ///< that of its cell
  };
  struct State {
    double kept = 1;     ///< share of its stiffness that remains [-]
    double cracked = 0;  ///< share of its tensile strength that is lost, of a crack that can close [-]
  };

  /// None yet.   @param points  how many there can be.
  SeparatePoints(int rows, std::size_t points)
      : rows_(static_cast<std::size_t>(rows)), states_(points, State{-1, 0}) {}

  /// Adds a point, or gives it another state.
  void put(const Place& place, const Kind& kind, const State& state);
  /// Takes a point away, if it is there.
  void remove(int row, std::size_t index);
  /// State of a point; nullopt if it is none of these.
  [[nodiscard]] std::optional<State> state(std::size_t index) const {
    return has(index) ? std::optional(states_[index]) : std::nullopt;
  }
  /// Calls visit(const Place&) for the points of a row of cells.
  template <class Visit>
  void each(int row, const Visit& visit) const {
    for (const Point& point : rows_[static_cast<std::size_t>(row)].points) visit(point.place);
  }
  [[nodiscard]] bool empty() const { return count_ == 0; }
  [[nodiscard]] bool may_have_any() const { return !states_.empty(); }
  /// Whether the stiffness of some point depends on the displacements.
  [[nodiscard]] bool any_cracked() const { return cracked_ > 0; }

  /// Takes the stiffness of the points of a row of cells at other displacements.
  /// @param displacement  of a cell, by its column [m].
  /// @param caution  share of its stiffness that an open crack keeps for corrections [-].
  template <class Displacement>
  void follow(int row, double caution, const Displacement& displacement) {
    for (Point& point : rows_[static_cast<std::size_t>(row)].points)
      take_stiffness(point, caution, displacement(point.place.at.cell));
    write(rows_[static_cast<std::size_t>(row)]);
  }
  static constexpr double most_caution = 1e-2;
  struct Cell {
    int row = 0, col = 0;
  };
  /// Cells whose stiffness has changed since this was asked before, by more than a preconditioner bears.
  [[nodiscard]] std::vector<Cell> changed();

  /// Adds the forces on the nodes of a row of cells: minus the stiffness times their displacements [m].
  void add_forces(int row, const kernels::CellRow<double, double>& in) const;
  void add_correction_forces(int row, const kernels::CellRow<double, double>& in) const;
  void add_correction_forces(int row, const kernels::CellRow<float, float>& in) const;
  /// What they add to the stiffness of a cell, as changed() has told it last.
  [[nodiscard]] CellModes in_cell(int row, int cell) const;

  /// What changed() has told last of a point, for an archive: upper triangle of the stiffness, row by row.
  using Told = std::array<double, 6>;
  [[nodiscard]] std::vector<Told> told() const;
  /// @return false for a list of another length, or of what is no number.
  [[nodiscard]] bool set_told(const std::vector<Told>& all);

 private:
  struct Point {
    Place place;
    Kind kind;
    State state;
    Eigen::Matrix3d now;          ///< stiffness [Pa]
    Eigen::Matrix3d cautious;     ///< for corrections [Pa]
    Eigen::Matrix3d bound, told;  ///< with most caution, and that of which changed() has told [Pa]
  };
  /// What a sweep needs of a point.
  template <class Real>
  struct Acting {
    int cell;
    Real xi, eta, bending;
    Real stiffness[6];  ///< as in Told
  };
  struct Row {
    std::vector<Point> points;  ///< by cell, then by index
    std::vector<Acting<double>> exact, cautious;
    std::vector<Acting<float>> single;  ///< cautious
  };

  [[nodiscard]] bool has(std::size_t index) const { return !states_.empty() && states_[index].kept >= 0; }
  static void take_stiffness(Point& point, double caution, const CellDisplacement& u);
  [[nodiscard]] static double bending_of(const Point& point);
  static void write(Row& row);
  template <class Real>
  static void add(const std::vector<Acting<Real>>& points, const kernels::CellRow<Real, Real>& in);

  std::vector<Row> rows_;
  std::vector<State> states_;  ///< by index; kept < 0: not there
  std::size_t count_ = 0, cracked_ = 0;
};

}  // namespace mpm
