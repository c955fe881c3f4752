/// Displacements in equilibrium: conjugate gradients on the cells of the run, preconditioned by multigrid.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "libmpm/scene/scene.hpp"
#include "libmpm/solver/lattice/lattice_points.hpp"
#include "libmpm/solver/plan.hpp"
#include "libmpm/solver/quasi_static/conjugate_gradients.hpp"
#include "libmpm/solver/quasi_static/lattice_cells.hpp"
#include "libmpm/solver/quasi_static/multigrid.hpp"
#include "libmpm/solver/quasi_static/pieces.hpp"

namespace mpm {

/// Inverse of what each point resists, see equilibrium::PointRow.
struct Resistance {
  AlignedVector<float> tension, crush;
  double crush_share = 0;
};

/// The specimen between its platens at a platen strain of 1: the lower platen stands still, the upper one has
/// moved up by the height. With a fixture the leading load has moved by the height, and forces are over the
/// width, as if it were a platen. Points are those of the lattice.
class Equilibrium final : private LatticeCells {
 public:
  /// All points intact, nothing solved yet. The scene must outlive this.
  Equilibrium(const Scene& scene, const Plan& plan, const StrengthFactors& factors);
  Equilibrium(const Equilibrium&) = delete;
  Equilibrium& operator=(const Equilibrium&) = delete;

  /// Solve for the stiffness of now, from the displacements of before.
  /// @param reduction  of the error in the norm of the energy, over what it is at the start, [-]; an error of
  /// 1e-7 of the solution is always good enough.   @return whether it was reached.
  [[nodiscard]] bool solve(double reduction);

  /// Gives points another share of their stiffness, from the next solve on.
  struct Change {
    PointPlace at;
    double kept = 0;     ///< share of its stiffness that remains [-]
    double cracked = 0;  ///< share of its tensile strength that is lost, of a crack that can close [-]
  };
  void change(const std::vector<Change>& changes);

  /// Moves the parts of a specimen that no longer join the platens with their platens, free of stress.
  void part(const Pieces& pieces);

  /// All that points have gone through, as in another run of the same scene.
  struct Points {
    AlignedVector<double> stiffness, shear;  ///< see LatticePoints
    /// Of points that have a crack that can close, or are extra ones.
    std::vector<std::uint64_t> at;  ///< their number, see LatticeCells; rising
    std::vector<double> kept, cracked;
    std::vector<SeparatePoints::Told> told;
  };
  [[nodiscard]] Points all_points() const;
  /// @pre displacements() are those of that run.
  /// @return false for a stiffness that is none, or more than that of an intact point.
  [[nodiscard]] bool restore(const Points& points);

  /// Stress of the platens over their strain [Pa]: mean of both.
  /// With a fixture, what turns strain into energy.
  [[nodiscard]] double modulus() const { return 0.5 * (modulus_top_ + modulus_bottom_); }
  /// Force of the leading load over the width and the strain [Pa]; modulus() between platens.
  [[nodiscard]] double leading_modulus() const { return modulus_leading_; }
  /// Reading of a gauge of the scene at a platen strain of 1 [m].
  [[nodiscard]] double gauge(std::size_t index) const;
  [[nodiscard]] int missing_threads() const {
    return multigrid_->missing_threads();
  }  ///< that the system refused
  [[nodiscard]] double modulus_top() const { return modulus_top_; }
  [[nodiscard]] double modulus_bottom() const { return modulus_bottom_; }
  [[nodiscard]] std::int64_t iterations() const { return gradients_->iterations(); }  ///< so far

  /// Displacements of a cell over the platen strain [m].
  [[nodiscard]] CellDisplacement displacement(int row, int cell) const;
  using LatticeCells::cracked;
  using LatticeCells::each_extra;
  using LatticeCells::extra;
  using LatticeCells::in_cell;
  using LatticeCells::index;
  using LatticeCells::is_extra;
  using LatticeCells::kept;
  using LatticeCells::label;
  using LatticeCells::pixel;
  using LatticeCells::points;
  using LatticeCells::points_in_all;
  using LatticeCells::share;

  /// Calls visit(PointPlace) for all points of a row of cells, and those of padding cells.
  template <class Visit>
  void each_point(int row, const Visit& visit) const {
    for (int plane = 0; plane < points_.planes; ++plane)
      for (int cell = 0; cell < plan_.cells_x; ++cell) visit(PointPlace{row, plane, cell});
    each_extra(row, visit);
  }
  /// The same for those that largest_utilisation() does not know.
  template <class Visit>
  void each_separate(int row, const Visit& visit) const {
    separate_.each(row, visit);
  }
  /// Largest utilisation at a platen strain of 1 of the points at a place of the cells of a row.
  [[nodiscard]] double largest_utilisation(int row, int plane, const Resistance& resistance,
                                           double sign) const;
  /// Calls work(row) for all rows of cells, on all threads.
  template <class Work>
  void each_row(const Work& work) {
    gradients_->each_row([&](int row) {
      if (row < plan_.cells_y) work(row);
    });
  }

  [[nodiscard]] const NodeField& displacements() const { return u_; }
  [[nodiscard]] NodeField& displacements() { return u_; }

 private:
  [[nodiscard]] HeldNodes held(int row, int col) const override;

  void find_pinned_node();
  void make_multigrid();
  void move_platens();
  void move_loads();
  void read_reactions();
  void read_forces();
  [[nodiscard]] bool settle(double reduction);
  [[nodiscard]] double search(const NodeField& start, const NodeField& step);
  void take_caution(double caution);
  void follow_cracks();
  void follow(std::vector<Multigrid::Cell> changed);
  [[nodiscard]] CellDisplacement loaded(int row, int cell) const;
  [[nodiscard]] bool restore_separate(const Points& points);

  int pinned_ = 0;  ///< column of the node that a smooth lower platen holds sideways
  std::unique_ptr<Multigrid> multigrid_;
  std::unique_ptr<ConjugateGradients> gradients_;
  NodeField u_;
  double caution_ = SeparatePoints::most_caution;  ///< with which cracks are corrected
  double scale_ = 0;                               ///< norm of a uniform strain of 1 of the intact specimen
  double modulus_top_ = 0, modulus_bottom_ = 0, modulus_leading_ = 0;
  std::vector<char> held_x_, held_y_;  ///< by node, with a fixture
};

}  // namespace mpm
