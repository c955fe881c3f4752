#include "libmpm/solver/quasi_static/conjugate_gradients.hpp"

#include <algorithm>

#include "libmpm/kernels/instruction_set.hpp"

namespace mpm {
namespace {

constexpr int most_iterations = 2000;  ///< of one solve
/// Of the energy at the start: where nothing is left of it the solution is motion without strain.
constexpr double no_energy = 1e-10;

/// to += factor from
void add_times(NodeField& to, double factor, const NodeField& from) {
  for (std::size_t i = 0; i < to.x.size(); ++i) to.x[i] += factor * from.x[i];
  for (std::size_t i = 0; i < to.y.size(); ++i) to.y[i] += factor * from.y[i];
}

/// to = from + factor to
void times_and_add(NodeField& to, double factor, const NodeField& from) {
  for (std::size_t i = 0; i < to.x.size(); ++i) to.x[i] = from.x[i] + factor * to.x[i];
  for (std::size_t i = 0; i < to.y.size(); ++i) to.y[i] = from.y[i] + factor * to.y[i];
}

}  // namespace

double dot(const CellShape& shape, const NodeField& a, const NodeField& b) {
  double sum = 0;
  for (int row = 0; row <= shape.cells_y; ++row) {
    const std::size_t first = shape.node(row, 0);
    double lanes[8] = {0, 0, 0, 0, 0, 0, 0, 0};
    const auto n = static_cast<std::size_t>(shape.stride());
    for (std::size_t i = 0; i < n; i += 8)
      for (std::size_t lane = 0; lane < 8; ++lane)
        lanes[lane] +=
            a.x[first + i + lane] * b.x[first + i + lane] + a.y[first + i + lane] * b.y[first + i + lane];
    sum += ((lanes[0] + lanes[4]) + (lanes[1] + lanes[5])) + ((lanes[2] + lanes[6]) + (lanes[3] + lanes[7]));
  }
  return sum;
}

ConjugateGradients::ConjugateGradients(const FineGrid& fine, Multigrid& multigrid)
    : fine_(fine), multigrid_(multigrid) {
  for (NodeField* field : {&no_load_, &residual_, &preconditioned_, &direction_, &image_})
    *field = fine.shape().zeros();
}

/// What of forces acts on unknowns.
void ConjugateGradients::leave_unknowns(NodeField& field) const {
  if (fine_.edges() == EdgeNodes::wrapped) fold_loads(fine_.shape(), field);
  fine_.clear_held(field);
}

const NodeField& ConjugateGradients::unbalanced(const NodeField& u, const NodeField* load) {
  multigrid_.residual(load != nullptr ? *load : no_load_, u, image_);
  return image_;
}

bool ConjugateGradients::solve(NodeField& u, double reduction, double accuracy, const NodeField* load) {
  const FlushToZero flush;
  const CellShape grid = fine_.shape();
  multigrid_.residual(load != nullptr ? *load : no_load_, u, residual_);
  // Twice that of the displacements; what an iteration wins lowers it without loads, and raises it with them.
  double energy = (load != nullptr ? dot(grid, u, *load) : 0) - dot(grid, u, residual_);
  leave_unknowns(residual_);
  const double least = no_energy * energy;
  double goal = 0;
  double left = 0;  // about the square of the error in the norm of the energy
  const auto is_reached = [&] {
    return left <= std::max(goal, accuracy * accuracy * std::max(energy, least));
  };
  for (int i = 0; i < most_iterations; ++i, ++iterations_) {
    multigrid_.precondition(residual_, preconditioned_);
    const double before = left;
    left = dot(grid, residual_, preconditioned_);
    if (i == 0) goal = reduction * reduction * left;
    if (is_reached()) break;
    times_and_add(direction_, i > 0 ? left / before : 0, preconditioned_);
    multigrid_.residual(no_load_, direction_, image_);  // minus the stiffness times the direction
    leave_unknowns(image_);
    const double curvature = -dot(grid, direction_, image_);
    if (!(curvature > 0)) return false;
    add_times(u, left / curvature, direction_);
    add_times(residual_, left / curvature, image_);
    energy += (load != nullptr ? 1 : -1) * left * left / curvature;
  }
  return is_reached();
}

}  // namespace mpm
