#include "apps/run/error_estimation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "apps/text/figures.hpp"
#include "libmpm/scene/error.hpp"
#include "libmpm/solver/plan.hpp"
#include "specimen/convert/resample.hpp"

namespace app {
namespace {

using output::ErrorEstimate;
using output::ErrorSource;

constexpr double margin = 1.25;    ///< for an order that is not quite the first
constexpr double past_peak = 1.3;  ///< times the strain at the peak: where a second run may end

/// Ends once the peak is passed for certain.
mpm::Scene up_to_the_peak(mpm::Scene scene, double peak_strain) {
  scene.loading.stop_strain = std::min(scene.loading.stop_strain, past_peak * peak_strain);
  return scene;
}

double change(double value, double other) { return value == 0 ? 0 : std::abs(other / value - 1); }

/// @param share  of the change that is the error of `base`, before the margin.
ErrorSource source_of(const std::string& name, const std::string& compared, double share,
                      const mpm::Result& base, const mpm::Result& other) {
  return {name,
          compared,
          other.peak_stress,
          other.peak_strain,
          margin * share * change(base.peak_stress, other.peak_stress),
          margin * share * change(base.peak_strain, other.peak_strain),
          other.wall_time,
          other.history.empty() || mpm::peak_reached(other)};
}

mpm::Scene slower(mpm::Scene scene) {
  scene.loading.velocity *= 0.5;
  return scene;
}
mpm::Scene with_half_the_step(mpm::Scene scene) {
  scene.cfl *= 0.5;
  return scene;
}
mpm::Scene in_other_precision(mpm::Scene scene) {
  scene.precision =
      scene.precision == mpm::Precision::single ? mpm::Precision::double_ : mpm::Precision::single;
  return scene;
}

mpm::Scene with_pixel_cells(mpm::Scene scene) {
  scene.pixel_cells = true;
  scene.points_per_cell = 1;
  return scene;
}

std::string velocity_text(const mpm::Scene& scene) {
  return output::concise(scene.loading.velocity, 4) + " m/s";
}
std::string cfl_text(const mpm::Scene& scene) { return "CFL " + output::concise(scene.cfl, 4); }
/// Of first order: a quarter of the tolerance leaves a quarter of its error.
mpm::Scene with_fewer_failures_at_once(mpm::Scene scene) {
  scene.event_tolerance *= 0.25;
  return scene;
}
std::string tolerance_text(const mpm::Scene& scene) {
  return output::percent(scene.event_tolerance, 2) + " of strain";
}

std::string precision_text(const mpm::Scene& scene) {
  return scene.precision == mpm::Precision::single ? "single" : "double";
}
std::string pixel_text(const mpm::Scene& scene) { return output::concise(1e3 * scene.pixel_size, 4) + " mm"; }

/// Whether pixels twice as large leave cells to compute with.
bool can_coarsen(const mpm::Scene& scene) {
  const int least = 8 * scene.points_per_cell;
  return scene.labels.rows() >= least && scene.labels.cols() >= least;
}

/// A run on the way to a tolerance.
struct Candidate {
  mpm::Scene scene;
  mpm::Result result;
};

/// Runs that lead to a tolerance, and what they took.
class Search {
 public:
  Search(const mpm::Scene& scene, const Solve& solve) : scene_(scene), solve_(solve) {}

  Candidate take(const mpm::Scene& scene) {
    Candidate candidate{scene, solve_(peak_strain_ > 0 ? up_to_the_peak(scene, 1.2 * peak_strain_) : scene)};
    wall_time_ += candidate.result.wall_time;
    peak_strain_ = candidate.result.peak_strain;
    return candidate;
  }
  [[nodiscard]] double wall_time() const { return wall_time_; }

  /// Of the fastest wave, or where that cannot strain sideways, of one along a bar [s].
  static double transit(const mpm::Scene& scene) {
    const mpm::Plan plan = mpm::plan(scene);
    return std::max(scene.height() / plan.wave_speed, 0.5 * plan.transit_time);
  }

  /// Fast, but slow enough for eight transits of the wave.
  [[nodiscard]] mpm::Scene fastest() const {
    mpm::Scene scene = scene_;
    scene.loading.velocity = scene.loading.stop_strain * scene.height() / (8 * transit(scene));
    scene.cfl = 0.9;
    scene.precision = mpm::Precision::single;
    return scene;
  }

