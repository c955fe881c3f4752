#include "libmpm/material/stiffness_bounds.hpp"

#include <algorithm>
#include <cmath>

namespace mpm {
namespace {

/// Mean over the phases of 1 / (modulus + added), inverted, less what was added: the arithmetic mean for an
/// infinite addition, the harmonic one for none.
double mean(const std::vector<PhaseShare>& phases, double PlaneModuli::*modulus, double added) {
  double sum = 0;
  for (const PhaseShare& phase : phases) {
    if (phase.moduli.*modulus + added <= 0) return 0;
    sum += phase.share / (phase.moduli.*modulus + added);
  }
  return 1 / sum - added;
}

double arithmetic_mean(const std::vector<PhaseShare>& phases, double PlaneModuli::*modulus) {
  double sum = 0;
  for (const PhaseShare& phase : phases) sum += phase.share * (phase.moduli.*modulus);
  return sum;
}

/// What surrounds every phase in the composite that attains the bound.
PlaneModuli hashin_shtrikman(const std::vector<PhaseShare>& phases, const PlaneModuli& around) {
  const double sum = around.bulk + 2 * around.shear;
  return {mean(phases, &PlaneModuli::bulk, around.shear),
          mean(phases, &PlaneModuli::shear, sum > 0 ? around.bulk * around.shear / sum : 0)};
}

}  // namespace

PlaneModuli plane_moduli(const Phase& phase, Plane plane) {
  const Eigen::Matrix3d c = stiffness(phase, plane);
  return {c(0, 1) + c(2, 2), c(2, 2)};
}

Eigen::Matrix3d stiffness(const PlaneModuli& moduli) {
  Eigen::Matrix3d c = Eigen::Matrix3d::Zero();
  c(0, 0) = c(1, 1) = moduli.bulk + moduli.shear;
  c(0, 1) = c(1, 0) = moduli.bulk - moduli.shear;
  c(2, 2) = moduli.shear;
  return c;
}

ElasticConstants elastic_constants(const PlaneModuli& moduli, Plane plane) {
  const auto& [bulk, shear] = moduli;
  if (!(bulk > 0)) return {};
  const double poisson = plane == Plane::strain ? 0.5 * (1 - shear / bulk) : (bulk - shear) / (bulk + shear);
  return {2 * shear * (1 + poisson), poisson};
}

NearestIsotropic nearest_isotropic(const Eigen::Matrix3d& stiffness) {
  const Eigen::DiagonalMatrix<double, 3> kelvin(1, 1, std::sqrt(2.0));
  const Eigen::Matrix3d c = kelvin * stiffness * kelvin;
  Eigen::Matrix3d areal = Eigen::Matrix3d::Zero();  // projects on the change of area
  areal.topLeftCorner<2, 2>().setConstant(0.5);
  const double of_area = areal.cwiseProduct(c).sum();
  const PlaneModuli moduli{0.5 * of_area, 0.25 * (c.trace() - of_area)};
  const Eigen::Matrix3d nearest =
      2 * moduli.bulk * areal + 2 * moduli.shear * (Eigen::Matrix3d::Identity() - areal);
  return {moduli, c.norm() > 0 ? (c - nearest).norm() / c.norm() : 0};
}

std::vector<PhaseShare> phase_shares(const Scene& scene) {
  std::vector<double> pixels(scene.phases.size(), 0.0);
  for (const std::uint8_t label : scene.labels.reshaped()) ++pixels[label];
  std::vector<PhaseShare> shares;
  for (std::size_t label = 0; label < pixels.size(); ++label) {
    if (pixels[label] <= 0) continue;
    const auto& phase = scene.phases[label];
    shares.push_back({pixels[label] / static_cast<double>(scene.labels.size()),
                      phase ? plane_moduli(*phase, scene.plane) : PlaneModuli()});
  }
  return shares;
}

StiffnessBounds stiffness_bounds(const std::vector<PhaseShare>& phases) {
  PlaneModuli least = phases.front().moduli;
  PlaneModuli most = least;
  for (const PhaseShare& phase : phases) {
    least = {std::min(least.bulk, phase.moduli.bulk), std::min(least.shear, phase.moduli.shear)};
    most = {std::max(most.bulk, phase.moduli.bulk), std::max(most.shear, phase.moduli.shear)};
  }
  return {
      .reuss = {mean(phases, &PlaneModuli::bulk, 0), mean(phases, &PlaneModuli::shear, 0)},
      .hashin_shtrikman_lower = hashin_shtrikman(phases, least),
      .hashin_shtrikman_upper = hashin_shtrikman(phases, most),
      .voigt = {arithmetic_mean(phases, &PlaneModuli::bulk), arithmetic_mean(phases, &PlaneModuli::shear)}};
}

}  // namespace mpm
