#include "apps/bench/problem_table.hpp"

#include <gtest/gtest.h>

#include "tests/apps/reproduce/tiny_study.hpp"

namespace concrete_problems_test {

using namespace app::bench;

const MethodResult& method_named(const ProblemResult& result, const std::string& name) {
  for (const MethodResult& method : result.methods)
    if (method.method->name == name) return method;
  ADD_FAILURE() << name;
  return result.methods.front();
}

// Slower loading comes nearer to the reference, which is slower still.
TEST(ConcreteProblems, SlowerLoadingIsMoreExact) {
  auto problem = tension_problem(test::tiny_study().square);
  problem.methods.erase(problem.methods.begin() + 5, problem.methods.end());
  const auto results = study_errors({problem}, {});
  EXPECT_GT(results[0].reference_value, 1e6);
  const auto& samples = method_named(results[0], "small strain CFL 0.8").samples;
  EXPECT_LT(samples.back().error, 0.03);
  EXPECT_LT(samples.back().error, samples.front().error);
}

// 24 mm of 0.25 mm pixels against pixels of 0.5 mm and more.
TEST(ConcreteProblems, FinerPixelsGiveTheModulus) {
  auto settings = test::tiny_study().square;
  std::erase_if(settings, [](const auto& setting) { return setting.first == "generate.pixel_size"; });
  auto problem = modulus_problem(settings);
  problem.methods.resize(1);
  const auto results = study_errors({problem}, {});
  EXPECT_GT(results[0].reference_value, 20e9) << "of the mortar alone";
  EXPECT_LT(results[0].reference_value, 30e9) << "Voigt's bound for 45 % of aggregate is 29 GPa";
  EXPECT_LT(results[0].methods[0].samples.back().error, 0.01);
}

}  // namespace concrete_problems_test