 private:
  const mpm::Scene& scene_;
  const Solve& solve_;
  double peak_strain_ = 0, wall_time_ = 0;
};

/// A choice that may be refined, and how its error follows from what that changes.
struct Refinement {
  std::string name;
  mpm::Scene (*refine)(mpm::Scene);
  std::string (*text)(const mpm::Scene&);
  double before, after;  ///< share of the change that is the error of the coarser run, and of the finer one
  int most;              ///< times
};

/// The better of two, and what is left of the error in it.
struct Settled {
  Candidate candidate;
  ErrorSource source;
};

/// Refines while that changes the peak by more than `limit`, but not once the changes do not fall any more:
/// then they are the scatter from the order of failures.
Settled settle(Search& search, Candidate coarse, const Refinement& by, double limit) {
  double last = 1;
  for (int times = 1;; ++times) {
    Candidate fine = search.take(by.refine(coarse.scene));
    const ErrorSource before = source_of(by.name, by.text(fine.scene), by.before, coarse.result, fine.result);
    if (before.stress_error <= limit) return {std::move(coarse), before};
    const ErrorSource after = source_of(by.name, by.text(coarse.scene), by.after, fine.result, coarse.result);
    if (times == by.most || after.stress_error <= limit || before.stress_error > 0.7 * last)
      return {std::move(fine), after};
    last = before.stress_error;
    coarse = std::move(fine);
  }
}

/// What a quantity of a test comes to at rest, and by how much that may be wrong: a straight line through
/// runs at rates of 4, 2 and 1, by least squares, and its standard error there. A run scatters about the
/// line, for its rate also changes the order in which points fail.
struct AtRest {
  double value, deviation;
};
AtRest at_rest(double fast, double middle, double slow) {
  const double slope = (5 * fast - middle - 4 * slow) / 14;  // per rate of 1
  const double value = (fast + middle + slow) / 3 - slope * 7 / 3;
  const double residuals =
      std::hypot(fast - value - 4 * slope, middle - value - 2 * slope, slow - value - slope);
  return {value, std::sqrt(1.5) * residuals};  // one degree of freedom is left
}

/// Error of one of three runs at rates of 4, 2 and 1.
/// @param compared  what another of them, `other`, did otherwise.
ErrorSource rate_source(const mpm::Result& of, const mpm::Result& fast, const mpm::Result& middle,
                        const mpm::Result& slow, const std::string& compared, const mpm::Result& other) {
  const auto error = [&](double mpm::Result::*quantity) {
    const AtRest rest = at_rest(fast.*quantity, middle.*quantity, slow.*quantity);
    const auto [least, most] = std::minmax({fast.*quantity, middle.*quantity, slow.*quantity});
    // Three rates may lie on a line by chance: never less than they differ.
    const double error = std::max(std::abs(of.*quantity - rest.value) + rest.deviation, most - least);
    return of.*quantity == 0 ? 0 : margin * error / of.*quantity;
  };
  return {"loading rate",
          compared,
          other.peak_stress,
          other.peak_strain,
          error(&mpm::Result::peak_stress),
          error(&mpm::Result::peak_strain),
          other.wall_time,
          other.history.empty() || mpm::peak_reached(other)};
}

/// Runs at rates that are halved from one to the next, of which the last three tell the error.
class RateLadder {
 public:
  void add(const Candidate& candidate) {
    rungs_.push_back({candidate.scene, candidate.result});
    rungs_.back().result.history.clear();
  }
  [[nodiscard]] std::size_t rungs() const { return rungs_.size(); }

  /// Of the slowest of at least two runs.
  [[nodiscard]] ErrorSource error() const {
    const Candidate& slowest = at(1);
    if (rungs() < 3)
      return source_of("loading rate", velocity_text(at(2).scene), 1, slowest.result, at(2).result);
    return rate_source(slowest.result, at(3).result, at(2).result, slowest.result, velocity_text(at(2).scene),
                       at(2).result);
  }

 private:
  [[nodiscard]] const Candidate& at(std::size_t back) const { return rungs_[rungs_.size() - back]; }

