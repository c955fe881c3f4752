#include "apps/calibrate/calibration.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "apps/calibrate/trend_search.hpp"
#include "apps/job/job.hpp"
#include "apps/run/run_length.hpp"
#include "apps/text/complaint.hpp"
#include "apps/text/words.hpp"
#include "libmpm/run/simulate.hpp"
#include "libmpm/scene/error.hpp"

namespace app {
namespace {

constexpr double hopeless = 1000;  ///< misfit where a run was of no use
constexpr double peak_step = 0.25;
constexpr double curve_step = 0.08;
constexpr double coarse_tolerance = 0.03;
constexpr int coarse_evaluations = 25;
constexpr int usual_evaluations = 10;  ///< of a fit to a peak, to tell whether a search is long

std::vector<double> exponentials(const std::vector<double>& logarithms) {
  std::vector<double> values(logarithms.size());
  std::transform(logarithms.begin(), logarithms.end(), values.begin(),
                 [](double logarithm) { return std::exp(logarithm); });
  return values;
}

/// The number with two digits that is not below a value.
double rounded_up(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::strtod(fmt::format("{:.1e}", std::ceil(value / unit - 1e-9) * unit).c_str(), nullptr);
}

class Calibrator {
 public:
  Calibrator(const CalibrationTask& task, const std::function<bool()>& stopped,
             const CalibrationObserver& observer)
      : task_(task),
        stopped_(stopped),
        observer_(observer),
        seeds_(seeds_from(task.settings.scene.damage.seed, task.seeds)) {}

  Calibration run() {
    const std::vector<double> as_it_is(task_.parameters.size(), 1.0);
    if (task_.target.curve.empty()) {
      search(task_.target, as_it_is, {peak_step, task_.tolerance, task_.evaluations}, false);
    } else {
      search(task_.target.peak_of_curve(), as_it_is, {peak_step, coarse_tolerance, coarse_evaluations}, true);
      if (result_.end != SearchEnd::stopped)
        search(task_.target, std::vector(result_.best_evaluation().factors),
               {curve_step, task_.tolerance, task_.evaluations}, false);
    }
    if (!result_.history.empty()) finish();
    result_.wall_time = seconds();
    return std::move(result_);
  }

 private:
  struct Limits {
    double step = 0;  ///< of the logarithm of a factor
    double tolerance = 0;
    int evaluations = 0;
  };

  void search(const Target& target, const std::vector<double>& factors, const Limits& limits, bool coarse) {
    TrendPlan plan{{}, {}, {}, limits.step, limits.tolerance, limits.evaluations};
    for (std::size_t i = 0; i < task_.parameters.size(); ++i) {
      plan.low.push_back(std::log(task_.parameters[i].low));
      plan.high.push_back(std::log(task_.parameters[i].high));
      plan.start.push_back(std::clamp(std::log(factors[i]), plan.low.back(), plan.high.back()));
    }
    has_best_ = false;
    result_.end = search_along_trend(plan, figures_of(target), [&](const std::vector<double>& logarithms) {
      return evaluate(target, exponentials(logarithms), coarse);
    });
  }

  /// @return nullopt when stopped.
  std::optional<Evaluation> evaluate(const Target& target, std::vector<double> factors, bool coarse) {
    Evaluation evaluation{std::move(factors), hopeless, {}, {}, coarse};
    std::vector<SeedRun> runs;
    try {
      auto finished = run_with(target, scaled(evaluation.factors), seeds_,
                               target.curve.empty() ? RunEnd::past_peak : RunEnd::of_scene);
      if (!finished) return std::nullopt;
      runs = std::move(*finished);
      judge(target, runs, evaluation);
    } catch (const mpm::Diverged& diverged) {
      trouble_ = diverged.what();
    } catch (const mpm::Error& error) {  // the scene as it is may be valid, and this one not
      trouble_ = error.what();
    }
    keep(std::move(evaluation), std::move(runs));
    return result_.history.back();
  }

  void judge(const Target& target, const std::vector<SeedRun>& runs, Evaluation& evaluation) {
    const Figures figures = figures_of(target, runs);
    if (!figures.allFinite()) {
      trouble_ = "the stress never rose above 0";
      return;
    }
    if (target.curve.empty() && count_without_peak(runs) > 0) {
      trouble_ = "no peak was reached: the stress was still rising far beyond loading.stop_strain";
      return;
    }
    evaluation.peak = {spread_of_peaks(runs, &SeedRun::peak_stress).mean,
                       spread_of_peaks(runs, &SeedRun::peak_strain).mean};
    evaluation.figures = figures;
    evaluation.misfit = std::sqrt(mean_square(figures, figures_of(target)));
  }

  void keep(Evaluation evaluation, std::vector<SeedRun> runs) {
    result_.history.push_back(std::move(evaluation));
    if (!has_best_ || result_.history.back().misfit < result_.best_evaluation().misfit) {
      has_best_ = true;
      result_.best = result_.history.size() - 1;
      result_.runs = std::move(runs);
    }
    result_.wall_time = seconds();
    if (observer_) observer_(result_);
  }

  [[nodiscard]] Settings scaled(const std::vector<double>& factors) const {
    Settings settings = task_.settings;
    scale(settings, task_.parameters, factors);
    return settings;
  }

