#include "libmpm/problems/plate.hpp"

#include <cmath>

#include "libmpm/problems/method.hpp"
#include "libmpm/solver/lattice/lattice_solver.hpp"
#include "libmpm/solver/moving/moving_solver.hpp"
#include "libmpm/solver/quasi_static/quasi_static_solver.hpp"

namespace mpm::problems {
namespace {

constexpr double young = 1e7;  // of the plate [Pa]

PlateStress at_pixel(const Scene& scene, std::uint32_t id, const Stress<double>& s, double load) {
  const auto cols = static_cast<std::uint32_t>(scene.labels.cols());
  const int row = static_cast<int>(id / cols);
  const int col = static_cast<int>(id % cols);
  return {(col + 0.5) * scene.pixel_size - 0.5 * scene.width(),
          0.5 * scene.height() - (row + 0.5) * scene.pixel_size,
          scene.labels(row, col),
          {s.xx / load, s.yy / load, s.xy / load}};
}

/// Stress of a point by its id [Pa].
struct PointStress {
  std::uint32_t id = 0;
  Stress<double> stress;
};

/// Energies that are none, or no number, are those of a step that is too long for the damping.
std::string trouble_of(const Ledger& ledger) {
  if (!ledger.trouble.empty()) return ledger.trouble;
  const double energy = std::abs(ledger.kinetic) + std::abs(ledger.elastic) + std::abs(ledger.damped);
  return energy <= 10 * std::abs(ledger.platen_work) ? "" : "energy grows without work: the step is too long";
}

/// @param points_of  of a solver that has come to its end.
template <class Solver, class PointsOf>
StaticPlate pull_to_the_end(const Scene& scene, Solver& solver, const PointsOf& points_of) {
  Meter meter(count_points(scene));
  const Ledger ledger = meter.advance(solver, 1'000'000'000);
  StaticPlate result;
  result.cost = meter.cost();
  result.trouble = trouble_of(ledger);
  const double load = 0.5 * (ledger.force_top - ledger.force_bottom) / scene.width();
  result.modulus = load / (ledger.platen_displacement / scene.height());
  for (const auto& p : points_of(solver)) result.points.push_back(at_pixel(scene, p.id, p.stress, load));
  return result;
}

/// One step: the elastic plate is in equilibrium at its full strain.
StaticPlate pull_without_waves(const Scene& scene) {
  const Plan plan = mpm::plan(scene);
  QuasiStaticSolver solver(scene, plan);
  return pull_to_the_end(scene, solver, [](const auto& it) {
    Frame frame;
    it.fill(frame);
    std::vector<PointStress> points;
    for (const FramePoint& p : frame.points) points.push_back({p.id, {p.sxx, p.syy, p.sxy}});
    return points;
  });
}

template <class Real>
StaticPlate pull_in(const Scene& scene) {
  const Plan plan = mpm::plan(scene);
  if (scene.kinematics == Kinematics::moving) {
    MovingSolver<Real> solver(scene, plan, pictured_start(scene, plan));
    return pull_to_the_end(scene, solver, [](const auto& it) { return it.points(); });
  }
  LatticeSolver<Real> solver(scene, plan);
  return pull_to_the_end(scene, solver, [](auto& it) { return it.hand_over().points; });
}

}  // namespace

Scene plate(int pixels, double ratio_of_moduli) {
  Scene scene;
  scene.labels.setConstant(pixels, pixels, soft);
  scene.pixel_size = 1.0 / pixels;
  Phase phase;
  phase.name = "matrix";
  phase.young = young;
  phase.poisson = 0.2;
  phase.density = 1000;
  scene.phases = {std::nullopt, phase};
  phase.young *= ratio_of_moduli;
  scene.phases.emplace_back(phase);
  scene.loading.velocity = 0.01;
  scene.loading.stop_strain = 1e-3;
  scene.local_damping = 0.6;
  scene.motion.margin = 0.05;
  return scene;
}

void draw_disc(Scene& scene, double radius, std::uint8_t label) {
  const auto n = static_cast<double>(scene.labels.rows());
  for (int row = 0; row < scene.labels.rows(); ++row)
    for (int col = 0; col < scene.labels.cols(); ++col)
      if (std::hypot(col + 0.5 - 0.5 * n, row + 0.5 - 0.5 * n) < radius * n) scene.labels(row, col) = label;
}

StaticPlate pull(const Scene& scene) {
  if (scene.method == SolverMethod::quasi_static) return pull_without_waves(scene);
  return scene.precision == Precision::single ? pull_in<float>(scene) : pull_in<double>(scene);
}

DiscStress goodier() {
  const double m = 2, k = 3 - 4 * 0.2;
  const double mean = 0.5 * m * (k + 1) / (2 * m + (k - 1));
  const double deviator = 0.5 * m * (k + 1) / (1 + k * m);
  return {mean + deviator, mean - deviator};
}

InclusionErrors inclusion_errors(const StaticPlate& plate, double radius) {
  const DiscStress exact = goodier();
  InclusionErrors errors;
  int all = 0, inner = 0;
  for (const PlateStress& point : plate.points) {
    if (point.label != soft + 1) continue;
    ++all;
    errors.mean += point.stress.yy - exact.along;
    if (std::hypot(point.x, point.y) > 0.5 * radius) continue;
    ++inner;
    errors.inner += std::pow(point.stress.yy - exact.along, 2) + std::pow(point.stress.xx - exact.across, 2) +
                    2 * std::pow(point.stress.xy, 2);
  }
  return {errors.mean / all, std::sqrt(errors.inner / inner)};
}

double kirsch(double x_over_a) {
  const double q = 1 / x_over_a;
  return 0.5 * (2 + q * q + 3 * q * q * q * q);
}

double hole_error(const StaticPlate& plate, double radius, double pixel_size) {
  double square = 0;
  int points = 0;
  for (const PlateStress& p : plate.points) {
    const double x = std::abs(p.x) / radius;
    if (x < 1.25 || x > 3 || std::abs(p.y) > pixel_size) continue;
    square += std::pow(p.stress.yy - kirsch(x), 2);
    ++points;
  }
  return std::sqrt(square / points);
}

Scene layered_plate(int pixels, Layers layers) {
  Scene scene = plate(pixels);
  scene.phases[1]->poisson = scene.phases[2]->poisson = 0;
  if (layers == Layers::along)
    scene.labels.leftCols(pixels / 2).setConstant(2);
  else
    scene.labels.topRows(pixels / 2).setConstant(2);
  return scene;
}

double layered_modulus(Layers layers) {
  return layers == Layers::along ? 1.5 * young : 1 / (0.5 / young + 0.5 / (2 * young));
}

}  // namespace mpm::problems
