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

/// line = the sum of the finer rows near a coarse one, by the weight of its nodes in them.
void restrict_rows(const CoarseAxis& y, int row, const AlignedVector<double>& from, const CellShape& fine,
                   std::vector<double>& line) {
  line.assign(static_cast<std::size_t>(fine.stride()), 0.0);
  const int first = row > 0 ? 2 * row - 1 : 0;
  const int last = row + 1 >= y.cells() ? fine.cells_y : 2 * row + 1;
  for (int at = first; at <= last; ++at) {
    const int left = y.left_of(at);
    const double weight = left == row ? 1 - y.weight(at) : left + 1 == row ? y.weight(at) : 0;
    const double* values = from.data() + fine.node(at, 0);
    for (std::size_t i = 0; i < line.size(); ++i) line[i] += weight * values[i];
  }
}

/// r_coarse = P^T r_fine for bilinear interpolation P.
void restrict_to(const CoarseAxis& x, const CoarseAxis& y, const CellShape& coarse,
                 const AlignedVector<double>& from, const CellShape& fine, AlignedVector<double>& to) {
  std::vector<double> line;
  const int last = x.cells() - 1;
  for (int row = 0; row <= y.cells(); ++row) {
    restrict_rows(y, row, from, fine, line);
    const double* values = line.data();
    double* out = to.data() + coarse.node(row, 0);
    out[last] = out[last + 1] = 0;
    for (int col = 0; col < last; ++col)
      out[col] = values[2 * col] + 0.5 * (values[2 * col + 1] + (col > 0 ? values[2 * col - 1] : 0));
    if (last > 0) out[last] = 0.5 * values[2 * last - 1];
    for (int col = 2 * last; col <= fine.cells_x; ++col) {
      out[last] += (1 - x.weight(col)) * values[col];
      out[last + 1] += x.weight(col) * values[col];
    }
  }
}

/// u_fine += P u_coarse.
void add_interpolated(const CoarseAxis& x, const CoarseAxis& y, const CellShape& coarse,
                      const AlignedVector<double>& from, const CellShape& fine, AlignedVector<double>& to) {
  const int last = x.cells() - 1;
  for (int row = 0; row <= fine.cells_y; ++row) {
    const double* lower = from.data() + coarse.node(y.left_of(row), 0);
    const double* upper = lower + coarse.stride();
    const double up = y.weight(row);
    const auto at = [&](int col) { return (1 - up) * lower[col] + up * upper[col]; };
    double* line = to.data() + fine.node(row, 0);
    for (int col = 0; col < last; ++col) {
      line[2 * col] += at(col);
      line[2 * col + 1] += 0.5 * (at(col) + at(col + 1));
    }
    for (int col = 2 * last; col <= fine.cells_x; ++col)
      line[col] += (1 - x.weight(col)) * at(last) + x.weight(col) * at(last + 1);
  }
}

/// Calls visit(copy, original) for every node of a wrapped grid that is a copy.
template <class Visit>
void each_copy(const CellShape& shape, const Visit& visit) {
  for (int row = 0; row <= shape.cells_y; ++row) visit(shape.node(row, shape.cells_x), shape.node(row, 0));
  for (int col = 0; col < shape.cells_x; ++col) visit(shape.node(shape.cells_y, col), shape.node(0, col));
}

}  // namespace

void fold_loads(const CellShape& shape, NodeField& field) {
  each_copy(shape, [&](std::size_t copy, std::size_t original) {
    for (AlignedVector<double>* values : {&field.x, &field.y}) {
      (*values)[original] += (*values)[copy];
      (*values)[copy] = 0;
    }
  });
}

void copy_displacements(const CellShape& shape, NodeField& field) {
  for (AlignedVector<double>* values : {&field.x, &field.y}) {
    each_copy(shape, [&](std::size_t copy, std::size_t original) { (*values)[copy] = (*values)[original]; });
    values->at(shape.node(shape.cells_y, shape.cells_x)) = values->front();
  }
}

