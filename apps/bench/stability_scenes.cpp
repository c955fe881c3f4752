#include "apps/bench/stability_scenes.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

namespace app::bench {

Judge& Judge::add(const std::string& seen) {
  if (!seen_.empty()) seen_ += "; ";
  seen_ += seen;
  return *this;
}

Judge& Judge::note(const std::string& seen) { return add(seen); }

Judge& Judge::must(bool holds, const std::string& seen) {
  judged_ = true;
  holds_ = holds_ && holds;
  return add(holds ? seen : "NOT AS IT MUST BE: " + seen);
}

Judge& Judge::near(const std::string& what, double value, double exact, double tolerance) {
  const double off = std::abs(value / exact - 1);
  return must(off <= tolerance, fmt::format("{} {:.5g}, exact {:.5g}, off by {:.1e} (at most {:.0e})", what,
                                            value, exact, off, tolerance));
}

Judge& Judge::no_trouble(const std::string& trouble, std::int64_t steps) {
  return must(trouble.empty(), trouble.empty() ? fmt::format("{} steps", steps) : trouble);
}

Judge& Judge::below(const std::string& what, double value, double limit) {
  return must(value <= limit, fmt::format("{} {:.3g} (at most {:.3g})", what, value, limit));
}

Finding Judge::finding() const { return {holds_ && judged_, seen_}; }

mpm::Phase elastic(double young, double poisson, double density) {
  mpm::Phase phase;
  phase.name = "elastic";
  phase.young = young;
  phase.poisson = poisson;
  phase.density = density;
  return phase;
}

mpm::Scene block(int rows, int cols, const mpm::Phase& phase) {
  mpm::Scene scene;
  scene.labels.setConstant(rows, cols, first);
  scene.pixel_size = 0.5e-3;
  scene.phases = {std::nullopt, phase};
  scene.loading.stop_strain = 3e-4;
  scene.history_rows = 200;
  scene.threads = 1;
  return scene;
}

mpm::Scene concrete(int rows, int cols) {
  mpm::Scene scene = block(rows, cols, mpm::concrete_phases()[0]);
  scene.phases = {std::nullopt};
  for (const mpm::Phase& phase : mpm::concrete_phases()) scene.phases.emplace_back(phase);
  scene.labels.setConstant(second);
  const double pitch = 20;
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      const double shifted = col + static_cast<int>(row / pitch) % 2 * pitch / 2;
      const double radius =
          std::hypot(std::fmod(row, pitch) - pitch / 2, std::fmod(shifted, pitch) - pitch / 2);
      if (radius < 8.2) scene.labels(row, col) = radius < 7 ? first : third;
    }
  }
  return scene;
}

mpm::Scene unbreakable(mpm::Scene scene) {
  for (auto& phase : scene.phases)
    if (phase) phase->tensile_scale = phase->cohesion = mpm::Phase::unbreakable;
  return scene;
}

mpm::Scene scaled(mpm::Scene scene, double s, double r) {
  for (auto& phase : scene.phases) {
    if (!phase) continue;
    for (double* stress : {&phase->young, &phase->tensile_scale, &phase->cohesion}) *stress *= s;
    phase->density *= r;
  }
  scene.loading.velocity *= std::sqrt(s / r);
  return scene;
}

mpm::Scene checkerboard(const mpm::Phase& one, const mpm::Phase& other) {
  mpm::Scene scene = block(16, 16, one);
  scene.phases.emplace_back(other);
  for (int row = 0; row < 16; ++row)
    for (int col = row % 2; col < 16; col += 2) scene.labels(row, col) = second;
  return scene;
}

void load_slowly(mpm::Scene& scene, double strain, double transits) {
  double slowest = mpm::Phase::unbreakable;
  for (const auto& phase : scene.phases)
    if (phase) slowest = std::min(slowest, std::sqrt(phase->young / phase->density));
  scene.loading.stop_strain = strain;
  scene.loading.velocity = strain * slowest / transits;
  scene.local_damping = 0.5;
}

double end_modulus(const mpm::Result& result) {
  return result.history.back().stress / result.history.back().strain;
}

double plane_modulus(const mpm::Phase& phase) { return phase.young / (1 - phase.poisson * phase.poisson); }

double curve_difference(const mpm::Result& a, const mpm::Result& b, double scale) {
  if (a.history.size() != b.history.size() || !(a.peak_stress > 0)) return mpm::Phase::unbreakable;
  double largest = 0;
  for (std::size_t i = 0; i < a.history.size(); ++i) {
    const double difference = std::abs(a.history[i].stress - scale * b.history[i].stress);
    if (std::isnan(difference)) return difference;
    largest = std::max(largest, difference);
  }
  return largest / a.peak_stress;
}

bool is_finite(const mpm::Result& result) {
  return std::all_of(result.history.begin(), result.history.end(), [](const mpm::HistoryRow& row) {
    return std::isfinite(row.stress) && std::isfinite(row.strain) && std::isfinite(row.kinetic) &&
           std::isfinite(row.elastic) && std::isfinite(row.released) && std::isfinite(row.platen_work);
  });
}

Attempt attempt(const mpm::Scene& scene, const mpm::Plan& plan) {
  try {
    return {mpm::simulate(scene, plan), std::nullopt};
  } catch (const mpm::Diverged& diverged) {
    return {diverged.result, diverged.what()};
  }
}

Attempt attempt(const mpm::Scene& scene) { return attempt(scene, mpm::plan(scene)); }

mpm::Scene sky(int rows, int cols) {
  mpm::Scene scene = block(rows, cols, elastic(1e7, 0, 1000));
  scene.labels.setConstant(0);
  scene.pixel_size = 0.05;
  scene.kinematics = mpm::Kinematics::moving;
  scene.loading = {};
  scene.loading.direction = mpm::Direction::none;
  scene.loading.duration = 1e6;
  return scene;
}

void add_disc(mpm::Scene& scene, double x, double y, double radius) {
  for (int row = 0; row < scene.labels.rows(); ++row)
    for (int col = 0; col < scene.labels.cols(); ++col)
      if (std::hypot(col + 0.5 - x, static_cast<double>(scene.labels.rows()) - row - 0.5 - y) <= radius)
        scene.labels(row, col) = first;
}

Sums sums_of(const std::vector<mpm::PointView>& points) {
  Sums sums;
  for (const mpm::PointView& p : points) {
    sums.mass += p.mass;
    sums.px += p.mass * p.vx;
    sums.py += p.mass * p.vy;
    sums.x += p.mass * p.x;
    sums.y += p.mass * p.y;
    sums.kinetic += 0.5 * p.mass * (p.vx * p.vx + p.vy * p.vy);
  }
  sums.x /= sums.mass;
  sums.y /= sums.mass;
  for (const mpm::PointView& p : points)
    sums.spin += p.mass * ((p.x - sums.x) * p.vy - (p.y - sums.y) * p.vx);
  return sums;
}

}  // namespace app::bench
