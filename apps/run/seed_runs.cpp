#include "apps/run/seed_runs.hpp"

#include <algorithm>
#include <cmath>

#include "apps/system/job_pool.hpp"
#include "libmpm/run/simulate.hpp"

namespace app {
namespace {

constexpr double dropped = 0.6;      ///< share of the peak stress below which a peak is behind
constexpr double well_past = 1.25;   ///< strain over peak strain from which on it is behind at the latest
constexpr double farthest = 32;      ///< times loading.stop_strain, for a peak beyond it
constexpr double no_strain = 0.999;  ///< strains of 1 and more are none

/// The same scene with room for a peak beyond its end; rows of the history lie as close as before.
mpm::Scene with_room(mpm::Scene scene) {
  const double factor = std::clamp(no_strain / scene.loading.stop_strain, 1.0, farthest);
  scene.loading.stop_strain *= factor;
  scene.history_rows = static_cast<int>(std::ceil(scene.history_rows * factor));
  scene.loading.stop_drop = std::max(dropped, scene.loading.stop_drop.value_or(0));
  return scene;
}

bool is_past_peak(const mpm::HistoryRow& row, double peak_strain, double stop_strain) {
  return row.strain >= stop_strain && row.strain >= well_past * peak_strain;
}

SeedRun run_seed(const mpm::Scene& wanted, std::uint64_t seed, RunEnd end,
                 const std::function<bool()>& stopped) {
  mpm::Scene scene = end == RunEnd::past_peak ? with_room(wanted) : wanted;
  scene.damage.seed = seed;
  scene.threads = 1;
  double peak_stress = 0;
  double peak_strain = 0;
  const auto goes_on = [&](const mpm::Progress& progress) {
    const mpm::HistoryRow& row = progress.row;
    if (row.stress > peak_stress) {
      peak_stress = row.stress;
      peak_strain = row.strain;
    }
    if (stopped()) return false;
    return end == RunEnd::of_scene || !is_past_peak(row, peak_strain, wanted.loading.stop_strain);
  };
  const mpm::Result result = mpm::simulate(scene, {.observer = goes_on});
  const bool ended_past_peak =
      end == RunEnd::past_peak &&
      is_past_peak(result.history.back(), result.peak_strain, wanted.loading.stop_strain);
  return {seed, result.peak_stress, result.peak_strain, stress_curve(result),
          ended_past_peak || mpm::peak_reached(result)};
}

}  // namespace

std::vector<std::uint64_t> seeds_from(std::uint64_t first, int count) {
  std::vector<std::uint64_t> seeds;
  for (int i = 0; i < count; ++i) seeds.push_back(first + static_cast<std::uint64_t>(i));
  return seeds;
}

int workers_of(const mpm::Scene& scene) {
  return scene.threads > 0 ? std::min(scene.threads, core_count()) : core_count();
}

std::optional<std::vector<SeedRun>> run_seeds(const mpm::Scene& scene,
                                              const std::vector<std::uint64_t>& seeds, RunEnd end,
                                              const std::function<bool()>& stopped) {
  std::vector<SeedRun> runs(seeds.size());
  std::vector<std::function<void()>> jobs;
  for (std::size_t i = 0; i < seeds.size(); ++i)
    jobs.emplace_back([&, i] { runs[i] = run_seed(scene, seeds[i], end, stopped); });
  run_jobs(jobs, workers_of(scene), {{}, [&] { return !stopped(); }});
  if (stopped()) return std::nullopt;
  return runs;
}

double stress_at(const Curve& curve, double strain) {
  const auto above = std::upper_bound(curve.strain.begin(), curve.strain.end(), strain);
  if (above == curve.strain.end()) return curve.stress.back();
  const auto i = static_cast<std::size_t>(above - curve.strain.begin());
  if (i == 0) return curve.stress.front();
  const double share = (strain - curve.strain[i - 1]) / (curve.strain[i] - curve.strain[i - 1]);
  return curve.stress[i - 1] + share * (curve.stress[i] - curve.stress[i - 1]);
}

Spread spread_of(const std::vector<SeedRun>& runs, double SeedRun::*figure) {
  std::vector<double> values;
  for (const SeedRun& run : runs) values.push_back(run.*figure);
  return spread_of(values);
}

Spread spread_of_peaks(const std::vector<SeedRun>& runs, double SeedRun::*figure) {
  std::vector<double> values;
  for (const SeedRun& run : runs)
    if (run.peak_reached) values.push_back(run.*figure);
  return spread_of(values);
}

std::size_t count_without_peak(const std::vector<SeedRun>& runs) {
  return static_cast<std::size_t>(
      std::count_if(runs.begin(), runs.end(), [](const SeedRun& run) { return !run.peak_reached; }));
}

}  // namespace app
