#include "tests/apps/fake_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace {

constexpr double side = 0.150;  // [m]
constexpr float intact = std::numeric_limits<float>::quiet_NaN();

/// In [0, 1), the same on every machine.
double draw(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

std::vector<specimen::Ellipse> discs(std::mt19937_64& random) {
  std::vector<specimen::Ellipse> placed;
  for (int i = 0; i < 4000; ++i) {
    const double radius = 0.0025 + 0.0075 * std::max(0.0, 1 - i / 2000.0) * draw(random);
    const specimen::Ellipse disc{radius + (side - 2 * radius) * draw(random),
                                 radius + (side - 2 * radius) * draw(random), radius, radius, 0};
    const bool is_free = std::none_of(placed.begin(), placed.end(), [&](const specimen::Ellipse& other) {
      return std::hypot(other.x - disc.x, other.y - disc.y) < other.a + disc.a + 0.0012;
    });
    if (is_free) placed.push_back(disc);
  }
  return placed;
}

std::uint8_t phase_at(const std::vector<specimen::Ellipse>& aggregates, specimen::Point p, double itz) {
  double distance = side;
  for (const specimen::Ellipse& disc : aggregates)
    distance = std::min(distance, std::hypot(disc.x - p.x, disc.y - p.y) - disc.a);
  return distance <= 0     ? specimen::phase::aggregate
         : distance <= itz ? specimen::phase::itz
                           : specimen::phase::mortar;
}

specimen::Specimen draw_specimen(int pixels) {
  std::mt19937_64 random(7);
  const std::vector<specimen::Ellipse> aggregates = discs(random);
  specimen::Specimen specimen;
  specimen.mask.pixel_size = side / pixels;
  specimen.mask.labels = specimen::Raster<std::uint8_t>(pixels, pixels);
  for (int row = 0; row < pixels; ++row)
    for (int col = 0; col < pixels; ++col)
      specimen.mask.labels(row, col) =
          phase_at(aggregates, specimen.mask.centre(row, col), specimen.mask.pixel_size);
  for (const specimen::Ellipse& disc : aggregates)
    specimen.inclusions.push_back(
        specimen::make_inclusion(static_cast<int>(specimen.inclusions.size()) + 1, disc));
  specimen.provenance = {"generated", "", "[generate]\nfraction = 0.45\nseed = 7\n", 7, "0.1.0"};
  return specimen;
}

/// Height of the crack [m].
double crack_height(double x) { return side * (0.55 + 0.06 * std::sin(40 * x) + 0.025 * std::sin(170 * x)); }

struct Event {
  float strain = intact;
  mpm::FailureMode mode = mpm::FailureMode::none;
};

/// Scattered failures that begin in the ITZ, and a crack that runs from left to right behind the peak.
Event fail(std::mt19937_64& random, std::uint8_t label, specimen::Point p, double peak_strain,
           double shear_share) {
  const double chance = draw(random), when = draw(random), how = draw(random);
  if (label == specimen::phase::aggregate) return {};
  const bool in_crack = std::abs(p.y - crack_height(p.x)) < 0.0016;
  const double scatter = label == specimen::phase::itz ? 0.25 : 0.03;
  if (!in_crack && chance > scatter) return {};
  const double relative = in_crack ? 0.9 + 1.2 * p.x / side * when : 0.3 + 0.9 * std::sqrt(when);
  return {static_cast<float>(relative * peak_strain),
          how < shear_share ? mpm::FailureMode::shear : mpm::FailureMode::tension};
}

/// Stress over its peak at a strain over its peak. Source: GB 50010, Annex C.
double curve(double x) {
  if (x <= 1) return 1.2 * x - 0.2 * std::pow(x, 6);
  return x / (3.8 * std::pow(x - 1, 1.7) + x);
}

std::int64_t failed_by(const mpm::Result& result, double strain, mpm::FailureMode mode) {
  std::int64_t count = 0;
  for (Eigen::Index i = 0; i < result.failure_strain.size(); ++i)
    count += result.failure_mode.data()[i] == static_cast<std::uint8_t>(mode) &&
             result.failure_strain.data()[i] <= static_cast<float>(strain);
  return count;
}

void fill_history(mpm::Result& result, double end_strain, double velocity) {
  constexpr int rows = 400;
  double work = 0;
  for (int i = 0; i <= rows; ++i) {
    mpm::HistoryRow row;
    row.strain = end_strain * i / rows;
    row.time = row.strain * side / velocity;
    const double x = row.strain / result.peak_strain;
    row.stress = result.peak_stress * curve(x) * (1 + (x > 1.02 ? 0.02 * std::sin(60 * x) : 0));
    row.stress_top = 1.01 * row.stress;
    row.stress_bottom = 0.99 * row.stress;
    if (i > 0) work += 0.5 * (row.stress + result.history.back().stress) * end_strain / rows * side * side;
    row.platen_work = work;
    row.elastic = std::min(work, 0.5 * row.stress * row.strain * side * side);
    row.kinetic = std::min(work - row.elastic, 0.02 * work);
    row.released = work - row.elastic - row.kinetic;
    row.tension_failures = failed_by(result, row.strain, mpm::FailureMode::tension);
    row.shear_failures = failed_by(result, row.strain, mpm::FailureMode::shear);
    result.history.push_back(row);
  }
}

FakeRun run_of(int pixels, double peak_stress, double peak_strain, double end_strain, double shear_share) {
  FakeRun run{draw_specimen(pixels), {}, {}, {}};
  const specimen::LabelledMask& mask = run.specimen.mask;
  run.scene.labels = Eigen::Map<const mpm::PixelField<std::uint8_t>>(mask.labels.data.data(), pixels, pixels);
  run.scene.phases = {std::nullopt};  // voids
  for (const mpm::Phase& phase : mpm::concrete_phases()) run.scene.phases.emplace_back(phase);
  run.scene.pixel_size = mask.pixel_size;
  run.scene.loading.stop_strain = end_strain;
  run.scene_toml =
      "title = \"Tension, Table 1\"\n\n[loading]\ndirection = \"tension\"\nvelocity = \"0.05 m/s\"\n";

  mpm::Result& result = run.result;
  result.peak_stress = peak_stress;
  result.peak_strain = peak_strain;
  result.failure_strain.setConstant(pixels, pixels, intact);
  result.failure_mode.setZero(pixels, pixels);
  std::mt19937_64 random(11);
  for (int row = 0; row < pixels; ++row)
    for (int col = 0; col < pixels; ++col) {
      const Event event =
          fail(random, mask.labels(row, col), mask.centre(row, col), peak_strain, shear_share);
      if (std::isnan(event.strain) || event.strain > static_cast<float>(end_strain)) continue;
      result.failure_strain(row, col) = event.strain;
      result.failure_mode(row, col) = static_cast<std::uint8_t>(event.mode);
    }
  fill_history(result, end_strain, run.scene.loading.velocity);
  result.tension_failures = result.history.back().tension_failures;
  result.shear_failures = result.history.back().shear_failures;
  result.points = static_cast<std::int64_t>(pixels) * pixels;
  result.steps = 10327;
  result.dt = 4.2e-8;
  result.wall_time = 8.4;
  result.energy_error = 2.3e-4;
  result.instruction_set = "avx512";
  result.threads = 2;
  return run;
}

}  // namespace