  std::optional<std::vector<SeedRun>> run_with(const Target& target, const Settings& settings,
                                               const std::vector<std::uint64_t>& seeds, RunEnd end) {
    const mpm::Scene scene = scene_for(target, build_scene(task_.specimen, settings));
    result_.run_count += static_cast<int>(seeds.size());
    return run_seeds(scene, seeds, end, stopped_);
  }

  /// Run the scene as it will be written, with the seeds of the search and with others.
  void finish() {
    if (result_.best_evaluation().figures.size() == 0)
      throw Rejected(Exit::data, "calibrate", "no run can be used", trouble_);
    result_.settings = scaled(result_.best_evaluation().factors);
    result_.misfit = result_.best_evaluation().misfit;
    make_room(result_.settings.scene.loading);
    const auto seeds = seeds_from(seeds_.front(), task_.seeds + task_.further_seeds);
    auto runs = run_with({}, result_.settings, seeds, RunEnd::of_scene);
    if (!runs) {
      result_.end = SearchEnd::stopped;
      return;
    }
    const auto first_further = runs->begin() + task_.seeds;
    result_.further_runs.assign(first_further, runs->end());
    result_.runs.assign(runs->begin(), first_further);
    result_.misfit = misfit(task_.target, result_.runs);
  }

  /// The run that was found must show what was fitted.
  void make_room(mpm::Loading& loading) const {
    if (!task_.target.curve.empty()) {
      loading.stop_strain = std::max(loading.stop_strain, task_.target.curve.last_strain());
      loading.stop_drop.reset();
      return;
    }
    double farthest = 0;
    for (const SeedRun& run : result_.runs) farthest = std::max(farthest, run.peak_strain);
    if (1.25 * farthest > loading.stop_strain) loading.stop_strain = rounded_up(1.5 * farthest);
  }

  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

  const CalibrationTask& task_;
  const std::function<bool()>& stopped_;
  const CalibrationObserver& observer_;
  std::vector<std::uint64_t> seeds_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  Calibration result_;
  bool has_best_ = false;  ///< for the target at hand
  std::string trouble_;    ///< of the last run that was of no use
};

}  // namespace

Calibration calibrate(const CalibrationTask& task, const std::function<bool()>& stopped,
                      const CalibrationObserver& observer) {
  return Calibrator(task, stopped, observer).run();
}

std::string announcement(const CalibrationTask& task) {
  const mpm::Scene scene = scene_for(task.target, build_scene(task.specimen, task.settings));
  const RunSize size = size_of(scene);
  const int workers = std::min(workers_of(scene), task.seeds);
  const std::vector<RunSize> runs(static_cast<std::size_t>(task.seeds), size);
  const double seconds = time_of_runs(
      runs, [&](std::size_t) { return scene; }, workers);
  if (!is_long(seconds * std::min(task.evaluations, usual_evaluations))) return {};
  return fmt::format("each set of parameters takes {} {} here: {} of {}, {} at a time; at most {} are tried",
                     precision_word({size}, false), duration_text(seconds), counted(task.seeds, "run"),
                     size_text({size}), workers, counted(task.evaluations, "set"));
}

namespace {

constexpr double least_slope = 0.05;  ///< of the peak against a parameter, both in logarithms

/// Figures of single runs, a column a run.
Eigen::MatrixXd figures_of_each(const Target& target, const std::vector<SeedRun>& runs) {
  Eigen::MatrixXd figures(figures_of(target).size(), static_cast<Eigen::Index>(runs.size()));
  for (std::size_t i = 0; i < runs.size(); ++i)
    figures.col(static_cast<Eigen::Index>(i)) = figures_of(target, {runs[i]});
  return figures;
}

/// From one column to another.
Eigen::MatrixXd covariance(const Eigen::MatrixXd& columns) {
  const Eigen::MatrixXd apart = columns.colwise() - columns.rowwise().mean();
  return apart * apart.transpose() / static_cast<double>(columns.cols() - 1);
}

}  // namespace

std::optional<std::vector<double>> parameter_spread(const CalibrationTask& task,
                                                    const Calibration& calibration) {
  const Target& target = task.target;
  std::vector<SeedRun> runs = calibration.runs;
  runs.insert(runs.end(), calibration.further_runs.begin(), calibration.further_runs.end());
  std::erase_if(runs, [](const SeedRun& run) { return !run.peak_reached; });
  const auto figures = static_cast<std::size_t>(figures_of(target).size());
  if (!target.curve.empty() || task.parameters.size() > figures || runs.size() < 3) return std::nullopt;
  const Eigen::VectorXd best = logarithms_of(calibration.best_evaluation().factors);
  const Eigen::MatrixXd slope = fit_trend(calibration.history, best).slope;
  const Eigen::MatrixXd inverse = pseudo_inverse(slope);
  if (!(inverse * slope).isIdentity(1e-6)) return std::nullopt;  // some parameter changes nothing of its own
  // The norm is no less than the inverse of the smallest singular value.
  if (!(1 / inverse.norm() > least_slope)) return std::nullopt;
  const Eigen::MatrixXd spread = inverse * covariance(figures_of_each(target, runs)) * inverse.transpose() /
                                 static_cast<double>(task.seeds);
  std::vector<double> deviations;
  for (Eigen::Index i = 0; i < spread.rows(); ++i) deviations.push_back(std::sqrt(spread(i, i)));
  return deviations;
}

}  // namespace app
