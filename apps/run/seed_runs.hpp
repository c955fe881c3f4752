/// Runs of one scene with several random strength fields, side by side.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "apps/statistics/curve.hpp"
#include "apps/statistics/statistics.hpp"
#include "libmpm/scene/scene.hpp"

namespace app {

/// What came out with one seed.
struct SeedRun {
  std::uint64_t seed = 0;
  double peak_stress = 0;  ///< [Pa]
  double peak_strain = 0;  ///< [-]
  Curve curve;
  bool peak_reached = true;  ///< the largest stress is a peak
};

/// When a run ends.
enum class RunEnd {
  of_scene,   ///< as the scene says
  past_peak,  ///< once the stress has dropped to 60 % of its peak, wherever the peak lies; or at
              ///< loading.stop_strain, if the peak is well before it
};

/// `count` seeds from `first` on.
[[nodiscard]] std::vector<std::uint64_t> seeds_from(std::uint64_t first, int count);

/// Runs at a time of run_seeds().
[[nodiscard]] int workers_of(const mpm::Scene& scene);

/// Run the scene once for each seed, each on one thread, as many at a time as there are cores, or
/// Scene::threads says.
/// @param stopped  asked at each row of the history, by every thread; true = end all runs.
/// @return the runs in the order of their seeds; nullopt when they were stopped.
/// @throws mpm::Error, mpm::Diverged.
[[nodiscard]] std::optional<std::vector<SeedRun>> run_seeds(const mpm::Scene& scene,
                                                            const std::vector<std::uint64_t>& seeds,
                                                            RunEnd end, const std::function<bool()>& stopped);

/// Stress of a curve at a strain, between its points by a straight line, beyond its ends as there [Pa].
/// @pre the curve is not empty.
[[nodiscard]] double stress_at(const Curve& curve, double strain);

/// Of a figure from one run to another.
[[nodiscard]] Spread spread_of(const std::vector<SeedRun>& runs, double SeedRun::*figure);

/// The same, of the runs that have a peak.
[[nodiscard]] Spread spread_of_peaks(const std::vector<SeedRun>& runs, double SeedRun::*figure);

[[nodiscard]] std::size_t count_without_peak(const std::vector<SeedRun>& runs);

}  // namespace app
