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
/// moved up by the height. Points are those of the lattice.
class Equilibrium final : private LatticeCells {
 public:
  /// All points intact, nothing solved yet. The scene must outlive this.
  Equilibrium(const Scene& scene, const Plan& plan, const StrengthFactors& factors);
  Equilibrium(const Equilibrium&) = delete;
  Equilibrium& operator=(const Equilibrium&) = delete;

  /// Solve for the stiffness of now, from the displacements of before.
  /// @param reduction  of the error in the norm of the energy, over what it is at the start, [-]; an error of
  /// 1e-7 of
  ///                   the solution is always good enough.   @return whether it was reached.
  [[nodiscard]] bool solve(double reduction);

  /// Gives points another share of their stiffness, from the next solve on.
  struct Change {
    int row = 0, plane = 0, cell = 0;  ///< see LatticePoints
    double kept = 0;                   ///< share of its stiffness that remains [-]
  };
  void change(const std::vector<Change>& changes);

  /// Moves the parts of a specimen that no longer join the platens with their platens, free of stress.
  void part(const Pieces& pieces);

  /// Takes over what points() held in another run of the same scene.
  /// @return false for a stiffness that is none, or more than that of an intact point.
  [[nodiscard]] bool restore(const AlignedVector<double>& stiffness, const AlignedVector<double>& shear);

  /// Stress of the platens over their strain [Pa]: mean of both.
  [[nodiscard]] double modulus() const { return 0.5 * (modulus_top_ + modulus_bottom_); }
  [[nodiscard]] int missing_threads() const {
    return multigrid_->missing_threads();
  }  ///< that the system refused
  [[nodiscard]] double modulus_top() const { return modulus_top_; }
  [[nodiscard]] double modulus_bottom() const { return modulus_bottom_; }
  [[nodiscard]] std::int64_t iterations() const { return gradients_->iterations(); }  ///< so far

  /// Displacements of a cell over the platen strain [m].
  [[nodiscard]] CellDisplacement displacement(int row, int cell) const;
  using LatticeCells::kept;
  using LatticeCells::label;
  using LatticeCells::pixel;
  using LatticeCells::points;

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
  void read_reactions();

  int pinned_ = 0;  ///< column of the node that a smooth lower platen holds sideways
  std::unique_ptr<Multigrid> multigrid_;
  std::unique_ptr<ConjugateGradients> gradients_;
  NodeField u_;
  double modulus_top_ = 0, modulus_bottom_ = 0;
};

}  // namespace mpm
