#include "apps/calibrate/parameter_spread.hpp"

#include <cmath>

#include "apps/calibrate/pseudo_inverse.hpp"
#include "apps/calibrate/trend.hpp"

namespace app {
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
