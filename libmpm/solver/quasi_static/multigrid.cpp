#include "libmpm/solver/quasi_static/multigrid.hpp"

#include <algorithm>
#include <utility>

namespace mpm {
namespace {

/// Weights of the relaxations before the correction of the coarser grid, and after it: block Jacobi made a
/// Chebyshev polynomial over the upper three quarters of the spectrum. The stiffness of a cell of four nodes
/// is at most 4 times that of its nodes alone, so no picture has an eigenvalue above 4. Source: Adams,
/// Brezina, Hu, Tuminaro, J. Comput. Phys. 188 (2003), polynomial smoothers.
constexpr double weights[] = {0.6943, 0.2808};  // 1 / (2.5 -+ 1.5 cos(pi / 4))

/// r_coarse = P^T r_fine for bilinear interpolation P.
void restrict_to(const CellShape& coarse, const AlignedVector<double>& from, const CellShape& fine,
                 AlignedVector<double>& to) {
  for (int row = 0; row <= coarse.cells_y; ++row) {
    for (int col = 0; col <= coarse.cells_x; ++col) {
      double sum = 0;
      for (int dy = -1; dy <= 1; ++dy) {
        const int fine_row = 2 * row + dy;
        if (fine_row < 0 || fine_row > fine.cells_y) continue;
        const double* line = from.data() + fine.node(fine_row, 0);
        const int at = 2 * col;
        double part = line[at];
        if (at > 0) part += 0.5 * line[at - 1];
        if (at < fine.cells_x) part += 0.5 * line[at + 1];
        sum += (dy == 0 ? 1.0 : 0.5) * part;
      }
      to[coarse.node(row, col)] = sum;
    }
  }
}

/// u_fine += P u_coarse.
void add_interpolated(const CellShape& coarse, const AlignedVector<double>& from, const CellShape& fine,
                      AlignedVector<double>& to) {
  for (int row = 0; row <= fine.cells_y; ++row) {
    const double* lower = from.data() + coarse.node(row / 2, 0);
    const double* upper = from.data() + coarse.node((row + 1) / 2, 0);
    double* line = to.data() + fine.node(row, 0);
    for (int col = 0; col < coarse.cells_x; ++col) {
      const double left = 0.5 * (lower[col] + upper[col]);
      const double right = 0.5 * (lower[col + 1] + upper[col + 1]);
      line[2 * col] += left;
      line[2 * col + 1] += 0.5 * (left + right);
    }
    line[fine.cells_x] += 0.5 * (lower[coarse.cells_x] + upper[coarse.cells_x]);
  }
}

}  // namespace

int coarsenings(int cells_x, int cells_y) {
  int count = 0;
  while ((std::max(cells_x, cells_y) >> count) > 6 && (std::min(cells_x, cells_y) >> count) > 2) ++count;
  return count;
}

Multigrid::Multigrid(const FineGrid& fine, int coarsenings, const equilibrium::Kernels& kernels)
    : fine_(fine), kernels_(kernels), levels_(static_cast<std::size_t>(coarsenings) + 1) {
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    Level& level = levels_[l];
    level.shape = {fine.shape().cells_x >> l, fine.shape().cells_y >> l};
    for (auto* field : {&level.xx, &level.xy, &level.yy}) field->assign(level.shape.nodes(), 0.0);
    for (ForceBuffer<double>* forces : {&level.upper[0], &level.upper[1], &level.lower})
      forces->resize(level.shape.cell_stride());
    level.residual = level.shape.zeros();
    if (l > 0) {
      level.load = level.solution = level.shape.zeros();
      level.matrices.assign(static_cast<std::size_t>(equilibrium::matrix_entries * level.shape.cell_stride() *
                                                     level.shape.cells_y),
                            0.0F);
      for (int row = 0; row < level.shape.cells_y; ++row)
        for (int col = 0; col < level.shape.cells_x; ++col) make_cell(l, row, col);
    }
    for (int row = 0; row <= level.shape.cells_y; ++row)
      for (int col = 0; col <= level.shape.cells_x; ++col) make_node(l, row, col);
  }
  no_forces_.resize(levels_.front().shape.cell_stride());
  factorise();
}

CellStiffness Multigrid::cell(std::size_t index, int row, int col) const {
  if (index == 0) return fine_.cell(row, col);
  const Level& level = levels_[index];
  const float* entry =
      level.matrices.data() + equilibrium::matrix_entries * level.shape.cell_stride() * row + col;
  CellStiffness matrix;
  for (int i = 0; i < 8; ++i)
    for (int j = i; j < 8; ++j, entry += level.shape.cell_stride())
      matrix(i, j) = matrix(j, i) = static_cast<double>(*entry);
  return matrix;
}

