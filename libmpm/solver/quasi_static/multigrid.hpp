/// One V-cycle of geometric multigrid for the cells of a picture, the preconditioner of Equilibrium.
///
/// The finest grid is that of the run and is never stored as a matrix. Each coarser one has cells of twice
/// the size, whose matrices are those of their four children seen through bilinear interpolation (Galerkin);
/// an odd cell at the end joins the last two, see CoarseAxis. When points fail, only the ancestors of their
/// cells are computed anew. Smoothing is by damped block
/// Jacobi, so that the result does not depend on the order of the nodes; the coarsest grid is solved
/// directly.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "libmpm/kernels/aligned.hpp"
#include "libmpm/kernels/equilibrium_kernels.hpp"
#include "libmpm/solver/force_buffer.hpp"
#include "libmpm/solver/grid.hpp"
#include "libmpm/solver/quasi_static/band_solver.hpp"
#include "libmpm/solver/quasi_static/coarse_axis.hpp"
#include "libmpm/solver/quasi_static/coarse_cell.hpp"
#include "libmpm/solver/quasi_static/staggered_sweep.hpp"

namespace mpm {

/// A vector at every node, shape (rows, stride) each; what lies beyond the columns stays zero.
template <class Real>
struct NodeFieldOf {
  AlignedVector<Real> x, y;

  [[nodiscard]] equilibrium::Values<Real> from(std::size_t node) {
    return {x.data() + node, y.data() + node};
  }
  [[nodiscard]] equilibrium::Values<const Real> from(std::size_t node) const {
    return {x.data() + node, y.data() + node};
  }
};
using NodeField = NodeFieldOf<double>;

/// Rows and columns of cells and of nodes.
struct CellShape {
  int cells_x = 0, cells_y = 0;

  [[nodiscard]] std::ptrdiff_t cell_stride() const { return padded(cells_x); }
  [[nodiscard]] std::ptrdiff_t stride() const { return padded(cells_x) + kernels::lane_cells; }  ///< of nodes
  [[nodiscard]] std::size_t nodes() const {
    return static_cast<std::size_t>(cells_y + 1) * static_cast<std::size_t>(stride());
  }
  [[nodiscard]] std::size_t node(int row, int col) const {
    return static_cast<std::size_t>(row * stride() + col);
  }
  [[nodiscard]] std::int64_t cells() const { return std::int64_t{cells_x} * cells_y; }
  template <class Real = double>
  [[nodiscard]] NodeFieldOf<Real> zeros() const {
    return {AlignedVector<Real>(nodes(), Real(0)), AlignedVector<Real>(nodes(), Real(0))};
  }
};

/// What is asked of the nodes along the edges of a grid.
enum class EdgeNodes {
  held,     ///< some nodes are held
  free,     ///< nothing: loads must be in balance, and displacements are known up to a rigid motion
  wrapped,  ///< opposite edges are the same nodes: displacements are known up to a translation
};

/// On a wrapped grid the nodes of the right and the upper edge are copies of those of the left and the lower
/// one. Displacements are the same in both; loads stand at the original, and are zero at its copies.
template <class Real>  ///< adds what stands at copies to the originals
void fold_loads(const CellShape& shape, NodeFieldOf<Real>& field);
template <class Real>
void copy_displacements(const CellShape& shape, NodeFieldOf<Real>& field);

/// The finest grid, as the multigrid sees it.
class FineGrid {
 public:
  virtual ~FineGrid() = default;
  [[nodiscard]] virtual CellShape shape() const = 0;
  /// Forces of a row of cells on its nodes: minus the stiffness times the displacement.
  virtual void forces(int row, const NodeField& u, kernels::NodeForces<double> lower,
                      kernels::NodeForces<double> upper) const = 0;
  /// The same of what corrects them; a grid that is stiffer here is corrected more cautiously.
  virtual void correction_forces(int row, const NodeFieldOf<float>& u, kernels::NodeForces<float> lower,
                                 kernels::NodeForces<float> upper) const = 0;
  virtual void correction_forces(int row, const NodeField& u, kernels::NodeForces<double> lower,
                                 kernels::NodeForces<double> upper) const = 0;
  [[nodiscard]] virtual CellModes cell(int row, int col) const = 0;
  /// Nodes of a cell that are held.
  [[nodiscard]] virtual HeldNodes held(int row, int col) const = 0;
  [[nodiscard]] virtual EdgeNodes edges() const { return EdgeNodes::held; }
  /// Of the stiffest thing over the softest one that matters [-].
  [[nodiscard]] virtual double contrast() const { return 1; }
};

/// Number of times that the grid can be made coarser.
[[nodiscard]] int coarsenings(int cells_x, int cells_y);

/// A cell by its row and column.
struct GridCell {
  int row = 0, col = 0;
};

/// @tparam Real  float or double; with 32 bits the rounding of the motion of something stiff costs as much
/// energy as what is soft has, where the contrast is large.
template <class Real>
class MultigridOf {
 public:
  using Correction = NodeFieldOf<Real>;  ///< of displacements, and the forces that ask for one

  /// @param fine  must outlive this.   @param threads  that share the rows; the bits are the same for any
  /// number.
  MultigridOf(const FineGrid& fine, int coarsenings, const equilibrium::Kernels& kernels, int threads = 1);

