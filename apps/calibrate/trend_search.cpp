#include "apps/calibrate/trend_search.hpp"

#include <algorithm>
#include <cmath>

#include "apps/calibrate/bounded_minimum.hpp"
#include "apps/calibrate/trend.hpp"

namespace app {
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
