#include "apps/bench/error_study.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace error_study_test {

using namespace app::bench;

Run gives(double value, double wall_time, const std::string& trouble = {}) {
  return [=] { return Measured{value, wall_time, 1000, trouble}; };
}

/// Errors of 4, 1 and 0.25 % in 1, 2 and 4 s; and one method that is slower for its error but once.
Problem made_up() {
  Problem problem{"made-up", "A problem", "error", "known", "nothing", {}, {}};
  problem.methods.push_back(
      {"good", "cell", "", {0.4, 0.2, 0.1}, {gives(0.04, 1), gives(-0.01, 2), gives(0.0025, 4)}});
  problem.methods.push_back({"slow", "cell", "", {0.4, 0.2}, {gives(0.05, 1.5), gives(0.002, 8)}});
  return problem;
}

std::vector<bool> front_of(const MethodResult& method) {
  std::vector<bool> front;
  for (const Sample& sample : method.samples) front.push_back(sample.in_front);
  return front;
}

TEST(ErrorStudy, FitsTheOrderOfEachMethod) {
  const auto results = study_errors({made_up()}, {});
  ASSERT_EQ(results.size(), 1U);
  EXPECT_NEAR(results[0].methods[0].order, 2, 1e-12);
  EXPECT_EQ(results[0].methods[0].samples[1].error, 0.01) << "errors have no sign";
  EXPECT_TRUE(std::isnan(results[0].methods[1].order)) << "two runs show no order";
}

TEST(ErrorStudy, GivesNoOrderWhereTheErrorDoesNotFollowTheSize) {
  Problem problem = made_up();
  problem.methods[0].runs[1] = gives(0.041, 2);
  EXPECT_TRUE(std::isnan(study_errors({problem}, {})[0].methods[0].order));
}

TEST(ErrorStudy, MarksWhatNoOtherRunBeats) {
  const auto results = study_errors({made_up()}, {});
  EXPECT_EQ(front_of(results[0].methods[0]), (std::vector<bool>{true, true, true}));
  EXPECT_EQ(front_of(results[0].methods[1]), (std::vector<bool>{false, true}));
}

TEST(ErrorStudy, FindsTheCheapestWay) {
  const auto results = study_errors({made_up()}, {});
  const Cheapest way = cheapest_within(results[0], 0.01);
  ASSERT_NE(way.sample, nullptr);
  EXPECT_EQ(way.method->name, "good");
  EXPECT_EQ(way.sample->size, 0.2);
  EXPECT_EQ(cheapest_within(results[0], 0.001).sample, nullptr);
  EXPECT_EQ(most_exact(results[0]).method->name, "slow");
}

TEST(ErrorStudy, TakesTheErrorFromTheReferenceWhereThereIsOne) {
  Problem problem = made_up();
  problem.reference = gives(2, 10);
  problem.methods = {{"only", "pixel", "mm", {1, 0.5}, {gives(2.2, 1), gives(1.9, 2)}}};
  const auto results = study_errors({problem}, {});
  EXPECT_NEAR(results[0].methods[0].samples[0].error, 0.1, 1e-12);
  EXPECT_NEAR(results[0].methods[0].samples[1].error, 0.05, 1e-12);
  EXPECT_EQ(results[0].reference_time, 10);
}

TEST(ErrorStudy, ARunThatStoppedHasNoErrorAndIsNoWay) {
  Problem problem = made_up();
  problem.methods[0].runs[1] = gives(0, 0.5, "a point left the grid");
  const auto results = study_errors({problem}, {});
  const Sample& sample = results[0].methods[0].samples[1];
  EXPECT_TRUE(std::isnan(sample.error));
  EXPECT_FALSE(sample.in_front);
  EXPECT_EQ(sample.trouble, "a point left the grid");
  EXPECT_EQ(cheapest_within(results[0], 0.02).sample->error, 0.0025);
  EXPECT_TRUE(std::isnan(results[0].methods[0].order)) << "of two that came to their end";
}

TEST(ErrorStudy, TakesTheMedianOfShortRuns) {
  int count = 0;
  Problem problem = made_up();
  problem.methods = {{"short", "cell", "", {1}, {[&] {
                        const double times[] = {9e-3, 1e-3, 5e-3, 2e-3, 3e-3};
                        return Measured{0.01, times[count++ % 5], 1, {}};
                      }}}};
  const auto results = study_errors({problem}, {});
  EXPECT_EQ(count, 5);
  EXPECT_EQ(results[0].methods[0].samples[0].wall_time, 3e-3);
  EXPECT_TRUE(std::isnan(results[0].methods[0].order)) << "of one size";
}

TEST(ErrorStudy, TellsHowFarItIsAndKeepsWhatWasDoneBeforeItWasStopped) {
  std::size_t told = 0;
  const auto results = study_errors({made_up(), made_up()}, {[&](std::size_t done, std::size_t all) {
                                                               EXPECT_EQ(done, ++told);
                                                               EXPECT_EQ(all, 10U);
                                                             },
                                                             [&] { return told < 7; }});
  EXPECT_EQ(told, 7U);
  EXPECT_EQ(results.size(), 1U);
}

}  // namespace error_study_test