RunRecord FakeRun::record() const {
  return {{specimen,
           scene,
           scene_toml,
           "3f2a9c5e7d1b8046a2c4e6f8091b3d5f7a9c1e3f5b7d9f1a3c5e7092b4d6f801",
           "Tension of the reference specimen",
           {}},
          result};
}

FakeRun tension_run(int pixels, int end_percent) {
  return run_of(pixels, 3.43e6, 144e-6, 144e-6 * end_percent / 100.0, 0.01);
}

FakeRun compression_run(int pixels) {
  FakeRun run = run_of(pixels, 75.2e6, 2210e-6, 2210e-6 * 1.23, 0.4);
  run.scene.loading.direction = mpm::Direction::compression;
  run.scene.loading.platen = mpm::Platen::rough;
  run.scene.damage.crack_closure = mpm::CrackClosure::unilateral;
  run.scene.local_damping = 0.1;
  mpm::Result& result = run.result;
  result.stop = mpm::StopReason::drop;
  result.crush_strain.setConstant(pixels, pixels, intact);
  for (Eigen::Index i = 0; i < result.crush_strain.size(); i += 5)
    if (result.failure_mode.data()[i] == 1) {
      result.crush_strain.data()[i] = std::min(1.1F * result.failure_strain.data()[i], 2700e-6F);
      ++result.shear_failures;
    }
  run.scene.extra_points.resize(2628);
  result.points += 2628;
  result.tension_failures += 700;
  result.shear_failures += 60;
  return run;
}

FakeRun impact_run(int pixels) {
  FakeRun run = run_of(pixels, 12.5e6, 0.02, 0.04, 0.1);
  run.scene.kinematics = mpm::Kinematics::moving;
  run.scene.loading.direction = mpm::Direction::none;
  run.scene.loading.initial_velocity_x = 9;
  run.scene.loading.initial_velocity_y = -12;
  run.scene.loading.duration = 4e-4;
  run.scene.motion.bottom = mpm::Edge::rough_wall;
  mpm::Result& result = run.result;
  result.stop = mpm::StopReason::time;
  const double energy = result.history.back().platen_work;
  for (mpm::HistoryRow& row : result.history) {
    row.time = row.strain * side / 15;
    row.kinetic = energy - row.elastic - row.released;
    row.platen_work = 0;
    row.moving_points = result.points - pixels;
    row.left_points = pixels;
    row.left = 0.01 * energy;
  }
  result.end_x.setConstant(pixels, pixels, intact);
  result.end_y = result.end_x;
  for (int row = 0; row < pixels; ++row)
    for (int col = 1; col < pixels; ++col) {
      const specimen::Point p = run.specimen.mask.centre(row, col);
      result.end_x(row, col) = static_cast<float>(p.x);
      result.end_y(row, col) = static_cast<float>(p.y + (p.y > crack_height(p.x) ? 0.030 : 0.020));
    }
  return run;
}

FakeRun still_run(const std::vector<std::string>& rows) {
  FakeRun run;
  const auto n_rows = static_cast<int>(rows.size());
  const auto n_cols = static_cast<int>(rows.front().size());
  run.specimen.mask.pixel_size = 1e-3;
  run.specimen.mask.labels = specimen::Raster<std::uint8_t>(n_rows, n_cols);
  for (int row = 0; row < n_rows; ++row)
    for (int col = 0; col < n_cols; ++col)
      run.specimen.mask.labels(row, col) =
          static_cast<std::uint8_t>(rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(col)] - '0');
  run.scene.pixel_size = 1e-3;
  run.scene.labels =
      Eigen::Map<const mpm::PixelField<std::uint8_t>>(run.specimen.mask.labels.data.data(), n_rows, n_cols);
  run.result.failure_strain.setConstant(n_rows, n_cols, intact);
  run.result.failure_mode.setZero(n_rows, n_cols);
  return run;
}