int coarsenings(int cells_x, int cells_y) {
  int count = 0;
  while ((std::max(cells_x, cells_y) >> count) > 6 && (std::min(cells_x, cells_y) >> count) > 2) ++count;
  return count;
}

Multigrid::Multigrid(const FineGrid& fine, int coarsenings, const equilibrium::Kernels& kernels)
    : fine_(fine),
      edges_(fine.edges()),
      kernels_(kernels),
      levels_(static_cast<std::size_t>(coarsenings) + 1) {
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    Level& level = levels_[l];
    level.shape = {fine.shape().cells_x >> l, fine.shape().cells_y >> l};
    level.x = l == 0 ? CoarseAxis(level.shape.cells_x) : CoarseAxis(levels_[l - 1].x, level.shape.cells_x);
    level.y = l == 0 ? CoarseAxis(level.shape.cells_y) : CoarseAxis(levels_[l - 1].y, level.shape.cells_y);
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
  const CoarseAxis& x = levels_[index].x;
  const CoarseAxis& y = levels_[index].y;
  for (int fine_row = 2 * row; fine_row < 2 * row + y.children(row); ++fine_row)
    for (int fine_col = 2 * col; fine_col < 2 * col + x.children(col); ++fine_col)
      add_child(matrix, cell(index - 1, fine_row, fine_col),
                child_weights({x.weight_in(col, fine_col), x.weight_in(col, fine_col + 1)},
                              {y.weight_in(row, fine_row), y.weight_in(row, fine_row + 1)}),
                index == 1 ? fine_.held(fine_row, fine_col) : HeldNodes());
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
    int cell_row = row - corner / 2;
    int cell_col = col - corner % 2;
    if (edges_ == EdgeNodes::wrapped) {
      cell_row = (cell_row + level.shape.cells_y) % level.shape.cells_y;
      cell_col = (cell_col + level.shape.cells_x) % level.shape.cells_x;
    }
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

/// Nodes are numbered along the shorter side; on a wrapped grid the longer one is folded, so that both of its
/// ends, which are neighbours, have near numbers.
int Multigrid::unknown(int row, int col, int component) const {
  const CellShape& shape = levels_.back().shape;
  const bool wide = shape.cells_x > shape.cells_y;
  int along = wide ? col : row;
  int across = wide ? row : col;
  const int length = wide ? shape.cells_x : shape.cells_y;
  const int width = wide ? shape.cells_y : shape.cells_x;
  if (edges_ == EdgeNodes::wrapped) {
    along %= length;
    across %= width;
    along = 2 * along < length ? 2 * along : 2 * (length - along) - 1;
  }
  return 2 * (along * (width + 1) + across) + component;
}

void Multigrid::factorise() {
  const std::size_t index = levels_.size() - 1;
  const CellShape shape = levels_[index].shape;
  const int across = std::min(shape.cells_x, shape.cells_y) + 1;
  const int reach = edges_ == EdgeNodes::wrapped ? 3 : 1;
  coarsest_.reset(2 * across * (std::max(shape.cells_x, shape.cells_y) + 1), 2 * (reach * across + 1) + 1);
  // Without a support a corner stands for one; nothing pulls at it where loads are in balance.
  const int pinned = edges_ == EdgeNodes::held ? -1 : unknown(0, 0, 0);
  const int no_turning = edges_ == EdgeNodes::free ? unknown(0, shape.cells_x, 1) : -1;
  for (int row = 0; row < shape.cells_y; ++row)
    for (int col = 0; col < shape.cells_x; ++col) {
      const CellStiffness matrix = cell(index, row, col);
      const HeldNodes held = index == 0 ? fine_.held(row, col) : HeldNodes();
      const auto unknown_of = [&](int i) { return unknown(row + i % 4 / 2, col + i % 2, i / 4); };
      const auto is_held = [&](int i) {
        const int number = unknown_of(i);
        return number == no_turning || (pinned >= 0 && number / 2 == pinned / 2) ||
               (i < 4 ? held.x[static_cast<std::size_t>(i)] : held.y[static_cast<std::size_t>(i - 4)]);
      };
      for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j)
          if (!is_held(i) && !is_held(j)) coarsest_.add(unknown_of(i), unknown_of(j), matrix(i, j));
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
      for (Cell& one : cells)  // an odd one at the end is the third child of the last cell
        one = {std::min(one.row / 2, levels_[l].shape.cells_y - 1),
               std::min(one.col / 2, levels_[l].shape.cells_x - 1)};
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

void Multigrid::relax(std::size_t index, const NodeField& load, NodeField& u, double weight) {
  if (edges_ != EdgeNodes::wrapped) return sweep(index, load, u, u, kernels_.relax, weight);
  find_residual(index, load, u);
  add_relaxed(levels_[index], levels_[index].residual, u, weight);
  copy_displacements(levels_[index].shape, u);
}

/// Of the unknowns.
void Multigrid::find_residual(std::size_t index, const NodeField& load, const NodeField& u) {
  Level& level = levels_[index];
  sweep(index, load, u, level.residual, kernels_.residual, 0);
  if (edges_ == EdgeNodes::wrapped) fold_loads(level.shape, level.residual);
  if (index == 0) fine_.clear_held(level.residual);
}

/// The first relaxation, from rest.
void Multigrid::first_relax(std::size_t index, const NodeField& load, NodeField& u) const {
  const Level& level = levels_[index];
  std::fill(u.x.begin(), u.x.end(), 0.0);
  std::fill(u.y.begin(), u.y.end(), 0.0);
  add_relaxed(level, load, u, weights[0]);
  if (edges_ == EdgeNodes::wrapped) copy_displacements(level.shape, u);
}

void Multigrid::add_relaxed(const Level& level, const NodeField& load, NodeField& u, double weight) const {
  for (std::size_t i = 0; i < level.xx.size(); ++i) {
    u.x[i] += weight * (level.xx[i] * load.x[i] + level.xy[i] * load.y[i]);
    u.y[i] += weight * (level.xy[i] * load.x[i] + level.yy[i] * load.y[i]);
  }
}

void Multigrid::cycle(std::size_t index, const NodeField& load, NodeField& u) {
  if (index + 1 == levels_.size()) return solve_coarsest(load, u);
  Level& level = levels_[index];
  Level& coarse = levels_[index + 1];
  first_relax(index, load, u);
  relax(index, load, u, weights[1]);
  find_residual(index, load, u);
  restrict_to(coarse.x, coarse.y, coarse.shape, level.residual.x, level.shape, coarse.load.x);
  restrict_to(coarse.x, coarse.y, coarse.shape, level.residual.y, level.shape, coarse.load.y);
  if (edges_ == EdgeNodes::wrapped) fold_loads(coarse.shape, coarse.load);
  cycle(index + 1, coarse.load, coarse.solution);
  add_interpolated(coarse.x, coarse.y, coarse.shape, coarse.solution.x, level.shape, u.x);
  add_interpolated(coarse.x, coarse.y, coarse.shape, coarse.solution.y, level.shape, u.y);
  if (index == 0) fine_.clear_held(u);
  for (const double weight : weights) relax(index, load, u, weight);
}

void Multigrid::solve_coarsest(const NodeField& load, NodeField& u) {
  const CellShape shape = levels_.back().shape;
  unknowns_.assign(static_cast<std::size_t>(coarsest_.unknowns()), 0.0);
  const auto each = [&](auto&& visit) {
    for (int row = 0; row <= shape.cells_y; ++row)
      for (int col = 0; col <= shape.cells_x; ++col)
        visit(shape.node(row, col), static_cast<std::size_t>(unknown(row, col, 0)));
  };
  each([&](std::size_t at, std::size_t unknown) {
    unknowns_[unknown] += load.x[at];
    unknowns_[unknown + 1] += load.y[at];
  });
  coarsest_.solve(unknowns_);
  each([&](std::size_t at, std::size_t unknown) {
    u.x[at] = unknowns_[unknown];
    u.y[at] = unknowns_[unknown + 1];
  });
}

void Multigrid::precondition(const NodeField& r, NodeField& z) { cycle(0, r, z); }

}  // namespace mpm
