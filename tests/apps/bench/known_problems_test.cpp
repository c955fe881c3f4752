#include "apps/bench/problem_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/apps/reproduce/tiny_effort.hpp"

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
  const auto results = study_errors({shortened(bar_problem(), 3)}, {});
  EXPECT_NEAR(method_named(results[0], "pixel cells").order, 2, 0.05);
  EXPECT_GT(method_named(results[0], "GIMP MUSL FLIP").order, 1.7);
  EXPECT_GT(method_named(results[0], "GIMP MUSL PIC").samples[1].error, 0.5);
}

TEST(KnownProblems, PixelCellsAreNearerAtTheInclusionThanCellsOfFour) {
  const auto results = study_errors({shortened(inclusion_problem(), 2)}, {});
  const auto& pixels = method_named(results[0], "pixel cells").samples;
  const auto& fours = method_named(results[0], "small strain").samples;
  for (const std::size_t size : {0U, 1U}) EXPECT_LT(pixels[size].error, 0.7 * fours[size].error);
  EXPECT_LT(pixels[1].error, pixels[0].error);
}

TEST(KnownProblems, SinglePrecisionIsSingle) {
  const auto results = study_errors({shortened(flight_problem(), 1)}, {});
  EXPECT_LT(method_named(results[0], "GIMP MUSL FLIP").samples[0].error, 1e-11);
  EXPECT_GT(method_named(results[0], "GIMP MUSL FLIP single").samples[0].error, 1e-8);
}

// Slower loading comes nearer to the reference, which is slower still.
TEST(ConcreteProblems, SlowerLoadingIsMoreExact) {
  auto problem = tension_problem(test::tiny_effort().square);
  problem.methods.erase(problem.methods.begin() + 5, problem.methods.end());
  const auto results = study_errors({problem}, {});
  EXPECT_GT(results[0].reference_value, 1e6);
  const auto& samples = method_named(results[0], "small strain CFL 0.8").samples;
  EXPECT_LT(samples.back().error, 0.03);
  EXPECT_LT(samples.back().error, samples.front().error);
}

// 24 mm of 0.25 mm pixels against pixels of 0.5 mm and more.
TEST(ConcreteProblems, FinerPixelsGiveTheModulus) {
  auto settings = test::tiny_effort().square;
  std::erase_if(settings, [](const auto& setting) { return setting.first == "generate.pixel_size"; });
  auto problem = modulus_problem(settings);
  problem.methods.resize(1);
  const auto results = study_errors({problem}, {});
  EXPECT_GT(results[0].reference_value, 20e9) << "of the mortar alone";
  EXPECT_LT(results[0].reference_value, 30e9) << "Voigt's bound for 45 % of aggregate is 29 GPa";
  EXPECT_LT(results[0].methods[0].samples.back().error, 0.01);
}

}  // namespace known_problems_test