void Multigrid::make_cell(std::size_t index, int row, int col) {
  CellStiffness matrix = CellStiffness::Zero();
  for (int child = 0; child < 4; ++child) {
    const int fine_row = 2 * row + child / 2;
    const int fine_col = 2 * col + child % 2;
    add_child(matrix, cell(index - 1, fine_row, fine_col), child,
              index == 1 ? fine_.held(fine_row, fine_col) : HeldNodes());
  }
  Level& level = levels_[index];
  float* entry = level.matrices.data() + equilibrium::matrix_entries * level.shape.cell_stride() * row + col;
  for (int i = 0; i < 8; ++i)
    for (int j = i; j < 8; ++j, entry += level.shape.cell_stride()) *entry = static_cast<float>(matrix(i, j));
}

/// The inverse of the block of a node; zero for what is held or has no stiffness.
void Multigrid::make_node(std::size_t index, int row, int col) {
  Level& level = levels_[index];
  double xx = 0;
  double xy = 0;
  double yy = 0;
  bool held_x = false;
  bool held_y = false;
  for (int corner = 0; corner < 4; ++corner) {  // of the cell in which the node is this corner
    const int cell_row = row - corner / 2;
    const int cell_col = col - corner % 2;
    if (cell_row < 0 || cell_col < 0 || cell_row >= level.shape.cells_y || cell_col >= level.shape.cells_x)
      continue;
    const CellStiffness matrix = cell(index, cell_row, cell_col);
    xx += matrix(corner, corner);
    xy += matrix(corner, corner + 4);
    yy += matrix(corner + 4, corner + 4);
    if (index > 0) continue;
    const HeldNodes held = fine_.held(cell_row, cell_col);
    held_x |= held.x[static_cast<std::size_t>(corner)];
    held_y |= held.y[static_cast<std::size_t>(corner)];
  }
  if (held_x) xx = xy = 0;
  if (held_y) yy = xy = 0;
  const std::size_t at = level.shape.node(row, col);
  const double determinant = xx * yy - xy * xy;
  if (determinant > 1e-8 * xx * yy) {
    level.xx[at] = yy / determinant;
    level.xy[at] = -xy / determinant;
    level.yy[at] = xx / determinant;
  } else {
    level.xx[at] = xx > 0 ? 1 / xx : 0;
    level.xy[at] = 0;
    level.yy[at] = yy > 0 ? 1 / yy : 0;
  }
}

void Multigrid::factorise() {
  const std::size_t index = levels_.size() - 1;
  const CellShape shape = levels_[index].shape;
  const bool wide = shape.cells_x > shape.cells_y;  // nodes are numbered along the shorter side
  const int across = std::min(shape.cells_x, shape.cells_y) + 1;
  const auto unknown = [&](int row, int col, int component) {
    return 2 * (wide ? col * across + row : row * across + col) + component;
  };
  coarsest_.reset(2 * across * (std::max(shape.cells_x, shape.cells_y) + 1), 2 * (across + 1) + 1);
  for (int row = 0; row < shape.cells_y; ++row)
    for (int col = 0; col < shape.cells_x; ++col) {
      const CellStiffness matrix = cell(index, row, col);
      const HeldNodes held = index == 0 ? fine_.held(row, col) : HeldNodes();
      const auto is_held = [&](int i) {
        return i < 4 ? held.x[static_cast<std::size_t>(i)] : held.y[static_cast<std::size_t>(i - 4)];
      };
      for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j)
          if (!is_held(i) && !is_held(j))
            coarsest_.add(unknown(row + i % 4 / 2, col + i % 2, i / 4),
                          unknown(row + j % 4 / 2, col + j % 2, j / 4), matrix(i, j));
    }
  coarsest_.factorise(index == 0 ? 1e-12 : 1e-6);  // coarser matrices have the precision of 32 bits
}

void Multigrid::update(std::vector<Cell> cells) {
  const auto same = [](const Cell& a, const Cell& b) { return a.row == b.row && a.col == b.col; };
  const auto before = [](const Cell& a, const Cell& b) {
    return a.row != b.row ? a.row < b.row : a.col < b.col;
  };
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    if (l > 0) {
      for (Cell& one : cells) one = {one.row / 2, one.col / 2};
      std::sort(cells.begin(), cells.end(), before);
      cells.erase(std::unique(cells.begin(), cells.end(), same), cells.end());
      for (const Cell& one : cells) make_cell(l, one.row, one.col);
    }
    for (const Cell& one : cells)
      for (int corner = 0; corner < 4; ++corner) make_node(l, one.row + corner / 2, one.col + corner % 2);
  }
  factorise();
}

