#include "libmpm/solver/quasi_static/multigrid.hpp"

#include <algorithm>
#include <utility>

namespace mpm {
namespace {

constexpr double most_contrast = 1e4;  ///< that 32 bits bear [-]

/// Weights of the relaxations before the correction of the coarser grid, and after it: block Jacobi made a
/// Chebyshev polynomial over the upper three quarters of the spectrum. The stiffness of a cell of four nodes
/// is at most 4 times that of its nodes alone, so no picture has an eigenvalue above 4. Source: Adams,
/// Brezina, Hu, Tuminaro, J. Comput. Phys. 188 (2003), polynomial smoothers.
constexpr double weights[] = {0.6943, 0.2808};  // 1 / (2.5 -+ 1.5 cos(pi / 4))

/// Calls visit(copy, original) for every node of a wrapped grid that is a copy.
template <class Visit>
void each_copy(const CellShape& shape, const Visit& visit) {
  for (int row = 0; row <= shape.cells_y; ++row) visit(shape.node(row, shape.cells_x), shape.node(row, 0));
  for (int col = 0; col < shape.cells_x; ++col) visit(shape.node(shape.cells_y, col), shape.node(0, col));
}

}  // namespace

template <class Real>
void fold_loads(const CellShape& shape, NodeFieldOf<Real>& field) {
  each_copy(shape, [&](std::size_t copy, std::size_t original) {
    for (AlignedVector<Real>* values : {&field.x, &field.y}) {
      (*values)[original] += (*values)[copy];
      (*values)[copy] = 0;
    }
  });
}
template void fold_loads(const CellShape&, NodeField&);
template void fold_loads(const CellShape&, NodeFieldOf<float>&);

template <class Real>
void copy_displacements(const CellShape& shape, NodeFieldOf<Real>& field) {
  for (AlignedVector<Real>* values : {&field.x, &field.y}) {
    each_copy(shape, [&](std::size_t copy, std::size_t original) { (*values)[copy] = (*values)[original]; });
    values->at(shape.node(shape.cells_y, shape.cells_x)) = values->front();
  }
}
template void copy_displacements(const CellShape&, NodeField&);
template void copy_displacements(const CellShape&, NodeFieldOf<float>&);

int coarsenings(int cells_x, int cells_y) {
  int count = 0;
  while ((std::max(cells_x, cells_y) >> count) > 6 && (std::min(cells_x, cells_y) >> count) > 2) ++count;
  return count;
}

template <class Real>
MultigridOf<Real>::MultigridOf(const FineGrid& fine, int coarsenings, const equilibrium::Kernels& kernels,
                               int threads)
    : fine_(fine),
      edges_(fine.edges()),
      kernels_(kernels.corrections<Real>()),
      team_(std::max(1, threads)),
      levels_(static_cast<std::size_t>(coarsenings) + 1) {
  for (std::size_t l = 0; l < levels_.size(); ++l) make_level(l);
  no_forces_.resize(levels_.front().shape.cell_stride());
  no_row_.assign(static_cast<std::size_t>(levels_.front().shape.stride()), Real(0));
  factorise();
}

template <class Real>
void MultigridOf<Real>::cell_forces(std::size_t index, int row, const Correction& u, ForceBuffer<Real>& lower,
                                    ForceBuffer<Real>& upper) const {
  if (index == 0) return fine_.correction_forces(row, u, lower.forces(), upper.forces());
  const Level& level = levels_[index];
  const std::ptrdiff_t stride = level.shape.cell_stride();
  const std::size_t below = level.shape.node(row, 0);
  const std::size_t above = level.shape.node(row + 1, 0);
  const bool has_modes = level.has_modes[static_cast<std::size_t>(row)] != 0;
  (has_modes ? kernels_.multiply_modes : kernels_.multiply_nodes)({.cells = static_cast<int>(stride),
                                                                   .stride = stride,
                                                                   .matrices = entries(level, row, 0),
                                                                   .slant = level.slants.data(),
                                                                   .ux_lower = u.x.data() + below,
                                                                   .uy_lower = u.y.data() + below,
                                                                   .ux_upper = u.x.data() + above,
                                                                   .uy_upper = u.y.data() + above,
                                                                   .lower = lower.forces(),
                                                                   .upper = upper.forces()});
}

template <class Real>
void MultigridOf<Real>::node_row(const Level& level, int row, Kernel kernel, double weight,
                                 const ForceBuffer<Real>& below, const ForceBuffer<Real>& above,
                                 const Correction& load, Correction& out) const {
  const std::size_t at = level.shape.node(row, 0);
  kernel({.nodes = padded(level.shape.cells_x + 1),
          .below = below.forces(),
          .above = above.forces(),
          .load_x = load.x.data() + at,
          .load_y = load.y.data() + at,
          .inverse_xx = level.inverse.xx.data() + at,
          .inverse_xy = level.inverse.xy.data() + at,
          .inverse_yy = level.inverse.yy.data() + at,
          .weight = static_cast<Real>(weight),
          .x = out.x.data() + at,
          .y = out.y.data() + at});
}

/// The first relaxation, from rest.
template <class Real>
void MultigridOf<Real>::first_relax(const Level& level, int row, const Correction& load,
                                    Correction& u) const {
  node_row(level, row, kernels_.first_relax, weights[0], no_forces_, no_forces_, load, u);
}

/// Two relaxations from rest, and what they leave.
template <class Real>
void MultigridOf<Real>::smooth(std::size_t index, const Correction& load, Correction& u,
                               Correction& residual) {
  Level& level = levels_[index];
  level.sweeps.run(
      team_, 2, [&](int row) { first_relax(level, row, load, u); },
      [&](int /*sweep*/, int row, auto& lower, auto& upper) { cell_forces(index, row, u, lower, upper); },
      [&](int sweep, int row, const auto& below, const auto& above) {
        if (sweep == 0)
          node_row(level, row, kernels_.relax, weights[1], below, above, load, u);
        else
          node_row(level, row, kernels_.residual, 0, below, above, load, residual);
      });
}

/// Adds what the coarser grid has found, and relaxes twice.
template <class Real>
void MultigridOf<Real>::correct(std::size_t index, const Correction& load, Correction& u) {
  Level& level = levels_[index];
  level.sweeps.run(
      team_, 2, [&](int row) { interpolate(index, row, u); },
      [&](int /*sweep*/, int row, auto& lower, auto& upper) { cell_forces(index, row, u, lower, upper); },
      [&](int sweep, int row, const auto& below, const auto& above) {
        node_row(level, row, kernels_.relax, weights[sweep], below, above, load, u);
      });
}

/// Of the unknowns.
template <class Real>
void MultigridOf<Real>::find_residual(std::size_t index, const Correction& load, const Correction& u,
                                      Correction& residual) {
  Level& level = levels_[index];
  level.sweeps.run(
      team_, 1, [](int /*row*/) {},
      [&](int /*sweep*/, int row, auto& lower, auto& upper) { cell_forces(index, row, u, lower, upper); },
      [&](int /*sweep*/, int row, const auto& below, const auto& above) {
        node_row(level, row, kernels_.residual, 0, below, above, load, residual);
      });
  if (edges_ == EdgeNodes::wrapped) fold_loads(level.shape, residual);
}

/// Copies are known when all of their originals are, so that sweeps cannot follow each other.
template <class Real>
void MultigridOf<Real>::relax_wrapped(std::size_t index, const Correction& load, Correction& u,
                                      Correction& residual, double weight) {
  Level& level = levels_[index];
  find_residual(index, load, u, residual);
  const ForceBuffer<Real>& none = no_forces_;
  level.sweeps.each_row(
      team_, [&](int row) { node_row(level, row, kernels_.relax, weight, none, none, residual, u); });
  copy_displacements(level.shape, u);
}

template <class Real>
void MultigridOf<Real>::smooth_wrapped(std::size_t index, const Correction& load, Correction& u,
                                       Correction& residual) {
  Level& level = levels_[index];
  level.sweeps.each_row(team_, [&](int row) { first_relax(level, row, load, u); });
  copy_displacements(level.shape, u);
  relax_wrapped(index, load, u, residual, weights[1]);
  find_residual(index, load, u, residual);
}

template <class Real>
void MultigridOf<Real>::correct_wrapped(std::size_t index, const Correction& load, Correction& u,
                                        Correction& residual) {
  levels_[index].sweeps.each_row(team_, [&](int row) { interpolate(index, row, u); });
  for (const double weight : weights) relax_wrapped(index, load, u, residual, weight);
}

/// The load of a coarser grid: P^T residual for bilinear interpolation P.
template <class Real>
void MultigridOf<Real>::restrict_to(std::size_t index, const Correction& residual) {
  Level& level = levels_[index];
  level.sweeps.each_row(team_, [&](int row) {
    restrict_row(index, row, residual.x, level.load.x);
    restrict_row(index, row, residual.y, level.load.y);
  });
  if (edges_ == EdgeNodes::wrapped) fold_loads(level.shape, level.load);
}

template <class Real>
void MultigridOf<Real>::restrict_row(std::size_t index, int row, const AlignedVector<Real>& from,
                                     AlignedVector<Real>& to) const {
  const Level& level = levels_[index];
  const CellShape& fine = levels_[index - 1].shape;
  const auto line = [&](int fine_row) {
    return fine_row < 0 || fine_row > fine.cells_y ? no_row_.data() : from.data() + fine.node(fine_row, 0);
  };
  const Real* rows[3] = {line(2 * row - 1), line(2 * row), line(2 * row + 1)};
  AlignedVector<Real> sum;
  if (const int last = level.y.cells() - 1; row >= last && !level.y.halves(last)) {
    sum.assign(static_cast<std::size_t>(fine.stride()), Real(0));
    for (int at = std::max(0, 2 * row - 1); at <= fine.cells_y; ++at) {
      const int left = level.y.left_of(at);
      const double weight = left == row ? 1 - level.y.weight(at) : left + 1 == row ? level.y.weight(at) : 0;
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += static_cast<Real>(weight) * line(at)[i];
    }
    rows[0] = rows[2] = no_row_.data();
    rows[1] = sum.data();
  }
  Real* out = to.data() + level.shape.node(row, 0);
  const int last = level.x.cells() - 1;
  if (level.x.halves(last)) return kernels_.restrict_row(last + 2, rows[0], rows[1], rows[2], out);
  kernels_.restrict_row(last, rows[0], rows[1], rows[2], out);
  const auto value = [&](int col) { return rows[1][col] + Real(0.5) * (rows[0][col] + rows[2][col]); };
  out[last] = last > 0 ? Real(0.5) * value(2 * last - 1) : 0;
  out[last + 1] = 0;
  for (int col = 2 * last; col <= fine.cells_x; ++col) {
    out[last] += static_cast<Real>(1 - level.x.weight(col)) * value(col);
    out[last + 1] += static_cast<Real>(level.x.weight(col)) * value(col);
  }
}

/// Adds to a row of nodes what the coarser grid has found.
template <class Real>
void MultigridOf<Real>::interpolate(std::size_t index, int row, Correction& u) const {
  const Level& level = levels_[index];
  const Level& coarse = levels_[index + 1];
  const std::size_t at = level.shape.node(row, 0);
  const std::size_t from = coarse.shape.node(coarse.y.left_of(row), 0);
  const auto up = static_cast<Real>(coarse.y.weight(row));
  const int last = coarse.x.cells() - 1;
  const auto component = [&](const AlignedVector<Real>& solution, const AlignedVector<Real>& inverse,
                             AlignedVector<Real>& to) {
    const Real* lower = solution.data() + from;
    const Real* upper = lower + coarse.shape.stride();
    Real* line = to.data() + at;
    kernels_.interpolate_row(last, up, lower, upper, line);
    const Real left = (1 - up) * lower[last] + up * upper[last];
    const Real right = (1 - up) * lower[last + 1] + up * upper[last + 1];
    for (int col = 2 * last; col <= level.shape.cells_x; ++col) {
      const auto weight = static_cast<Real>(coarse.x.weight(col));
      line[col] += (1 - weight) * left + weight * right;
    }
    if (index == 0) kernels_.leave_unknowns(padded(level.shape.cells_x + 1), inverse.data() + at, line);
  };
  component(coarse.solution.x, level.inverse.xx, u.x);
  component(coarse.solution.y, level.inverse.yy, u.y);
}

template <class Real>
void MultigridOf<Real>::cycle(std::size_t index, const Correction& load, Correction& u,
                              Correction& residual) {
  if (index + 1 == levels_.size()) return solve_coarsest(load, u);
  Level& coarse = levels_[index + 1];
  const bool wrapped = edges_ == EdgeNodes::wrapped;
  wrapped ? smooth_wrapped(index, load, u, residual) : smooth(index, load, u, residual);
  restrict_to(index + 1, residual);
  cycle(index + 1, coarse.load, coarse.solution, coarse.residual);
  wrapped ? correct_wrapped(index, load, u, residual) : correct(index, load, u);
}

template <class Real>
void MultigridOf<Real>::solve_coarsest(const Correction& load, Correction& u) {
  const CellShape shape = levels_.back().shape;
  unknowns_.assign(static_cast<std::size_t>(coarsest_.unknowns()), 0.0);
  const auto each = [&](auto&& visit) {
    for (int row = 0; row <= shape.cells_y; ++row)
      for (int col = 0; col <= shape.cells_x; ++col)
        visit(shape.node(row, col), static_cast<std::size_t>(unknown(row, col, 0)));
  };
  each([&](std::size_t at, std::size_t unknown) {
    unknowns_[unknown] += static_cast<double>(load.x[at]);
    unknowns_[unknown + 1] += static_cast<double>(load.y[at]);
  });
  coarsest_.solve(unknowns_);
  each([&](std::size_t at, std::size_t unknown) {
    u.x[at] = static_cast<Real>(unknowns_[unknown]);
    u.y[at] = static_cast<Real>(unknowns_[unknown + 1]);
  });
}

template <class Real>
void MultigridOf<Real>::precondition(const Correction& r, Correction& z, Correction& scratch) {
  cycle(0, r, z, scratch);
}

template class MultigridOf<float>;
template class MultigridOf<double>;

Multigrid::Multigrid(const FineGrid& fine, int coarsenings, const equilibrium::Kernels& kernels, int threads)
    : kernels_(kernels) {
  if (fine.contrast() <= most_contrast)
    single_ = std::make_unique<MultigridOf<float>>(fine, coarsenings, kernels, threads);
  else
    whole_ = std::make_unique<MultigridOf<double>>(fine, coarsenings, kernels, threads);
}

void Multigrid::update(std::vector<Cell> cells) {
  single_ ? single_->update(std::move(cells)) : whole_->update(std::move(cells));
}

}  // namespace mpm