  std::vector<Candidate> rungs_;
};

constexpr std::size_t most_halvings = 7;  ///< of the loading rate

/// The same test without inertia, to well past its peak; nullopt where that cannot be done, is not
/// affordable, or shows nothing, for nothing fails.
std::optional<mpm::Scene> at_equilibrium(const mpm::Scene& scene, double peak_strain) {
  constexpr std::int64_t most_points = 2'000'000;
  const auto can_fail = [](const auto& phase) { return phase && phase->can_fail(); };
  if (std::none_of(scene.phases.begin(), scene.phases.end(), can_fail)) return std::nullopt;
  if (scene.damage.crack_closure != mpm::CrackClosure::off)
    return std::nullopt;  // takes longer than the rates
  mpm::Scene still = scene;
  still.method = mpm::SolverMethod::quasi_static;
  still.event_tolerance = 0.01;
  still.loading.path = mpm::LoadingPath::strain;
  still.loading.stop_drop = 0.8;
  still.loading.stop_strain = std::max(scene.loading.stop_strain, 3 * peak_strain);
  if (!mpm::faults(still).empty() || mpm::count_points(still) > most_points) return std::nullopt;
  return still;
}

ErrorSource rate_source(const mpm::Result& base, const mpm::Result& still) {
  return source_of("loading rate", "equilibrium", 1, base, still);
}

/// By what share explicit runs of points that break lie below equilibrium, however slowly they are loaded:
/// what a failure sets free overloads its neighbours as a wave. Measured on five strength fields of a mask: 8
/// % in tension, 41 % in compression, none in tension with a local damping of 0.2 or more.
double bias_of_waves(const mpm::Scene& scene) {
  const auto can_fail = [](const auto& phase) { return phase && phase->can_fail(); };
  if (std::none_of(scene.phases.begin(), scene.phases.end(), can_fail)) return 0;
  if (scene.loading.direction == mpm::Direction::compression) return 0.41;
  return scene.local_damping < 0.2 ? 0.08 : 0;
}

/// Where no run without inertia tells, rates that agree tell nothing of what all of them are off.
void add_bias(const mpm::Scene& scene, const mpm::Result& base, ErrorEstimate& estimate) {
  const double bias = bias_of_waves(scene);
  if (bias > 0)
    estimate.sources.push_back(
        {"waves of breaking points", "a known bias, as there is no run without inertia",
         base.peak_stress / (1 - bias), base.peak_strain / (1 - bias), bias, bias, 0, true});
}

/// Against equilibrium, or else from runs at half and at a quarter of the rate: what the rates tend to is not
/// equilibrium where points break at once.
ErrorSource rate_error(const mpm::Scene& scene, const mpm::Result& base, const Solve& solve) {
  if (const std::optional<mpm::Scene> still = at_equilibrium(scene, base.peak_strain))
    return rate_source(base, solve(*still));
  const mpm::Scene slow = slower(scene), slowest = slower(slow);
  const mpm::Result half = solve(slow), quarter = solve(slowest);
  ErrorSource source =
      rate_source(base, base, half, quarter,
                  output::concise(slow.loading.velocity, 4) + ", " + velocity_text(slowest), quarter);
  source.wall_time += half.wall_time;
  return source;
}

}  // namespace

output::ErrorEstimate estimate_error(const mpm::Scene& scene, const mpm::Result& base, const Solve& solve) {
  const mpm::Scene shorter = up_to_the_peak(scene, base.peak_strain);
  ErrorEstimate estimate;
  const auto add = [&](const std::string& name, const mpm::Scene& other, const std::string& compared,
                       double share) {
    estimate.sources.push_back(source_of(name, compared, share, base, solve(other)));
  };
  if (scene.method == mpm::SolverMethod::quasi_static) {
    const mpm::Scene finer = with_fewer_failures_at_once(shorter);
    if (scene.event_tolerance > 0) add("failures at once", finer, tolerance_text(finer), 4.0 / 3);
  } else {
    estimate.sources.push_back(rate_error(shorter, base, solve));
    if (!at_equilibrium(shorter, base.peak_strain)) add_bias(scene, base, estimate);
    const mpm::Scene short_steps = with_half_the_step(shorter);
    add("time step", short_steps, cfl_text(short_steps), 2);
    const mpm::Scene other = in_other_precision(shorter);
    add("precision", other, precision_text(other), 1);
  }
  if (const mpm::Scene pixels = with_pixel_cells(shorter); !scene.pixel_cells && mpm::faults(pixels).empty())
    add("cell", pixels, "pixel", 1);
  if (can_coarsen(scene)) {
    const mpm::Scene coarse = coarsened(shorter);
    add("pixel size", coarse, pixel_text(coarse), 1);
  }
  return estimate;
}

mpm::Scene coarsened(const mpm::Scene& scene) {
  mpm::Scene coarse = scene;
  const auto whole = [&](Eigen::Index pixels) {
    return pixels / (2 * scene.points_per_cell) * scene.points_per_cell;
  };
  coarse.pixel_size = 2 * scene.pixel_size;
  const Eigen::Index rows = whole(scene.labels.rows()), cols = whole(scene.labels.cols());
  // Extra points are counted from below: what is cut off is on top.
  const Eigen::Index cut = scene.labels.rows() - 2 * rows;
  specimen::Raster<specimen::Cell> cells(static_cast<int>(2 * rows), static_cast<int>(2 * cols));
  for (int row = 0; row < cells.rows; ++row)
    for (int col = 0; col < cells.cols; ++col) cells(row, col) = scene.labels(cut + row, col);
  const specimen::Raster<specimen::Cell> half =
      specimen::resampled(cells, {cells.rows, cells.cols, 1, static_cast<int>(rows), static_cast<int>(cols)});
  coarse.labels.resize(rows, cols);
  for (int row = 0; row < half.rows; ++row)
    for (int col = 0; col < half.cols; ++col)
      coarse.labels(row, col) = static_cast<std::uint8_t>(half(row, col));
  std::erase_if(coarse.extra_points, [&](const mpm::ExtraPoint& point) {
    return point.x >= coarse.width() || point.y >= coarse.height();
  });
  return coarse;
}

namespace {

/// Without inertia there is no rate, only failures that happen at once: fewer of them, until that changes the
/// peak by no more than the tolerance.
Tolerated within_at_rest(const mpm::Scene& scene, Candidate at_once, double tolerance, const Solve& solve) {
  Tolerated found;
  const auto take = [&](const Candidate& candidate, ErrorSource source) {
    found.scene = scene;
    found.scene.method = candidate.scene.method;
    found.scene.event_tolerance = candidate.scene.event_tolerance;
    found.met = source.stress_error <= tolerance;
    found.estimate.sources = {std::move(source)};
    return found.met;
  };
  constexpr int most = 3;
  for (int times = 0; times < most; ++times) {
    Candidate fewer{with_fewer_failures_at_once(at_once.scene), {}};
    fewer.result = solve(fewer.scene);
    found.wall_time += fewer.result.wall_time;
    const auto source = [&](double share, const Candidate& of, const Candidate& other) {
      return source_of("failures at once", tolerance_text(other.scene), share, of.result, other.result);
    };
    if (take(at_once, source(4.0 / 3, at_once, fewer)) || take(fewer, source(1.0 / 3, fewer, at_once))) break;
    at_once = std::move(fewer);
  }
  return found;
}

}  // namespace

Tolerated meet_tolerance(const mpm::Scene& scene, double tolerance, const Solve& solve) {
  Search search(scene, solve);
  Candidate candidate = search.take(search.fastest());
  RateLadder ladder;
  ladder.add(candidate);
  Tolerated found;
  const std::optional<mpm::Scene> rest = at_equilibrium(scene, candidate.result.peak_strain);
  const mpm::Result still = rest ? solve(*rest) : mpm::Result();
  double last = 0;
  bool moves = true;  // a slower run still differs from the one before
  do {
    last = candidate.result.peak_stress;
    candidate = search.take(slower(candidate.scene));
    ladder.add(candidate);
    found.estimate.sources = {rest ? rate_source(candidate.result, still) : ladder.error()};
    if (!rest) add_bias(scene, candidate.result, found.estimate);
    moves = !rest || ladder.rungs() < 4 ||
            change(candidate.result.peak_stress, last) > 0.1 * found.estimate.stress_error();
  } while ((!rest && ladder.rungs() < 3) ||
           (moves && (rest || bias_of_waves(scene) < tolerance) &&
            found.estimate.stress_error() > 0.5 * tolerance && ladder.rungs() <= most_halvings));
  const auto refine = [&](const Refinement& by) {
    Settled settled = settle(search, std::move(candidate), by, 0.25 * tolerance);
    candidate = std::move(settled.candidate);
    found.estimate.sources.push_back(settled.source);
  };
  refine({"time step", with_half_the_step, cfl_text, 2, 1, 3});
  refine({"precision", in_other_precision, precision_text, 1, 0, 1});
  found.met = found.estimate.stress_error() <= tolerance;
  found.scene = scene;
  found.scene.loading.velocity = candidate.scene.loading.velocity;
  found.scene.cfl = candidate.scene.cfl;
  found.scene.precision = candidate.scene.precision;
  if (!found.met && rest) found = within_at_rest(scene, {*rest, still}, tolerance, solve);
  found.wall_time += search.wall_time() + still.wall_time;
  return found;
}

}  // namespace app
