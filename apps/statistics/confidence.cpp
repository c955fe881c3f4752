#include "apps/statistics/confidence.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "apps/statistics/statistics.hpp"

namespace app {
namespace {

constexpr double upper_tail = 0.025;
constexpr std::size_t most_values = 100'000'000;

/// Half width of the interval over the standard deviation.
double width_factor(std::size_t count) {
  const auto n = static_cast<double>(count);
  const boost::math::students_t student(n - 1);
  return boost::math::quantile(boost::math::complement(student, upper_tail)) / std::sqrt(n);
}

}  // namespace

double MeanEstimate::relative_half_width() const { return half_width / std::abs(mean); }

MeanEstimate mean_estimate(const std::vector<double>& values) {
  const std::size_t count = finite_of(values).size();
  const Spread spread = spread_of(values);
  return {count, spread.mean, spread.deviation,
          count < 2 ? no_number : width_factor(count) * spread.deviation};
}

std::size_t values_needed(const MeanEstimate& estimate, double share) {
  const double wanted = share * std::abs(estimate.mean) / estimate.deviation;
  if (estimate.count < 2 || std::isnan(wanted)) return 0;
  std::size_t enough = 2;
  while (width_factor(enough) > wanted)
    if ((enough *= 2) > most_values) return 0;
  std::size_t too_few = enough / 2;  // the factor falls with the count
  while (enough - too_few > 1) {
    const std::size_t middle = too_few + (enough - too_few) / 2;
    (width_factor(middle) > wanted ? too_few : enough) = middle;
  }
  return enough;
}

}  // namespace app
