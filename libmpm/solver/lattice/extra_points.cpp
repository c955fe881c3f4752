#include "libmpm/solver/lattice/extra_points.hpp"

#include <algorithm>

#include "libmpm/solver/grid.hpp"
#include "libmpm/material/strength_field.hpp"

namespace mpm {
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
