#include "apps/bench/problem_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace known_problems_test {

using namespace app::bench;

/// The first `count` runs of each method alone.
Problem shortened(Problem problem, std::size_t count) {
  for (Method& method : problem.methods) {
    method.sizes.resize(std::min(count, method.sizes.size()));
    method.runs.resize(method.sizes.size());
  }
  return problem;
}

const MethodResult& method_named(const ProblemResult& result, const std::string& name) {
  for (const MethodResult& method : result.methods)
    if (method.method->name == name) return method;
  ADD_FAILURE() << name;
  return result.methods.front();
}

// Coarse runs of every method come to their end with an error that says something.
TEST(KnownProblems, AllMethodsComeToTheirEnd) {
  const auto results = study_errors(
      {shortened(bar_problem(), 1), shortened(manufactured_problem(), 1), shortened(layers_problem(), 1),
       shortened(spin_problem(), 1), shortened(collision_problem(), 1), shortened(flight_problem(), 1)},
      {});
  ASSERT_EQ(results.size(), 6U);
  for (const ProblemResult& result : results)
    for (const MethodResult& method : result.methods) {
      const Sample& sample = method.samples.at(0);
      EXPECT_EQ(sample.trouble, "") << result.problem.name << " " << method.method->name;
      EXPECT_LT(sample.error, 1.5) << result.problem.name << " " << method.method->name;
      EXPECT_GT(sample.point_updates, 0);
      EXPECT_GT(sample.wall_time, 0);
    }
}

TEST(KnownProblems, TheBarShowsWhatPicDampsAndTheOrderOfTheOthers) {
  const auto results = study_errors({shortened(bar_problem(), 2)}, {});
  EXPECT_GT(method_named(results[0], "GIMP MUSL FLIP").order, 1.7);
  EXPECT_GT(method_named(results[0], "GIMP MUSL PIC").samples[1].error, 0.5);
}

TEST(KnownProblems, SinglePrecisionIsSingle) {
  const auto results = study_errors({shortened(flight_problem(), 1)}, {});
  EXPECT_LT(method_named(results[0], "GIMP MUSL FLIP").samples[0].error, 1e-11);
  EXPECT_GT(method_named(results[0], "GIMP MUSL FLIP single").samples[0].error, 1e-8);
}

}  // namespace known_problems_test
