#include "apps/calibrate/trend_search.hpp"

#include <fmt/format.h>
#include <nlopt.h>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <stdexcept>
#include <type_traits>

namespace app {
namespace {

constexpr double resolution = 1e-7;
constexpr int most_evaluations = 5000;

struct Destroy {
  void operator()(nlopt_opt optimizer) const { nlopt_destroy(optimizer); }
};
using Optimizer = std::unique_ptr<std::remove_pointer_t<nlopt_opt>, Destroy>;

/// What the C library is handed: it must see no exception.
struct Call {
  const std::function<double(const std::vector<double>&)>& function;
  nlopt_opt optimizer;
  std::exception_ptr thrown;
};

extern "C" double mesopix_evaluate(unsigned count, const double* x, double* /*gradient*/, void* data) {
  Call& call = *static_cast<Call*>(data);
  try {
    return call.function(std::vector<double>(x, x + count));
  } catch (...) {
    call.thrown = std::current_exception();
    nlopt_force_stop(call.optimizer);
    return std::numeric_limits<double>::infinity();
  }
}

}  // namespace

std::vector<double> bounded_minimum(const Box& box,
                                    const std::function<double(const std::vector<double>&)>& function) {
  const Optimizer optimizer(nlopt_create(NLOPT_LN_BOBYQA, static_cast<unsigned>(box.start.size())));
  if (!optimizer) throw std::bad_alloc();
  Call call{function, optimizer.get(), nullptr};
  nlopt_set_min_objective(optimizer.get(), mesopix_evaluate, &call);
  nlopt_set_lower_bounds(optimizer.get(), box.low.data());
  nlopt_set_upper_bounds(optimizer.get(), box.high.data());
  nlopt_set_xtol_abs1(optimizer.get(), resolution);
  nlopt_set_maxeval(optimizer.get(), most_evaluations);
  std::vector<double> x = box.start;
  double least = 0;
  const nlopt_result result = nlopt_optimize(optimizer.get(), x.data(), &least);
  if (call.thrown) std::rethrow_exception(call.thrown);
  if (result < 0 && result != NLOPT_ROUNDOFF_LIMITED)  // then it is as good as numbers allow
    throw std::runtime_error(
        fmt::format("the search for a minimum failed: {}", nlopt_result_to_string(result)));
  return x;
}

std::string name_of_minimizer() {
  int major = 0;
  int minor = 0;
  int patch = 0;
  nlopt_version(&major, &minor, &patch);
  return fmt::format("BOBYQA (NLopt {}.{}.{})", major, minor, patch);
}

Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix) {
  auto decomposition = Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>();
  decomposition.setThreshold(1e-6);
  decomposition.compute(matrix);
  return decomposition.pseudoInverse();
}

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

namespace {

constexpr std::size_t patience = 6;      ///< evaluations without a better one
constexpr double farthest_step = 4;      ///< first steps in one go
constexpr double same = 0.2;             ///< tolerances by which parameters that are the same may differ
constexpr double widest = 0.05;          ///< change of a logarithm beside a place that is known
constexpr double golden = 0.6180339887;  ///< its multiples leave no gap among their fractions
constexpr double tether = 1e-4;          ///< keeps parameters that do not matter where they are

Eigen::Map<const Eigen::VectorXd> vector_of(const std::vector<double>& values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

class TrendSearch {
 public:
  TrendSearch(const TrendPlan& plan, const Figures& wanted, const Evaluate& evaluate)
      : plan_(plan), wanted_(wanted), evaluate_(evaluate) {}

  SearchEnd run() {
    std::optional<SearchEnd> end = evaluate(plan_.start);
    for (std::size_t i = 0; i < plan_.start.size() && !end; ++i) end = evaluate(beside_start(i));
    while (!end) {
      if (history_[best_].figures.size() == 0) return SearchEnd::no_progress;
      const std::vector<double> next = best_of_trend();
      end = evaluate(is_known(next) ? beside(next) : next);
    }
    return *end;
  }

 private:
  [[nodiscard]] std::vector<double> beside_start(std::size_t parameter) const {
    std::vector<double> point = plan_.start;
    const bool fits_below = point[parameter] - plan_.step >= plan_.low[parameter];
    point[parameter] = fits_below ? point[parameter] - plan_.step
                                  : std::min(point[parameter] + plan_.step, plan_.high[parameter]);
    return point;
  }

  /// @return why the search ends, if it does.
  std::optional<SearchEnd> evaluate(const std::vector<double>& point) {
    std::optional<Evaluation> evaluation = evaluate_(point);
    if (!evaluation) return SearchEnd::stopped;
    points_.push_back(point);
    history_.push_back(std::move(*evaluation));
    const std::size_t last = history_.size() - 1;
    if (history_[last].misfit < history_[best_].misfit) best_ = last;
    if (history_[last].misfit <= plan_.tolerance) return SearchEnd::goal;
    if (history_.size() >= static_cast<std::size_t>(plan_.evaluations)) return SearchEnd::evaluations;
    const bool all_began = last > plan_.start.size();
    return all_began && last >= best_ + patience ? std::optional(SearchEnd::no_progress) : std::nullopt;
  }

  [[nodiscard]] bool is_known(const std::vector<double>& point) const {
    return std::any_of(points_.begin(), points_.end(), [&](const std::vector<double>& known) {
      return (vector_of(point) - vector_of(known)).lpNorm<Eigen::Infinity>() < same * plan_.tolerance;
    });
  }

  /// Farther away the more is missing; never the same place twice.
  [[nodiscard]] std::vector<double> beside(std::vector<double> point) const {
    const double radius = std::clamp(history_[best_].misfit, plan_.tolerance, widest);
    for (std::size_t i = 0; i < point.size(); ++i) {
      const double turns = golden * static_cast<double>((i + 1) * history_.size());
      const double share = 2 * (turns - std::floor(turns)) - 1;
      point[i] = std::clamp(point[i] + radius * share, plan_.low[i], plan_.high[i]);
    }
    return point;
  }

  [[nodiscard]] std::vector<double> best_of_trend() const {
    const std::vector<double>& from = points_[best_];
    const Trend trend = fit_trend(history_, logarithms_of(history_[best_].factors));
    Box box{from, plan_.low, plan_.high};
    for (std::size_t i = 0; i < from.size(); ++i) {
      box.low[i] = std::max(box.low[i], from[i] - farthest_step * plan_.step);
      box.high[i] = std::min(box.high[i], from[i] + farthest_step * plan_.step);
    }
    return bounded_minimum(box, [&](const std::vector<double>& point) {
      const double misfit = mean_square(trend.at(vector_of(point)), wanted_);
      return misfit + tether * (vector_of(point) - vector_of(from)).squaredNorm();
    });
  }

  const TrendPlan& plan_;
  const Figures& wanted_;
  const Evaluate& evaluate_;
  std::vector<std::vector<double>> points_;
  std::vector<Evaluation> history_;
  std::size_t best_ = 0;
};

}  // namespace

SearchEnd search_along_trend(const TrendPlan& plan, const Figures& wanted, const Evaluate& evaluate) {
  return TrendSearch(plan, wanted, evaluate).run();
}

}  // namespace app
