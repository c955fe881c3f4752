/// Displacements in equilibrium: conjugate gradients on the finest grid, preconditioned by multigrid.
#pragma once

#include <cstdint>

#include "libmpm/solver/quasi_static/multigrid.hpp"

namespace mpm {

class ConjugateGradients {
 public:
  /// Both must outlive this.
  ConjugateGradients(const FineGrid& fine, Multigrid& multigrid);

  /// Improves displacements whose components at held nodes are right; on a wrapped grid whose differences
  /// between copy and original are.
  /// @param reduction  of the error in the norm of the energy, over what it is at the start [-]
  /// @param accuracy  error over the solution in that norm that is always good enough [-]
  /// @param load  at the nodes, in the unit of FineGrid::forces(); none = zero.
  /// @return whether one of both was reached.
  [[nodiscard]] bool solve(NodeField& u, double reduction, double accuracy, const NodeField* load = nullptr);

  /// Load minus stiffness times u at every node: what holds it there. Valid until the next call.
  [[nodiscard]] const NodeField& unbalanced(const NodeField& u, const NodeField* load = nullptr);

  [[nodiscard]] std::int64_t iterations() const { return iterations_; }  ///< of all solves

 private:
  void leave_unknowns(NodeField& field) const;

  const FineGrid& fine_;
  Multigrid& multigrid_;
  NodeField no_load_, residual_, preconditioned_, direction_, image_;
  std::int64_t iterations_ = 0;
};

/// Scalar product over all nodes; row by row, so that it is the same for any number of threads.
[[nodiscard]] double dot(const CellShape& shape, const NodeField& a, const NodeField& b);

}  // namespace mpm
