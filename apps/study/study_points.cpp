#include "apps/study/study_points.hpp"

#include <fmt/format.h>

#include <boost/random/sobol.hpp>
#include <numeric>
#include <utility>

#include "apps/study/study_values.hpp"
#include "specimen/body/random.hpp"

namespace app {
namespace {

constexpr double most_points = 100'000;

std::vector<std::vector<Value>> grid(const StudyPlan& plan) {
  double count = 1;
  for (const StudyParameter& parameter : plan.parameters)
    count *= static_cast<double>(parameter.levels.size());
  if (count > most_points)
    throw Rejected(Exit::data,
                   {plan.parameters.front().place, "vary", fmt::format("a grid of {:.0f} points", count),
                    fmt::format("must have at most {:.0f}", most_points),
                    "choose sampling = \"sobol\" and a number of samples"});
  std::vector<std::vector<Value>> points{{}};
  for (const StudyParameter& parameter : plan.parameters) {
    std::vector<std::vector<Value>> finer;
    for (const std::vector<Value>& point : points)
      for (const Value& level : parameter.levels) {
        finer.push_back(point);
        finer.back().push_back(level);
      }
    points = std::move(finer);
  }
  return points;
}

}  // namespace

std::vector<std::vector<double>> sobol_points(std::size_t dimensions, std::size_t count) {
  boost::random::sobol sequence(dimensions);  // it leaves out its point 0, the origin, by itself
  std::vector<std::vector<double>> points(count, std::vector<double>(dimensions));
  for (std::vector<double>& point : points)
    for (double& u : point) u = static_cast<double>(sequence()) * 0x1p-64;
  return points;
}

std::vector<std::vector<double>> latin_hypercube(std::size_t dimensions, std::size_t count,
                                                 std::uint64_t seed) {
  specimen::Random random(seed);
  std::vector<std::vector<double>> points(count, std::vector<double>(dimensions));
  std::vector<std::size_t> strata(count);
  for (std::size_t axis = 0; axis < dimensions; ++axis) {
    std::iota(strata.begin(), strata.end(), std::size_t{0});
    for (std::size_t i = count; i > 1; --i)  // Fisher and Yates
      std::swap(strata[i - 1], strata[static_cast<std::size_t>(random.uniform() * static_cast<double>(i))]);
    for (std::size_t i = 0; i < count; ++i)
      points[i][axis] = (static_cast<double>(strata[i]) + random.uniform()) / static_cast<double>(count);
  }
  return points;
}

std::vector<std::vector<Value>> points_of(const StudyPlan& plan) {
  if (plan.sampling == Sampling::grid) return grid(plan);
  const std::size_t dimensions = plan.parameters.size();
  const auto count = static_cast<std::size_t>(plan.samples);
  const auto places = plan.sampling == Sampling::sobol
                          ? sobol_points(dimensions, count)
                          : latin_hypercube(dimensions, count, plan.sampling_seed);
  std::vector<std::vector<Value>> points;
  for (const std::vector<double>& place : places) {
    points.emplace_back();
    for (std::size_t axis = 0; axis < dimensions; ++axis)
      points.back().push_back(value_at_place(plan.parameters[axis], place[axis]));
  }
  return points;
}

}  // namespace app