  using Cell = GridCell;
  /// Follows the finest grid, of which these cells have changed.   @pre it is not wrapped.
  void update(std::vector<Cell> cells);

  /// z = an approximation of the displacements under the loads r; zero where nodes are held.
  /// @pre r is zero for what is held, and on a wrapped grid at copies, see fold_loads().
  /// @param scratch  is overwritten.
  void precondition(const Correction& r, Correction& z, Correction& scratch);

  [[nodiscard]] Team& team() { return team_; }

  /// Inverse of the stiffness of each node of the finest grid; the diagonal is 0 for what is no unknown.
  struct NodeInverse {
    AlignedVector<Real> xx, xy, yy;
  };
  [[nodiscard]] const NodeInverse& inverse() const { return levels_.front().inverse; }

 private:
  struct Level {
    CellShape shape;
    CoarseAxis x, y;                          ///< over the finer grid
    AlignedVector<float> slants;              ///< of the columns of cells, see CellModes
    std::vector<char> has_modes;              ///< by row of cells; the others have matrices by nodes
    std::vector<int> place;                   ///< of a row in the one or the other
    AlignedVector<float> by_modes, by_nodes;  ///< of a coarser grid, see equilibrium::MatrixRow
    NodeInverse inverse;
    Correction load, solution, residual;  ///< empty for the finest grid
    StaggeredSweep<Real> sweeps;
  };

  void make_level(std::size_t level);
  void sort_rows(std::size_t level);
  [[nodiscard]] float* entries(std::size_t level, int row, int col);
  [[nodiscard]] const float* entries(const Level& level, int row, int col) const;
  [[nodiscard]] CellModes modes(std::size_t level, int row, int col) const;
  [[nodiscard]] CellStiffness cell(std::size_t level, int row, int col) const;
  [[nodiscard]] NodeStiffness corner(std::size_t level, int row, int col, int corner) const;
  void make_cell(std::size_t level, int row, int col);
  void make_node(std::size_t level, int row, int col);
  void factorise();
  /// Number of an unknown of the coarsest grid.
  [[nodiscard]] int unknown(int row, int col, int component) const;

  void cell_forces(std::size_t level, int row, const Correction& u, ForceBuffer<Real>& lower,
                   ForceBuffer<Real>& upper) const;
  using Kernel = void (*)(const equilibrium::NodeRow<Real>&);
  void node_row(const Level& level, int row, Kernel kernel, double weight, const ForceBuffer<Real>& below,
                const ForceBuffer<Real>& above, const Correction& load, Correction& out) const;
  void first_relax(const Level& level, int row, const Correction& load, Correction& u) const;
  void smooth(std::size_t level, const Correction& load, Correction& u, Correction& residual);
  void correct(std::size_t level, const Correction& load, Correction& u);
  void smooth_wrapped(std::size_t level, const Correction& load, Correction& u, Correction& residual);
  void correct_wrapped(std::size_t level, const Correction& load, Correction& u, Correction& residual);
  void relax_wrapped(std::size_t level, const Correction& load, Correction& u, Correction& residual,
                     double weight);
  void find_residual(std::size_t level, const Correction& load, const Correction& u, Correction& residual);
  void restrict_to(std::size_t level, const Correction& residual);
  void restrict_row(std::size_t level, int row, const AlignedVector<Real>& from,
                    AlignedVector<Real>& to) const;
  void interpolate(std::size_t level, int row, Correction& u) const;
  void cycle(std::size_t level, const Correction& load, Correction& u, Correction& residual);
  void solve_coarsest(const Correction& load, Correction& u);

  const FineGrid& fine_;
  EdgeNodes edges_;
  const equilibrium::Corrections<Real>& kernels_;
  Team team_;
  std::vector<Level> levels_;
  ForceBuffer<Real> no_forces_;
  AlignedVector<Real> no_row_;  ///< zeros, as long as a row of nodes
  BandSolver coarsest_;
  std::vector<double> unknowns_;  ///< of the coarsest grid
};

/// With as many bits as the contrast asks for.
class Multigrid {
 public:
  /// @param fine  must outlive this.   @param threads  that share the rows; the bits are the same for any
  /// number.
  Multigrid(const FineGrid& fine, int coarsenings, const equilibrium::Kernels& kernels, int threads = 1);

  using Cell = GridCell;
  /// Follows the finest grid, of which these cells have changed.   @pre it is not wrapped.
  void update(std::vector<Cell> cells);

  [[nodiscard]] const equilibrium::Kernels& kernels() const { return kernels_; }
  /// One of both is there.
  [[nodiscard]] MultigridOf<float>* single() const { return single_.get(); }
  [[nodiscard]] MultigridOf<double>* whole() const { return whole_.get(); }
  /// Threads that the system refused.
  [[nodiscard]] int missing_threads() const {
    return single_ ? single_->team().missing() : whole_->team().missing();
  }

 private:
  const equilibrium::Kernels& kernels_;
  std::unique_ptr<MultigridOf<float>> single_;
  std::unique_ptr<MultigridOf<double>> whole_;
};

}  // namespace mpm
