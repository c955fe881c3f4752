// The cells and nodes of the grids of a multigrid: made, and made anew where points fail.
#include <algorithm>
#include <array>
#include <utility>

#include "libmpm/solver/quasi_static/multigrid.hpp"

namespace mpm {

template <class Real>
void MultigridOf<Real>::make_level(std::size_t index) {
  Level& level = levels_[index];
  const Level* finer = index > 0 ? &levels_[index - 1] : nullptr;
  level.shape = {fine_.shape().cells_x >> index, fine_.shape().cells_y >> index};
  const int rows = level.shape.cells_y;
  level.x = finer == nullptr ? CoarseAxis(level.shape.cells_x) : CoarseAxis(finer->x, level.shape.cells_x);
  level.y = finer == nullptr ? CoarseAxis(rows) : CoarseAxis(finer->y, rows);
  for (auto* field : {&level.inverse.xx, &level.inverse.xy, &level.inverse.yy})
    field->assign(level.shape.nodes(), Real(0));
  level.slants.assign(static_cast<std::size_t>(level.shape.cell_stride()), 1.0F);
  for (int col = 0; col < level.shape.cells_x; ++col)
    level.slants[static_cast<std::size_t>(col)] =
        static_cast<float>(1 << index) / static_cast<float>(level.x.length(col));
  level.sweeps.resize(rows, level.shape.cell_stride(),
                      StaggeredSweep<Real>::bands_for(rows, level.shape.cells(), team_.threads()));
  sort_rows(index);
  if (finer != nullptr) {
    level.load = level.solution = level.residual = level.shape.template zeros<Real>();
    level.sweeps.each_row(team_, [&](int row) {
      for (int col = 0; col < level.shape.cells_x && row < rows; ++col) make_cell(index, row, col);
    });
  }
  level.sweeps.each_row(team_, [&](int row) {
    for (int col = 0; col <= level.shape.cells_x; ++col) make_node(index, row, col);
  });
}

/// Rows whose cells have nodes that are held in the finest grid resist more than strain; and those of the
/// last row may have another height, which the slants do not know.
template <class Real>
void MultigridOf<Real>::sort_rows(std::size_t index) {
  Level& level = levels_[index];
  const Level* finer = index > 0 ? &levels_[index - 1] : nullptr;
  const int rows = level.shape.cells_y;
  int counts[2] = {0, 0};
  for (int row = 0; row < rows; ++row) {
    bool has_modes = true;
    if (finer == nullptr) {
      for (int col = 0; col < level.shape.cells_x; ++col) has_modes &= !fine_.held(row, col).any();
    } else {
      has_modes = level.y.length(row) == 1 << index;
      for (int child = 0; child < level.y.children(row); ++child)
        has_modes &= finer->has_modes[static_cast<std::size_t>(2 * row + child)] != 0;
    }
    level.has_modes.push_back(has_modes ? 1 : 0);
    level.place.push_back(counts[has_modes ? 1 : 0]++);
  }
  if (finer == nullptr) return;
  const auto planes = [&](int entries, int of_rows) {
    return AlignedVector<float>(static_cast<std::size_t>(entries * level.shape.cell_stride() * of_rows),
                                0.0F);
  };
  level.by_nodes = planes(equilibrium::node_entries, counts[0]);
  level.by_modes = planes(equilibrium::mode_entries, counts[1]);
}

template <class Real>
const float* MultigridOf<Real>::entries(const Level& level, int row, int col) const {
  const auto r = static_cast<std::size_t>(row);
  const std::ptrdiff_t stride = level.shape.cell_stride();
  return level.has_modes[r] != 0
             ? level.by_modes.data() + equilibrium::mode_entries * stride * level.place[r] + col
             : level.by_nodes.data() + equilibrium::node_entries * stride * level.place[r] + col;
}
template <class Real>
float* MultigridOf<Real>::entries(std::size_t index, int row, int col) {
  return const_cast<float*>(entries(std::as_const(levels_[index]), row, col));  // they are ours
}

namespace {

template <class Matrix>
Matrix read_matrix(const float* entry, std::ptrdiff_t stride) {
  Matrix matrix;
  for (int i = 0; i < Matrix::RowsAtCompileTime; ++i)
    for (int j = i; j < Matrix::RowsAtCompileTime; ++j, entry += stride)
      matrix(i, j) = matrix(j, i) = static_cast<double>(*entry);
  return matrix;
}

template <class Matrix>
void write_matrix(const Matrix& matrix, float* entry, std::ptrdiff_t stride) {
  for (int i = 0; i < Matrix::RowsAtCompileTime; ++i)
    for (int j = i; j < Matrix::RowsAtCompileTime; ++j, entry += stride)
      *entry = static_cast<float>(matrix(i, j));
}

}  // namespace

/// @pre the finest grid, or the row has modes.
template <class Real>
CellModes MultigridOf<Real>::modes(std::size_t index, int row, int col) const {
  if (index == 0) return fine_.cell(row, col);
  return read_matrix<CellModes>(entries(levels_[index], row, col), levels_[index].shape.cell_stride());
}

template <class Real>
CellStiffness MultigridOf<Real>::cell(std::size_t index, int row, int col) const {
  const Level& level = levels_[index];
  if (index == 0 || level.has_modes[static_cast<std::size_t>(row)] != 0)
    return by_nodes(modes(index, row, col), static_cast<double>(level.slants[static_cast<std::size_t>(col)]));
  return read_matrix<CellStiffness>(entries(level, row, col), level.shape.cell_stride());
}

template <class Real>
NodeStiffness MultigridOf<Real>::corner(std::size_t index, int row, int col, int corner) const {
  const Level& level = levels_[index];
  if (index == 0 || level.has_modes[static_cast<std::size_t>(row)] != 0)
    return at_corner(modes(index, row, col), static_cast<double>(level.slants[static_cast<std::size_t>(col)]),
                     corner);
  return at_corner(cell(index, row, col), corner);
}

template <class Real>
void MultigridOf<Real>::make_cell(std::size_t index, int row, int col) {
  const Level& level = levels_[index];
  const CoarseAxis& x = level.x;
  const CoarseAxis& y = level.y;
  const auto each_child = [&](auto&& add) {
    for (int fine_row = 2 * row; fine_row < 2 * row + y.children(row); ++fine_row)
      for (int fine_col = 2 * col; fine_col < 2 * col + x.children(col); ++fine_col) add(fine_row, fine_col);
  };
  const auto weights_of = [&](int fine_row, int fine_col) {
    return child_weights({x.weight_in(col, fine_col), x.weight_in(col, fine_col + 1)},
                         {y.weight_in(row, fine_row), y.weight_in(row, fine_row + 1)});
  };
  if (level.has_modes[static_cast<std::size_t>(row)] == 0) {
    CellStiffness matrix = CellStiffness::Zero();
    each_child([&](int fine_row, int fine_col) {
      add_child(matrix, cell(index - 1, fine_row, fine_col), weights_of(fine_row, fine_col),
                index == 1 ? fine_.held(fine_row, fine_col) : HeldNodes());
    });
    return write_matrix(matrix, entries(index, row, col), level.shape.cell_stride());
  }
  static const std::array<CellModes, 4> halves{child_modes(child_weights({0, 0.5}, {0, 0.5}), 1, 1),
                                               child_modes(child_weights({0.5, 1}, {0, 0.5}), 1, 1),
                                               child_modes(child_weights({0, 0.5}, {0.5, 1}), 1, 1),
                                               child_modes(child_weights({0.5, 1}, {0.5, 1}), 1, 1)};
  const float slant = level.slants[static_cast<std::size_t>(col)];
  CellModes matrix = CellModes::Zero();
  each_child([&](int fine_row, int fine_col) {
    const float of_child = levels_[index - 1].slants[static_cast<std::size_t>(fine_col)];
    if (slant == 1 && of_child == 1 && x.halves(col) && y.halves(row))
      add_child(matrix, modes(index - 1, fine_row, fine_col),
                halves[static_cast<std::size_t>(2 * (fine_row - 2 * row) + fine_col - 2 * col)]);
    else
      add_child(matrix, modes(index - 1, fine_row, fine_col),
                child_modes(weights_of(fine_row, fine_col), static_cast<double>(of_child),
                            static_cast<double>(slant)));
  });
  write_matrix(matrix, entries(index, row, col), level.shape.cell_stride());
}

/// The inverse of the block of a node; zero for what is held or has no stiffness.
template <class Real>
void MultigridOf<Real>::make_node(std::size_t index, int row, int col) {
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
    const NodeStiffness part = this->corner(index, cell_row, cell_col, corner);
    xx += part.xx;
    xy += part.xy;
    yy += part.yy;
    if (index > 0) continue;
    const HeldNodes held = fine_.held(cell_row, cell_col);
    held_x |= held.x[static_cast<std::size_t>(corner)];
    held_y |= held.y[static_cast<std::size_t>(corner)];
  }
  if (held_x) xx = xy = 0;
  if (held_y) yy = xy = 0;
  const std::size_t at = level.shape.node(row, col);
  const double determinant = xx * yy - xy * xy;
  NodeStiffness inverse;
  if (determinant > 1e-8 * xx * yy)
    inverse = {yy / determinant, -xy / determinant, xx / determinant};
  else
    inverse = {xx > 0 ? 1 / xx : 0, 0, yy > 0 ? 1 / yy : 0};
  level.inverse.xx[at] = static_cast<Real>(inverse.xx);
  level.inverse.xy[at] = static_cast<Real>(inverse.xy);
  level.inverse.yy[at] = static_cast<Real>(inverse.yy);
}

