#include "libmpm/solver/quasi_static/conjugate_gradients.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "libmpm/kernels/instruction_set.hpp"

namespace mpm {
namespace {

/// Share of the squared error down to which the bits follow it [-].
template <class Real>
constexpr double followed = sizeof(Real) == sizeof(float) ? 1e-6 : 0;
/// Of the energy at the start: where nothing is left of it the solution is motion without strain.
constexpr double no_energy = 1e-10;

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

template <class Real>
GradientsOf<Real>::GradientsOf(const FineGrid& fine, MultigridOf<Real>& multigrid,
                               const equilibrium::Kernels& kernels)
    : fine_(fine),
      multigrid_(multigrid),
      all_kernels_(kernels),
      kernels_(kernels.corrections<Real>()),
      grid_(fine.shape()),
      nodes_(padded(grid_.cells_x + 1)) {
  for (Correction* field : {&residual_, &preconditioned_, &direction_, &image_})
    *field = grid_.template zeros<Real>();
  const int bands = StaggeredSweep<Real>::bands_for(grid_.cells_y, grid_.cells(), multigrid.team().threads());
  force_sweep_.resize(grid_.cells_y, grid_.cell_stride(), bands);
  sweep_.resize(grid_.cells_y, grid_.cell_stride(), bands);
  row_sums_.assign(static_cast<std::size_t>(grid_.cells_y + 1), 0.0);
  row_forces_ = row_sums_;
}

/// In one order for any number of threads.
template <class Real>
double GradientsOf<Real>::sum_of_rows() const {
  return std::accumulate(row_sums_.begin(), row_sums_.end(), 0.0);
}

template <class Real>
double GradientsOf<Real>::product(const Correction& a, const Correction& b) {
  sweep_.each_row(multigrid_.team(), [&](int row) {
    const std::size_t at = grid_.node(row, 0);
    row_sums_[static_cast<std::size_t>(row)] = kernels_.dot(nodes_, a.from(at), b.from(at));
  });
  return sum_of_rows();
}

/// nodes(row of nodes, forces of the cells below, of those above), which returns its sums.
template <class Real>
template <class Nodes>
void GradientsOf<Real>::sweep_forces(const NodeField& u, const Nodes& nodes) {
  force_sweep_.run(
      multigrid_.team(), 1, [](int /*row*/) {},
      [&](int /*sweep*/, int row, auto& lower, auto& upper) {
        fine_.forces(row, u, lower.forces(), upper.forces());
      },
      [&](int /*sweep*/, int row, const auto& below, const auto& above) {
        const equilibrium::NodeSums sums = nodes(row, below.forces(), above.forces());
        row_sums_[static_cast<std::size_t>(row)] = -sums.work;
        row_forces_[static_cast<std::size_t>(row)] = sums.force_y;
      });
}

template <class Real>
const NodeField& GradientsOf<Real>::unbalanced(const NodeField& u, const NodeField* load) {
  if (unbalanced_.x.empty()) unbalanced_ = grid_.zeros();
  sweep_forces(u, [&](int row, const auto& below, const auto& above) {
    const std::size_t at = grid_.node(row, 0);
    return all_kernels_.all_forces(
        {nodes_, below, above, u.from(at), nullptr, nullptr, unbalanced_.from(at)});
  });
  if (load == nullptr) return unbalanced_;
  const auto add = [](AlignedVector<double>& to, const AlignedVector<double>& from) {
    for (std::size_t i = 0; i < to.size(); ++i) to[i] += from[i];
  };
  add(unbalanced_.x, load->x);
  add(unbalanced_.y, load->y);
  return unbalanced_;
}

/// The unbalanced forces on unknowns.   @return twice the elastic energy.
template <class Real>
double GradientsOf<Real>::find_residual(const NodeField& u, const NodeField* load) {
  const typename MultigridOf<Real>::NodeInverse& inverse = multigrid_.inverse();
  if (load == nullptr && fine_.edges() != EdgeNodes::wrapped) {
    sweep_forces(u, [&](int row, const auto& below, const auto& above) {
      const std::size_t at = grid_.node(row, 0);
      return kernels_.known_forces({nodes_, below, above, u.from(at), inverse.xx.data() + at,
                                    inverse.yy.data() + at, residual_.from(at)});
    });
    return sum_of_rows();
  }
  (void)unbalanced(u, load);
  if (fine_.edges() == EdgeNodes::wrapped) fold_loads(grid_, unbalanced_);
  const auto take = [](const AlignedVector<double>& from, const AlignedVector<Real>& known,
                       AlignedVector<Real>& to) {
    for (std::size_t i = 0; i < to.size(); ++i) to[i] = known[i] > 0 ? static_cast<Real>(from[i]) : 0;
  };
  take(unbalanced_.x, inverse.xx, residual_.x);
  take(unbalanced_.y, inverse.yy, residual_.y);
  return sum_of_rows();
}

/// The next direction, and the forces that it changes.   @return twice the energy of the direction.
template <class Real>
double GradientsOf<Real>::turn(Real factor) {
  const typename MultigridOf<Real>::NodeInverse& inverse = multigrid_.inverse();
  sweep_.run(
      multigrid_.team(), 1,
      [&](int row) {
        const std::size_t at = grid_.node(row, 0);
        kernels_.turn(nodes_, factor, std::as_const(preconditioned_).from(at), direction_.from(at));
      },
      [&](int /*sweep*/, int row, auto& lower, auto& upper) {
        fine_.correction_forces(row, direction_, lower.forces(), upper.forces());
      },
      [&](int /*sweep*/, int row, const auto& below, const auto& above) {
        const std::size_t at = grid_.node(row, 0);
        kernels_.forces({.nodes = nodes_,
                         .below = below.forces(),
                         .above = above.forces(),
                         .load_x = nullptr,
                         .load_y = nullptr,
                         .inverse_xx = inverse.xx.data() + at,
                         .inverse_xy = nullptr,
                         .inverse_yy = inverse.yy.data() + at,
                         .weight = 0,
                         .x = image_.x.data() + at,
                         .y = image_.y.data() + at});
        row_sums_[static_cast<std::size_t>(row)] =
            -kernels_.dot(nodes_, std::as_const(direction_).from(at), std::as_const(image_).from(at));
      });
  if (fine_.edges() == EdgeNodes::wrapped) fold_loads(grid_, image_);
  return sum_of_rows();
}

template <class Real>
void GradientsOf<Real>::advance(Real factor, NodeField& u) {
  sweep_.each_row(multigrid_.team(), [&](int row) {
    const std::size_t at = grid_.node(row, 0);
    kernels_.advance(nodes_, factor, std::as_const(direction_).from(at), std::as_const(image_).from(at),
                     u.from(at), residual_.from(at));
  });
}

template <class Real>
bool GradientsOf<Real>::solve(NodeField& u, const SolutionGoal& goal, const NodeField* load) {
  const FlushToZero flush;
  // Twice that of the displacements; what an iteration wins lowers it without loads, and raises it with them.
  double energy = find_residual(u, load);
  const double least = no_energy * energy;
  double wanted = 0;
  double left = 0;   // about the square of the error in the norm of the energy
  double fresh = 0;  // what it was when the residual was last computed from the displacements
  const auto is_reached = [&] {
    return left <= std::max(wanted, goal.accuracy * goal.accuracy * std::max(energy, least));
  };
  for (int i = 0; i < goal.iterations; ++i, ++iterations_) {
    multigrid_.precondition(residual_, preconditioned_, image_);
    const double before = left;
    left = product(residual_, preconditioned_);
    if (i == 0) {
      wanted = std::max(goal.reduction * goal.reduction * left, goal.error * goal.error);
      error_at_start_ = std::sqrt(std::max(left, 0.0));
      fresh = left;
    }
    if (is_reached()) break;
    const double curvature = turn(static_cast<Real>(i > 0 ? left / before : 0));
    if (!(curvature > 0)) return false;
    const double length = left / curvature;
    advance(static_cast<Real>(length), u);
    energy += (load != nullptr ? 1 : -1) * left * length;
    if (left > followed<Real> * fresh) continue;
    energy = find_residual(u, load);
    fresh = left;
  }
  (void)find_residual(u, load);
  return is_reached();
}

template class GradientsOf<float>;
template class GradientsOf<double>;

ConjugateGradients::ConjugateGradients(const FineGrid& fine, Multigrid& multigrid) {
  if (multigrid.single() != nullptr)
    single_ = std::make_unique<GradientsOf<float>>(fine, *multigrid.single(), multigrid.kernels());
  else
    whole_ = std::make_unique<GradientsOf<double>>(fine, *multigrid.whole(), multigrid.kernels());
}

}  // namespace mpm
