// The slow path beside the sweeps: points that the fast test suspects, and the extra points.
#include <cmath>

#include "libmpm/material/strength.hpp"
#include "libmpm/solver/lattice/lattice_solver.hpp"

namespace mpm {

template <class Real>
CellDisplacement LatticeSolver<Real>::displacement(int row, int cell) const {
  const auto lower = static_cast<std::size_t>(grid_.at(row, cell));
  const auto upper = static_cast<std::size_t>(grid_.at(row + 1, cell));
  return {{grid_.ux[lower], grid_.ux[lower + 1], grid_.ux[upper], grid_.ux[upper + 1]},
          {grid_.uy[lower], grid_.uy[lower + 1], grid_.uy[upper], grid_.uy[upper + 1]}};
}

/// Displacements at the end of the step before.
template <class Real>
CellDisplacement LatticeSolver<Real>::displacement_before(int row, int cell) const {
  CellDisplacement u = displacement(row, cell);
  for (int node = 0; node < 4; ++node) {
    const auto at = static_cast<std::size_t>(grid_.at(row + node / 2, cell + node % 2));
    u.ux[node] -= plan_.dt * grid_.vx[at];
    u.uy[node] -= plan_.dt * grid_.vy[at];
  }
  return u;
}

/// Elastic stress of a phase at a place of a cell, now and a step before [Pa].
template <class Real>
typename LatticeSolver<Real>::StepStress LatticeSolver<Real>::stress_at(const Eigen::Matrix3d& c, int row,
                                                                        int cell, double xi,
                                                                        double eta) const {
  return {stress_in_cell(c, displacement(row, cell), xi, eta, plan_.cell_size),
          stress_in_cell(c, displacement_before(row, cell), xi, eta, plan_.cell_size)};
}

template <class Real>
bool LatticeSolver<Real>::fail_suspects(Band& band, int row, double strain) {
  bool any = false;
  for (int cell = 0; cell < plan_.cells_x; ++cell) {
    if (band.suspects[static_cast<std::size_t>(cell)] == 0) continue;
    for (int plane = 0; plane < points_.planes; ++plane) any |= fail_point(band, row, plane, cell, strain);
  }
  return any;
}

/// Does to the point what its phase says; returns whether anything was done.
template <class Real>
bool LatticeSolver<Real>::fail_point(Band& band, int row, int plane, int cell, double strain) {
  const std::size_t at = points_.at(row, plane, cell);
  const auto reachable = [&](const AlignedVector<float>& thresholds) {
    return !thresholds.empty() && thresholds[at] < kernels::unreachable;
  };
  if (!reachable(points_.tension) && !reachable(points_.crush)) return false;
  const int k = scene_.points_per_cell;
  const int column_in_cell = plane % k;
  const int row_in_cell = plane / k;
  const Pixel pixel{static_cast<int>(scene_.labels.rows()) - 1 - (row * k + row_in_cell),
                    cell * k + column_in_cell};
  const Phase& phase = *scene_.phases[scene_.labels(pixel.row, pixel.col)];
  const StepStress elastic = stress_at(stiffness(phase, scene_.plane), row, cell, (column_in_cell + 0.5) / k,
                                       (row_in_cell + 0.5) / k);
  const PointKind kind{&phase, factors_.of_pixel(pixel.row, pixel.col),
                       shares_.size() > 0 ? 1.0 / shares_(pixel.row, pixel.col) : 1.0};
  const PointState before = read_point(points_, at, scene_, plan_, kind);
  const Response response = respond(before, elastic.now, law_);
  if (!response.changed) return false;
  write_point(points_, at, scene_, plan_, kind, response.point);
  // What is stored is what carries from now on, rounded.
  const PointState after = read_point(points_, at, scene_, plan_, kind);
  row_released_[static_cast<std::size_t>(row)] +=
      kind.share * (released_energy(before, after, elastic) + released_bending(before, after, row, cell));
  count_dead(band, before, response.point);
  if (response.failure != FailureMode::none) {
    count(band, response.failure);
    record_failure(pixel, response.failure, strain);
  }
  return true;
}

/// A point that failed before can only be crushed.
template <class Real>
void LatticeSolver<Real>::record_failure(const Pixel& pixel, FailureMode mode, double strain) {
  if (maps_.failure_mode(pixel.row, pixel.col) == 0) {
    maps_.failure_strain(pixel.row, pixel.col) = static_cast<float>(strain);
    maps_.failure_mode(pixel.row, pixel.col) = static_cast<std::uint8_t>(mode);
  } else if (maps_.crush_strain.size() > 0) {
    maps_.crush_strain(pixel.row, pixel.col) = static_cast<float>(strain);
  }
}

template <class Real>
void LatticeSolver<Real>::count(Band& band, FailureMode mode) {
  ++(mode == FailureMode::tension ? band.tension_failures : band.shear_failures);
}

template <class Real>
void LatticeSolver<Real>::count_dead(Band& band, const PointState& before, const PointState& after) {
  if (before.kept > 0 && !(after.kept > 0)) ++band.dead;
}

/// Energy that a whole pixel loses when it fails [J/m]. With the strain of the step before on one side of the
/// product, 1/2 u_(n-1) . dK . u_n, the ledger of the symplectic step closes to rounding.
template <class Real>
double LatticeSolver<Real>::released_energy(const PointState& before, const PointState& after,
                                            const StepStress& elastic) const {
  const auto power = [&](const PointState& point) {
    return stress_power(*point.phase, scene_.plane, carried_stress(point, elastic.now, law_), elastic.before);
  };
  return 0.5 * (power(before) - power(after)) * scene_.pixel_size * scene_.pixel_size;
}

/// The same of the bending of a pixel cell [J/m].
template <class Real>
double LatticeSolver<Real>::released_bending(const PointState& before, const PointState& after, int row,
                                             int cell) const {
  if (!scene_.pixel_cells) return 0;
  const CellDisplacement now = displacement(row, cell);
  const CellDisplacement then = displacement_before(row, cell);
  const auto product = [&](const double(&a)[4], const double(&b)[4]) {
    return bending(a, plan_.cell_size) * bending(b, plan_.cell_size);
  };
  const auto held = [](const PointState& point) { return point.kept * (1 - point.cracked); };
  const double k = bending_stiffness(stiffness(*before.phase, scene_.plane));
  return 0.5 * k * (held(before) - held(after)) * (product(now.ux, then.ux) + product(now.uy, then.uy)) *
         scene_.pixel_size * scene_.pixel_size;
}

template <class Real>
void LatticeSolver<Real>::sweep_extra_points(Band& band, int row, const kernels::NodeForces<Real>& lower,
                                             const kernels::NodeForces<Real>& upper, double strain) {
  const auto begin = extra_.row_begin[static_cast<std::size_t>(row)];
  const auto end = extra_.row_begin[static_cast<std::size_t>(row) + 1];
  for (std::size_t i = begin; i < end; ++i) {
    CellPoint& point = extra_.points[i];
    const Stress<double> elastic =
        stress_in_cell(point.stiffness, displacement(row, point.cell), point.xi, point.eta, plan_.cell_size);
    if (!point.state.spent) fail_extra_point(band, row, point, elastic, strain);
    const Stress<double> stress = carried_stress(point.state, elastic, law_);
    const CellForces f = forces_in_cell(stress, point.xi, point.eta, point.share * plan_.cell_size);
    const int cell = point.cell;
    lower.left_x[cell] += static_cast<Real>(f.x[0]);
    lower.right_x[cell] += static_cast<Real>(f.x[1]);
    upper.left_x[cell] += static_cast<Real>(f.x[2]);
    upper.right_x[cell] += static_cast<Real>(f.x[3]);
    lower.left_y[cell] += static_cast<Real>(f.y[0]);
    lower.right_y[cell] += static_cast<Real>(f.y[1]);
    upper.left_y[cell] += static_cast<Real>(f.y[2]);
    upper.right_y[cell] += static_cast<Real>(f.y[3]);
  }
}

template <class Real>
void LatticeSolver<Real>::fail_extra_point(Band& band, int row, CellPoint& point,
                                           const Stress<double>& elastic, double strain) {
  const Response response = respond(point.state, elastic, law_);
  if (!response.changed) return;
  row_released_[static_cast<std::size_t>(row)] +=
      point.share * released_energy(point.state, response.point,
                                    stress_at(point.stiffness, row, point.cell, point.xi, point.eta));
  count_dead(band, point.state, response.point);
  point.state = response.point;
  if (response.failure == FailureMode::none) return;
  count(band, response.failure);
  if (maps_.extra_failure_mode[point.index] != 0) return;
  maps_.extra_failure_strain[point.index] = static_cast<float>(strain);
  maps_.extra_failure_mode[point.index] = static_cast<std::uint8_t>(response.failure);
}

template class LatticeSolver<float>;
template class LatticeSolver<double>;

}  // namespace mpm
