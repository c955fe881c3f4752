/// One V-cycle of geometric multigrid for the cells of a picture, the preconditioner of Equilibrium.
///
/// The finest grid is that of the run and is never stored as a matrix. Each coarser one has cells of twice
/// the size, whose matrices are those of their four children seen through bilinear interpolation (Galerkin);
/// an odd cell at the end joins the last two, see CoarseAxis. When points fail, only the ancestors of their
/// cells are computed anew. Smoothing is by damped block Jacobi, so that the result does not depend on the
/// order of the nodes; the coarsest grid is solved directly.
#pragma once

#include <cstddef>
#include <vector>

#include "libmpm/kernels/aligned.hpp"
#include "libmpm/kernels/equilibrium_kernels.hpp"
#include "libmpm/solver/force_buffer.hpp"
#include "libmpm/solver/grid.hpp"
#include "libmpm/solver/quasi_static/band_solver.hpp"
#include "libmpm/solver/quasi_static/coarse_axis.hpp"
#include "libmpm/solver/quasi_static/coarse_cell.hpp"

namespace mpm {

/// A vector at every node, shape (rows, stride) each; what lies beyond the columns stays zero.
struct NodeField {
  AlignedVector<double> x, y;
};

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
  [[nodiscard]] NodeField zeros() const {
    return {AlignedVector<double>(nodes(), 0.0), AlignedVector<double>(nodes(), 0.0)};
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
void fold_loads(const CellShape& shape, NodeField& field);  ///< adds what stands at copies to the originals
void copy_displacements(const CellShape& shape, NodeField& field);

/// The finest grid, as the multigrid sees it.
class FineGrid {
 public:
  virtual ~FineGrid() = default;
  [[nodiscard]] virtual CellShape shape() const = 0;
  /// Forces of a row of cells on its nodes: minus the stiffness times the displacement.
  virtual void forces(int row, const NodeField& u, kernels::NodeForces<double> lower,
                      kernels::NodeForces<double> upper) const = 0;
  [[nodiscard]] virtual CellStiffness cell(int row, int col) const = 0;
  /// Nodes of a cell that are held.
  [[nodiscard]] virtual HeldNodes held(int row, int col) const = 0;
  /// Sets the components of held nodes to zero.
  virtual void clear_held(NodeField& field) const = 0;
  [[nodiscard]] virtual EdgeNodes edges() const { return EdgeNodes::held; }
};

/// Number of times that the grid can be made coarser.
[[nodiscard]] int coarsenings(int cells_x, int cells_y);

class Multigrid {
 public:
  /// @param fine  must outlive this.
  Multigrid(const FineGrid& fine, int coarsenings, const equilibrium::Kernels& kernels);

  struct Cell {
    int row = 0, col = 0;
  };
  /// Follows the finest grid, of which these cells have changed.   @pre it is not wrapped.
  void update(std::vector<Cell> cells);

  /// z = an approximation of the displacements under the loads r; zero where nodes are held.
  /// @pre on a wrapped grid r is zero at copies, see fold_loads().
  void precondition(const NodeField& r, NodeField& z);

  /// out = load minus stiffness times u, for every node, held or not, copies not folded. out must be another
  /// field than u.
  void residual(const NodeField& load, const NodeField& u, NodeField& out);

 private:
  struct Level {
    CellShape shape;
    CoarseAxis x, y;                      ///< over the finer grid
    AlignedVector<float> matrices;        ///< of a coarser grid, see equilibrium::MatrixRow
    AlignedVector<double> xx, xy, yy;     ///< inverse of the stiffness of each node
    NodeField load, solution, residual;   ///< empty for the finest grid but the residual
    ForceBuffer<double> upper[2], lower;  ///< of the row of cells at hand and of the one below
  };

  [[nodiscard]] CellStiffness cell(std::size_t level, int row, int col) const;
  void make_cell(std::size_t level, int row, int col);
  void make_node(std::size_t level, int row, int col);
  void factorise();
  /// Number of an unknown of the coarsest grid.
  [[nodiscard]] int unknown(int row, int col, int component) const;
  void cell_forces(Level& level, std::size_t index, int row, const NodeField& u, ForceBuffer<double>& lower,
                   ForceBuffer<double>& upper);
  using Kernel = void (*)(const equilibrium::RelaxRow&);
  void sweep(std::size_t index, const NodeField& load, const NodeField& u, NodeField& out, Kernel kernel,
             double weight);
  void relax(std::size_t level, const NodeField& load, NodeField& u, double weight);
  void find_residual(std::size_t level, const NodeField& load, const NodeField& u);
  void first_relax(std::size_t level, const NodeField& load, NodeField& u) const;
  void add_relaxed(const Level& level, const NodeField& load, NodeField& u, double weight) const;
  void cycle(std::size_t level, const NodeField& load, NodeField& u);
  void solve_coarsest(const NodeField& load, NodeField& u);

  const FineGrid& fine_;
  EdgeNodes edges_;
  const equilibrium::Kernels& kernels_;
  std::vector<Level> levels_;
  ForceBuffer<double> no_forces_;
  BandSolver coarsest_;
  std::vector<double> unknowns_;  ///< of the coarsest grid
};

}  // namespace mpm
