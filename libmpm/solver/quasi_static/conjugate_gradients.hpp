/// Displacements in equilibrium: conjugate gradients on the finest grid, preconditioned by multigrid.
///
/// The displacements have 64 bits, and so have the forces that they leave unbalanced when they are computed
/// from them; what corrects them has 32 bits. When the forces have become as small as 32 bits can follow,
/// they are computed again.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "libmpm/solver/quasi_static/multigrid.hpp"

namespace mpm {

/// When a solution is good enough.
struct SolutionGoal {
  double reduction = 0;   ///< of the error in the norm of the energy, over what it is at the start [-]
  double accuracy = 0;    ///< or error over the solution in that norm [-]
  double error = 0;       ///< or error in that norm, as of error_at_start()
  int iterations = 2000;  ///< after which it is given up
};

/// @tparam Real  of what corrects the displacements.
template <class Real>
class GradientsOf {
 public:
  /// Both must outlive this.
  GradientsOf(const FineGrid& fine, MultigridOf<Real>& multigrid, const equilibrium::Kernels& kernels);
  using Correction = NodeFieldOf<Real>;

  /// Improves displacements whose components at held nodes are right; on a wrapped grid whose differences
  /// between copy and original are.
  /// @param load  at the nodes, in the unit of FineGrid::forces(); none = zero.
  /// @return whether the goal was reached.
  [[nodiscard]] bool solve(NodeField& u, const SolutionGoal& goal, const NodeField* load = nullptr);
  /// Of the last solve, in the norm of the energy; its unit is that of FineGrid::forces() times a length.
  [[nodiscard]] double error_at_start() const { return error_at_start_; }

  /// Load minus stiffness times u at every node: what holds it there. Valid until the next call.
  [[nodiscard]] const NodeField& unbalanced(const NodeField& u, const NodeField* load = nullptr);

  /// Sums over all nodes of a row, held or not, of the forces along y of the cells.
  /// @pre a solve came before, and nothing changed.
  [[nodiscard]] double force_y(int row) const { return row_forces_[static_cast<std::size_t>(row)]; }

  /// Calls work(row) for all rows of nodes, on all threads.
  template <class Work>
  void each_row(const Work& work) {
    sweep_.each_row(multigrid_.team(), work);
  }

  [[nodiscard]] std::int64_t iterations() const { return iterations_; }  ///< of all solves

 private:
  template <class Nodes>
  void sweep_forces(const NodeField& u, const Nodes& nodes);
  double find_residual(const NodeField& u, const NodeField* load);
  [[nodiscard]] double sum_of_rows() const;
  [[nodiscard]] double product(const Correction& a, const Correction& b);
  double turn(Real factor);
  void advance(Real factor, NodeField& u);

  const FineGrid& fine_;
  MultigridOf<Real>& multigrid_;
  const equilibrium::Kernels& all_kernels_;
  const equilibrium::Corrections<Real>& kernels_;
  CellShape grid_;
  int nodes_;  ///< padded number of nodes in a row
  StaggeredSweep<double> force_sweep_;
  StaggeredSweep<Real> sweep_;
  NodeField unbalanced_;  ///< empty until it is asked for
  Correction residual_, preconditioned_, direction_, image_;
  std::vector<double> row_sums_, row_forces_;
  double error_at_start_ = 0;
  std::int64_t iterations_ = 0;
};

/// With as many bits as its multigrid.
class ConjugateGradients {
 public:
  /// Both must outlive this.
  ConjugateGradients(const FineGrid& fine, Multigrid& multigrid);

  /// See GradientsOf.
  [[nodiscard]] bool solve(NodeField& u, const SolutionGoal& goal, const NodeField* load = nullptr) {
    return single_ ? single_->solve(u, goal, load) : whole_->solve(u, goal, load);
  }
  [[nodiscard]] double error_at_start() const {
    return single_ ? single_->error_at_start() : whole_->error_at_start();
  }
  [[nodiscard]] const NodeField& unbalanced(const NodeField& u, const NodeField* load = nullptr) {
    return single_ ? single_->unbalanced(u, load) : whole_->unbalanced(u, load);
  }
  [[nodiscard]] double force_y(int row) const {
    return single_ ? single_->force_y(row) : whole_->force_y(row);
  }
  template <class Work>
  void each_row(const Work& work) {
    single_ ? single_->each_row(work) : whole_->each_row(work);
  }
  [[nodiscard]] std::int64_t iterations() const {
    return single_ ? single_->iterations() : whole_->iterations();
  }

 private:
  std::unique_ptr<GradientsOf<float>> single_;  ///< one of both
  std::unique_ptr<GradientsOf<double>> whole_;
};

/// Scalar product over all nodes; row by row, so that it is the same for any number of threads.
[[nodiscard]] double dot(const CellShape& shape, const NodeField& a, const NodeField& b);

}  // namespace mpm