/// Nodes are numbered along the shorter side; on a wrapped grid the longer one is folded, so that both of its
/// ends, which are neighbours, have near numbers.
template <class Real>
int MultigridOf<Real>::unknown(int row, int col, int component) const {
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

template <class Real>
void MultigridOf<Real>::factorise() {
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

template <class Real>
void MultigridOf<Real>::update(std::vector<Cell> cells) {
  const auto same = [](const Cell& a, const Cell& b) { return a.row == b.row && a.col == b.col; };
  const auto before = [](const Cell& a, const Cell& b) {
    return a.row != b.row ? a.row < b.row : a.col < b.col;
  };
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    if (l > 0) {
      const CoarseAxis& x = levels_[l].x;
      const CoarseAxis& y = levels_[l].y;
      for (Cell& one : cells) one = {y.left_of(one.row), x.left_of(one.col)};
      std::sort(cells.begin(), cells.end(), before);
      cells.erase(std::unique(cells.begin(), cells.end(), same), cells.end());
      for (const Cell& one : cells) make_cell(l, one.row, one.col);
    }
    for (const Cell& one : cells)
      for (int corner = 0; corner < 4; ++corner) make_node(l, one.row + corner / 2, one.col + corner % 2);
  }
  factorise();
}

#define MPM_INSTANTIATE_CELLS(Real)                                               \
  template void MultigridOf<Real>::make_level(std::size_t);                       \
  template const float* MultigridOf<Real>::entries(const Level&, int, int) const; \
  template int MultigridOf<Real>::unknown(int, int, int) const;                   \
  template void MultigridOf<Real>::factorise();                                   \
  template void MultigridOf<Real>::update(std::vector<Cell>);
MPM_INSTANTIATE_CELLS(float)
MPM_INSTANTIATE_CELLS(double)
#undef MPM_INSTANTIATE_CELLS

}  // namespace mpm
