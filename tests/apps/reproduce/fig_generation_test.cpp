#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/reproduce/figure.hpp"
#include "tests/apps/reproduce/tiny_effort.hpp"

namespace fig_generation_test {

using namespace app::reproduce;
using testing::HasSubstr;

Claim claim_of(const Section& section, const std::string& id) {
  for (const Claim& claim : section.claims)
    if (claim.id == id) return claim;
  ADD_FAILURE() << "no claim " << id;
  return {};
}

TEST(FigGeneration, ThePapersSpecimenHasItsCounts) {
  Effort effort;
  effort.specimens = 1;
  const Section section = generation_figure().evaluate(effort, TrialResults());
  EXPECT_EQ(section.data["aggregates"], 73);
  EXPECT_EQ(section.data["itz_points"], 2628);
  EXPECT_EQ(claim_of(section, "specimen").verdict, Verdict::agrees);
  EXPECT_EQ(claim_of(section, "generation-time").verdict, Verdict::agrees);
}

TEST(FigGeneration, AnotherSpecimenHasNot) {
  const Section section = generation_figure().evaluate(test::tiny_effort(), TrialResults());
  EXPECT_EQ(claim_of(section, "specimen").verdict, Verdict::disagrees);
  EXPECT_THAT(claim_of(section, "specimen").why, HasSubstr("Not every count"));
}

}  // namespace fig_generation_test
