#include "libmpm/lattice_points.hpp"

#include <algorithm>
#include <cmath>

#include "libmpm/grid.hpp"
#include "libmpm/strength.hpp"

namespace mpm {

double threshold_scale(const Plan& plan, const Phase& phase, double share) {
  return plan.features.one_poisson_ratio ? plan.cell_size / phase.young : plan.cell_size * share;
}

float stored_threshold(double stress, double scale) {
  const double scaled = stress * scale;
  if (!(scaled < static_cast<double>(kernels::unreachable))) return kernels::unreachable;
  const auto rounded = static_cast<float>(scaled);
  return static_cast<double>(rounded) > scaled ? std::nextafterf(rounded, 0.0F) : rounded;
}

namespace {

template <class Real>
void set_point(LatticePoints<Real>& points, std::size_t at, const Scene& scene, const Plan& plan,
               const Phase& phase, double share, double random) {
  const Eigen::Matrix3d c = stiffness(phase, scene.plane);
  if (plan.features.one_poisson_ratio) {
    points.stiffness[at] = static_cast<Real>(phase.young * share);
  } else {
    points.stiffness[at] = static_cast<Real>(c(0, 1) * share);
    points.shear[at] = static_cast<Real>(c(2, 2) * share);
  }
  if (!phase.can_fail()) return;
  const double factor = strength_factor(random, phase.weibull_modulus);
  const double scale = threshold_scale(plan, phase, share);
  const double tension = tension_threshold(phase, factor);
  if (!points.tension.empty()) points.tension[at] = stored_threshold(tension, scale);
  if (!points.crush.empty()) points.crush[at] = stored_threshold(shear_onset(phase, factor, tension), scale);
}

}  // namespace

template <class Real>
LatticePoints<Real> make_points(const Scene& scene, const Plan& plan) {
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
      set_point(points, at, scene, plan, *phase, 1.0 / count(row, col),
                pixel_random(scene.damage.seed, row, col));
    }
  }
  return points;
}

template LatticePoints<float> make_points(const Scene&, const Plan&);
template LatticePoints<double> make_points(const Scene&, const Plan&);

}  // namespace mpm
