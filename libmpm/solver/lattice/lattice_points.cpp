#include "libmpm/solver/lattice/lattice_points.hpp"

#include <algorithm>
#include <cmath>

#include "libmpm/material/strength.hpp"
#include "libmpm/solver/grid.hpp"
#include "libmpm/solver/threshold.hpp"

namespace mpm {

double threshold_scale(const Plan& plan, const Phase& phase, double share) {
  return plan.features.one_poisson_ratio ? plan.cell_size / phase.young : plan.cell_size * share;
}

namespace {

/// Largest s1 that the shear threshold has to reckon with.
double largest_tension(const PointState& point) {
  return point.cracked == 1 ? 0 : tension_threshold(*point.phase, point.factor);
}

}  // namespace

template <class Real>
PointState read_point(const LatticePoints<Real>& points, std::size_t at, const Scene& scene, const Plan& plan,
                      const PointKind& kind) {
  const bool one_ratio = plan.features.one_poisson_ratio;
  const double intact =
      (one_ratio ? kind.phase->young : stiffness(*kind.phase, scene.plane)(2, 2)) * kind.share;
  const auto present = static_cast<double>(one_ratio ? points.stiffness[at] : points.shear[at]);
  PointState point = intact_point(*kind.phase, kind.factor);
  point.kept = present / static_cast<double>(static_cast<Real>(intact));
  point.cracked = points.cracked.empty() ? 0 : static_cast<double>(points.cracked[at]);
  const auto reachable = [&](const AlignedVector<float>& thresholds) {
    return !thresholds.empty() && thresholds[at] < kernels::unreachable;
  };
  if (!reachable(points.tension)) {
    point.strength = Phase::unbreakable;
  } else if (point.kept < 1 || point.cracked > 0) {
    point.strength = static_cast<double>(points.tension[at]) /
                     threshold_scale(plan, *kind.phase, kind.share) * (one_ratio ? point.kept : 1);
  }
  point.spent = !reachable(points.tension) && !reachable(points.crush);
  return point;
}

template <class Real>
void write_point(LatticePoints<Real>& points, std::size_t at, const Scene& scene, const Plan& plan,
                 const PointKind& kind, const PointState& point) {
  const double kept = point.kept * kind.share;
  const Phase& phase = *kind.phase;
  if (plan.features.one_poisson_ratio) {
    points.stiffness[at] = static_cast<Real>(phase.young * kept);
  } else {
    const Eigen::Matrix3d c = stiffness(phase, scene.plane);
    points.stiffness[at] = static_cast<Real>(c(0, 1) * kept);
    points.shear[at] = static_cast<Real>(c(2, 2) * kept);
  }
  if (!phase.can_fail()) return;
  const double seen = plan.features.one_poisson_ratio && point.kept > 0 ? point.kept : 1;
  const double scale = threshold_scale(plan, phase, kind.share) / seen;
  const auto threshold = [&](double stress) {
    return point.spent ? kernels::unreachable : stored_threshold(stress, scale);
  };
  if (!points.tension.empty()) points.tension[at] = threshold(point.strength);
  if (!points.crush.empty())
    points.crush[at] =
        threshold(shear_onset(phase, point.factor, largest_tension(point),
                              remaining_cohesion(point, damage_law(scene, plan.cell_size, false))));
  if (!points.cracked.empty()) points.cracked[at] = static_cast<float>(point.cracked);
}

template <class Real>
LatticePoints<Real> make_points(const Scene& scene, const Plan& plan, const StrengthFactors& factors) {
  const int k = scene.points_per_cell;
  LatticePoints<Real> points;
  points.planes = k * k;
  points.stride = padded(plan.cells_x);
  const auto size = static_cast<std::size_t>(plan.cells_y * points.planes * points.stride);
  points.stiffness.assign(size, Real(0));
  if (!plan.features.one_poisson_ratio) points.shear.assign(size, Real(0));
  if (plan.features.check != kernels::Check::none) points.tension.assign(size, kernels::unreachable);
  if (plan.features.check == kernels::Check::tension_and_shear)
    points.crush.assign(size, kernels::unreachable);
  if (plan.features.crack_closure) points.cracked.assign(size, 0.0F);

  const auto count = points_per_pixel(scene);
  const int rows = static_cast<int>(scene.labels.rows());
  const int cols = static_cast<int>(scene.labels.cols());
  for (int row = 0; row < rows; ++row) {
    const int from_below = rows - 1 - row;
    for (int col = 0; col < cols; ++col) {
      const auto& phase = scene.phases[scene.labels(row, col)];
      if (!phase) continue;
      const std::size_t at = points.at(from_below / k, from_below % k * k + col % k, col / k);
      const PointKind kind{&*phase, factors.of_pixel(row, col), 1.0 / count(row, col)};
      write_point(points, at, scene, plan, kind, intact_point(*phase, kind.factor));
    }
  }
  return points;
}

#define MPM_INSTANTIATE(Real)                                                                               \
  template LatticePoints<Real> make_points(const Scene&, const Plan&, const StrengthFactors&);              \
  template PointState read_point(const LatticePoints<Real>&, std::size_t, const Scene&, const Plan&,        \
                                 const PointKind&);                                                         \
  template void write_point(LatticePoints<Real>&, std::size_t, const Scene&, const Plan&, const PointKind&, \
                            const PointState&);
MPM_INSTANTIATE(float)
MPM_INSTANTIATE(double)

namespace {

CellPoint make_point(const Scene& scene, const Plan& plan, std::size_t index, double share) {
  const ExtraPoint& extra = scene.extra_points[index];
  const Phase& phase = *scene.phases[extra.phase];
  CellPoint point;
  const double x = extra.x / plan.cell_size;
  const double y = extra.y / plan.cell_size;
  point.cell = std::min(static_cast<int>(x), plan.cells_x - 1);
  point.xi = x - point.cell;
  point.eta = y - std::min(static_cast<int>(y), plan.cells_y - 1);
  point.share = share;
  point.state = intact_point(phase, StrengthFactors(scene, false).of_extra_point(index));
  point.stiffness = stiffness(phase, scene.plane);
  point.index = index;
  return point;
}

}  // namespace

double bending_stiffness(const Eigen::Matrix3d& stiffness) {
  const double ratio = stiffness(0, 1) / stiffness(0, 0);
  return stiffness(0, 0) * (1 - ratio * ratio) / 12;
}

Stress<double> stress_in_cell(const Eigen::Matrix3d& stiffness, const CellDisplacement& u, double xi,
                              double eta, double cell_size) {
  const auto along_x = [&](const double(&v)[4]) { return (1 - eta) * (v[1] - v[0]) + eta * (v[3] - v[2]); };
  const auto along_y = [&](const double(&v)[4]) { return (1 - xi) * (v[2] - v[0]) + xi * (v[3] - v[1]); };
  const double exx = along_x(u.ux) / cell_size;
  const double eyy = along_y(u.uy) / cell_size;
  const double gxy = (along_y(u.ux) + along_x(u.uy)) / cell_size;
  return elastic_stress(stiffness(0, 1), stiffness(2, 2), exx, eyy, gxy);
}

CellForces forces_in_cell(const Stress<double>& s, double xi, double eta, double scale) {
  const double n = (1 - xi) * scale;
  const double f = xi * scale;
  const double l = (1 - eta) * scale;
  const double u = eta * scale;
  return {{l * s.xx + n * s.xy, -l * s.xx + f * s.xy, u * s.xx - n * s.xy, -u * s.xx - f * s.xy},
          {n * s.yy + l * s.xy, f * s.yy - l * s.xy, -n * s.yy + u * s.xy, -f * s.yy - u * s.xy}};
}

ExtraPoints make_extra_points(const Scene& scene, const Plan& plan) {
  ExtraPoints extra;
  if (scene.extra_points.empty()) return extra;
  const auto count = points_per_pixel(scene);
  std::vector<std::vector<std::size_t>> by_row(static_cast<std::size_t>(plan.cells_y));
  for (std::size_t i = 0; i < scene.extra_points.size(); ++i) {
    if (!scene.phases[scene.extra_points[i].phase]) continue;
    const int row = std::min(static_cast<int>(scene.extra_points[i].y / plan.cell_size), plan.cells_y - 1);
    by_row[static_cast<std::size_t>(row)].push_back(i);
  }
  extra.row_begin.push_back(0);
  for (const auto& indices : by_row) {
    for (const std::size_t i : indices) {
      const Pixel pixel = pixel_at(scene, scene.extra_points[i].x, scene.extra_points[i].y);
      extra.points.push_back(make_point(scene, plan, i, 1.0 / count(pixel.row, pixel.col)));
    }
    extra.row_begin.push_back(extra.points.size());
  }
  return extra;
}

}  // namespace mpm
