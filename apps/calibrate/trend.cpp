#include "apps/calibrate/trend.hpp"

#include <cmath>

#include "apps/calibrate/pseudo_inverse.hpp"

namespace app {
namespace {

constexpr double core = 0.1;  ///< evaluations closer than this weigh alike

std::vector<const Evaluation*> with_figures(const std::vector<Evaluation>& history) {
  std::vector<const Evaluation*> known;
  for (const Evaluation& evaluation : history)
    if (evaluation.figures.size() > 0) known.push_back(&evaluation);
  return known;
}

}  // namespace

Eigen::VectorXd logarithms_of(const std::vector<double>& factors) {
  return Eigen::Map<const Eigen::ArrayXd>(factors.data(), static_cast<Eigen::Index>(factors.size())).log();
}

Trend fit_trend(const std::vector<Evaluation>& history, const Eigen::VectorXd& centre) {
  const std::vector<const Evaluation*> known = with_figures(history);
  Eigen::MatrixXd x(static_cast<Eigen::Index>(known.size()), centre.size() + 1);
  Eigen::MatrixXd y(x.rows(), known.front()->figures.size());
  for (Eigen::Index row = 0; row < x.rows(); ++row) {
    const Evaluation& evaluation = *known[static_cast<std::size_t>(row)];
    const Eigen::VectorXd change = logarithms_of(evaluation.factors) - centre;
    const double weight = 1 / std::hypot(core, change.norm());
    x.row(row) << weight, weight * change.transpose();
    y.row(row) = weight * evaluation.figures.transpose();
  }
  const Eigen::MatrixXd solution = pseudo_inverse(x) * y;
  return {centre, solution.row(0).transpose(), solution.bottomRows(centre.size()).transpose()};
}

}  // namespace app
