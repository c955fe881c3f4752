// The end of small strain, and what moving points go on from.
#include <cmath>

#include "libmpm/solver/lattice/lattice_solver.hpp"

namespace mpm {
namespace {

/// Deviation from a straight line fitted by least squares.
class Line {
 public:
  void add(double x, double y) {
    ++n_;
    x_ += x;
    y_ += y;
    xx_ += x * x;
    xy_ += x * y;
  }
  [[nodiscard]] double deviation(double x, double y) const {
    const double spread = n_ * xx_ - x_ * x_;
    const double slope = spread > 0 ? (n_ * xy_ - x_ * y_) / spread : 0;
    return y - (y_ + slope * (n_ * x - x_)) / n_;
  }

 private:
  double n_ = 0, x_ = 0, y_ = 0, xx_ = 0, xy_ = 0;
};

/// Displacement gradient at a place of a cell, times the cell size.
struct CellGradient {
  double xx, xy, yx, yy;
};
CellGradient gradient_in_cell(const CellDisplacement& u, double xi, double eta) {
  const auto along_x = [&](const double(&v)[4]) { return (1 - eta) * (v[1] - v[0]) + eta * (v[3] - v[2]); };
  const auto along_y = [&](const double(&v)[4]) { return (1 - xi) * (v[2] - v[0]) + xi * (v[3] - v[1]); };
  return {along_x(u.ux), along_y(u.ux), along_x(u.uy), along_y(u.uy)};
}

double in_cell(const double (&v)[4], double xi, double eta) {
  return (1 - eta) * ((1 - xi) * v[0] + xi * v[1]) + eta * ((1 - xi) * v[2] + xi * v[3]);
}

}  // namespace

template <class Real>
bool LatticeSolver<Real>::outgrows(const Handover& limits) const {
  return strains_more_than(limits.strain) || strays_more_than(limits.displacement * plan_.cell_size);
}

template <class Real>
PointState LatticeSolver<Real>::state_of(int pixel_row, int pixel_col, std::size_t at) const {
  const Phase& phase = *scene_.phases[scene_.labels(pixel_row, pixel_col)];
  const PointKind kind{&phase, factors_.of_pixel(pixel_row, pixel_col),
                       shares_.size() > 0 ? 1.0 / shares_(pixel_row, pixel_col) : 1.0};
  return read_point(points_, at, scene_, plan_, kind);
}

/// A point that has lost nothing, and is not void.
template <class Real>
bool LatticeSolver<Real>::is_intact(int row, int plane, int cell) const {
  const int k = scene_.points_per_cell;
  const int pixel_row = static_cast<int>(scene_.labels.rows()) - 1 - (row * k + plane / k);
  const int pixel_col = cell * k + plane % k;
  const auto& phase = scene_.phases[scene_.labels(pixel_row, pixel_col)];
  if (!phase) return false;
  const PointState point = state_of(pixel_row, pixel_col, points_.at(row, plane, cell));
  return point.kept == 1 && point.cracked == 0;
}

template <class Real>
bool LatticeSolver<Real>::strains_more_than(double limit) const {
  const int k = scene_.points_per_cell;
  for (int row = 0; row < plan_.cells_y; ++row) {
    for (int cell = 0; cell < plan_.cells_x; ++cell) {
      const CellDisplacement u = displacement(row, cell);
      for (int plane = 0; plane < points_.planes; ++plane) {
        const int across = plane % k, upwards = plane / k;
        const CellGradient g = gradient_in_cell(u, (across + 0.5) / k, (upwards + 0.5) / k);
        const double largest =
            0.5 * (std::abs(g.xx + g.yy) + std::hypot(g.xx - g.yy, g.xy + g.yx)) / plan_.cell_size;
        if (largest > limit && is_intact(row, plane, cell)) return true;
      }
    }
  }
  return false;
}

/// Whether a node is further than `limit` [m] from where the mean motion between the platens would have it.
template <class Real>
bool LatticeSolver<Real>::strays_more_than(double limit) const {
  Line along_x, along_y;
  const auto for_each_node = [&](auto&& visit) {
    for (int row = 0; row < grid_.rows; ++row)
      for (int col = 0; col < grid_.cols; ++col)
        if (const auto at = static_cast<std::size_t>(grid_.at(row, col)); grid_.impulse_over_mass[at] > 0)
          visit(row, col, at);
  };
  for_each_node([&](int row, int col, std::size_t at) {
    along_x.add(col, grid_.ux[at]);
    along_y.add(row, grid_.uy[at]);
  });
  bool any = false;
  for_each_node([&](int row, int col, std::size_t at) {
    any |= std::abs(along_x.deviation(col, grid_.ux[at])) > limit ||
           std::abs(along_y.deviation(row, grid_.uy[at])) > limit;
  });
  return any;
}

template <class Real>
CellDisplacement LatticeSolver<Real>::velocity(int row, int cell) const {
  CellDisplacement v;
  for (int node = 0; node < 4; ++node) {
    const auto at = static_cast<std::size_t>(grid_.at(row + node / 2, cell + node % 2));
    v.ux[node] = grid_.vx[at];
    v.uy[node] = grid_.vy[at];
  }
  return v;
}

/// Place, velocity, stress and stretch of a point at a place of a cell whose nodes have moved by u.
template <class Real>
StartPoint LatticeSolver<Real>::moved(int row, int cell, double xi, double eta, const Eigen::Matrix3d& c,
                                      const CellDisplacement& u) const {
  const double h = plan_.cell_size;
  const CellDisplacement v = velocity(row, cell);
  const CellGradient g = gradient_in_cell(u, xi, eta);
  StartPoint point;
  point.x = (cell + xi) * h + in_cell(u.ux, xi, eta);
  point.y = (row + eta) * h + in_cell(u.uy, xi, eta);
  point.vx = in_cell(v.ux, xi, eta);
  point.vy = in_cell(v.uy, xi, eta);
  point.stress = stress_in_cell(c, u, xi, eta, h);
  point.volume = (1 + g.xx / h) * (1 + g.yy / h) - g.xy * g.yx / (h * h);  // over the one at rest
  return point;
}

template <class Real>
void LatticeSolver<Real>::hand_over_pixels(MovingStart& start) const {
  const int k = scene_.points_per_cell;
  const int rows = static_cast<int>(scene_.labels.rows());
  const int cols = static_cast<int>(scene_.labels.cols());
  for (int row = 0; row < rows; ++row) {
    const int from_below = rows - 1 - row;
    for (int col = 0; col < cols; ++col) {
      const auto& phase = scene_.phases[scene_.labels(row, col)];
      if (!phase) continue;
      const int plane = from_below % k * k + col % k;
      StartPoint point = moved(from_below / k, col / k, (col % k + 0.5) / k, (from_below % k + 0.5) / k,
                               stiffness(*phase, scene_.plane), displacement(from_below / k, col / k));
      point.id = static_cast<std::uint32_t>(row * cols + col);
      const double share = shares_.size() > 0 ? 1.0 / shares_(row, col) : 1.0;
      const double area = share * scene_.pixel_size * scene_.pixel_size;
      point.mass = phase->density * area;
      point.volume *= area;
      point.take(state_of(row, col, points_.at(from_below / k, plane, col / k)));
      start.points.push_back(point);
    }
  }
}

template <class Real>
void LatticeSolver<Real>::hand_over_extra_points(MovingStart& start) const {
  for (std::size_t row = 0; row + 1 < extra_.row_begin.size(); ++row) {
    for (std::size_t i = extra_.row_begin[row]; i < extra_.row_begin[row + 1]; ++i) {
      const CellPoint& extra = extra_.points[i];
      StartPoint point = moved(static_cast<int>(row), extra.cell, extra.xi, extra.eta, extra.stiffness,
                               displacement(static_cast<int>(row), extra.cell));
      point.id = static_cast<std::uint32_t>(static_cast<std::size_t>(scene_.labels.size()) + extra.index);
      const double area = extra.share * scene_.pixel_size * scene_.pixel_size;
      point.mass = extra.state.phase->density * area;
      point.volume *= area;
      point.take(extra.state);
      start.points.push_back(point);
    }
  }
}

template <class Real>
MovingStart LatticeSolver<Real>::hand_over() {
  MovingStart start;
  hand_over_pixels(start);
  if (!extra_.points.empty()) hand_over_extra_points(start);
  for (StartPoint& point : start.points) {
    point.stress.xx *= point.kept;
    point.stress.yy *= point.kept;
    point.stress.xy *= point.kept;
  }
  const Ledger ledger = balance();
  start.step = clock_.step;
  start.time = static_cast<double>(clock_.step) * plan_.dt;
  start.platen_displacement = clock_.displacement + plan_.dt * clock_.next_velocity;
  start.platen_velocity = clock_.next_velocity;
  start.tally = {ledger.platen_work, ledger.released, ledger.damped, ledger.tension_failures,
                 ledger.shear_failures};
  start.maps = std::move(maps_);
  team_.dismiss();
  return start;
}

template <class Real>
void LatticeSolver<Real>::copy_maps(Result& result) const {
  maps_.copy_to(result);
}

template class LatticeSolver<float>;
template class LatticeSolver<double>;

}  // namespace mpm