void Multigrid::cell_forces(Level& level, std::size_t index, int row, const NodeField& u,
                            ForceBuffer<double>& lower, ForceBuffer<double>& upper) {
  if (index == 0) return fine_.forces(row, u, lower.forces(), upper.forces());
  const std::size_t below = level.shape.node(row, 0);
  const std::size_t above = level.shape.node(row + 1, 0);
  kernels_.multiply(
      {.cells = static_cast<int>(level.shape.cell_stride()),
       .stride = level.shape.cell_stride(),
       .matrices = level.matrices.data() + equilibrium::matrix_entries * level.shape.cell_stride() * row,
       .ux_lower = u.x.data() + below,
       .uy_lower = u.y.data() + below,
       .ux_upper = u.x.data() + above,
       .uy_upper = u.y.data() + above,
       .lower = lower.forces(),
       .upper = upper.forces()});
}

/// One pass over the rows of cells; the nodes below a row are done when its forces are known, and no later
/// row reads them, so that `out` may be `u`.
void Multigrid::sweep(std::size_t index, const NodeField& load, const NodeField& u, NodeField& out,
                      Kernel kernel, double weight) {
  Level& level = levels_[index];
  const auto nodes = [&](int row, const ForceBuffer<double>& below, const ForceBuffer<double>& above) {
    const std::size_t at = level.shape.node(row, 0);
    kernel({.nodes = padded(level.shape.cells_x + 1),
            .below = below.forces(),
            .above = above.forces(),
            .load_x = load.x.data() + at,
            .load_y = load.y.data() + at,
            .inverse_xx = level.xx.data() + at,
            .inverse_xy = level.xy.data() + at,
            .inverse_yy = level.yy.data() + at,
            .weight = weight,
            .x = out.x.data() + at,
            .y = out.y.data() + at});
  };
  const ForceBuffer<double>* below = &no_forces_;
  for (int row = 0; row < level.shape.cells_y; ++row) {
    ForceBuffer<double>& upper = level.upper[row % 2];
    cell_forces(level, index, row, u, level.lower, upper);
    nodes(row, *below, level.lower);
    below = &upper;
  }
  nodes(level.shape.cells_y, *below, no_forces_);
}

void Multigrid::residual(const NodeField& load, const NodeField& u, NodeField& out) {
  sweep(0, load, u, out, kernels_.residual, 0);
}

void Multigrid::relax(std::size_t level, const NodeField& load, NodeField& u, double weight) {
  sweep(level, load, u, u, kernels_.relax, weight);
}

/// The first relaxation, from rest.
void Multigrid::first_relax(std::size_t index, const NodeField& load, NodeField& u) const {
  const Level& level = levels_[index];
  for (std::size_t i = 0; i < level.xx.size(); ++i) {
    u.x[i] = weights[0] * (level.xx[i] * load.x[i] + level.xy[i] * load.y[i]);
    u.y[i] = weights[0] * (level.xy[i] * load.x[i] + level.yy[i] * load.y[i]);
  }
}

void Multigrid::cycle(std::size_t index, const NodeField& load, NodeField& u) {
  if (index + 1 == levels_.size()) return solve_coarsest(load, u);
  Level& level = levels_[index];
  Level& coarse = levels_[index + 1];
  first_relax(index, load, u);
  relax(index, load, u, weights[1]);
  sweep(index, load, u, level.residual, kernels_.residual, 0);
  if (index == 0) fine_.clear_held(level.residual);
  restrict_to(coarse.shape, level.residual.x, level.shape, coarse.load.x);
  restrict_to(coarse.shape, level.residual.y, level.shape, coarse.load.y);
  cycle(index + 1, coarse.load, coarse.solution);
  add_interpolated(coarse.shape, coarse.solution.x, level.shape, u.x);
  add_interpolated(coarse.shape, coarse.solution.y, level.shape, u.y);
  if (index == 0) fine_.clear_held(u);
  for (const double weight : weights) relax(index, load, u, weight);
}

void Multigrid::solve_coarsest(const NodeField& load, NodeField& u) {
  const CellShape shape = levels_.back().shape;
  const bool wide = shape.cells_x > shape.cells_y;
  const int across = std::min(shape.cells_x, shape.cells_y) + 1;
  unknowns_.resize(static_cast<std::size_t>(coarsest_.unknowns()));
  const auto each = [&](auto&& visit) {
    for (int row = 0; row <= shape.cells_y; ++row)
      for (int col = 0; col <= shape.cells_x; ++col)
        visit(shape.node(row, col),
              2 * static_cast<std::size_t>(wide ? col * across + row : row * across + col));
  };
  each([&](std::size_t at, std::size_t unknown) {
    unknowns_[unknown] = load.x[at];
    unknowns_[unknown + 1] = load.y[at];
  });
  coarsest_.solve(unknowns_);
  each([&](std::size_t at, std::size_t unknown) {
    u.x[at] = unknowns_[unknown];
    u.y[at] = unknowns_[unknown + 1];
  });
}

void Multigrid::precondition(const NodeField& r, NodeField& z) { cycle(0, r, z); }

}  // namespace mpm
