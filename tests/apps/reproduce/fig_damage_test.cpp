// The verdict of figure 7 follows from how the points failed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/job/specimen_source.hpp"
#include "apps/reproduce/figure.hpp"
#include "tests/apps/reproduce/fake_results.hpp"
#include "tests/apps/reproduce/tiny_effort.hpp"

namespace fig_damage_test {

using namespace app::reproduce;
using testing::HasSubstr;

/// Failures in compression: so many rows of pixels in tension before the peak, in shear before and after it.
Section section_of(int tension_before, int shear_before, int shear_after) {
  const Effort effort = test::tiny_effort();
  const Figure figure = damage_figure();
  TrialResults outcomes;
  for (const Trial& trial : figure.trials(effort)) {
    const specimen::Specimen specimen = app::prepare_specimen(settings_of(trial)).specimen;
    const int rows = specimen.mask.labels.rows, cols = specimen.mask.labels.cols;
    mpm::Result result = test::triangle(1e6, 1e-4);
    result.failure_strain = mpm::PixelField<float>::Constant(rows, cols, 1.0F);
    result.failure_mode = mpm::PixelField<std::uint8_t>::Constant(rows, cols, 2);
    result.failure_strain.topRows(tension_before + shear_before).setConstant(0.9e-4F);
    result.failure_mode.topRows(tension_before).setConstant(1);
    result.failure_strain.bottomRows(shear_after).setConstant(1.4e-4F);
    test::put(outcomes, trial, std::move(result));
    outcomes.of(trial).specimen = specimen;
  }
  return figure.evaluate(effort, outcomes);
}

TEST(FigDamage, CompressionDamageIsMostlyInTension) {
  const Claim claim = section_of(9, 1, 0).claims.front();
  EXPECT_EQ(claim.verdict, Verdict::agrees);
  EXPECT_THAT(claim.measured, HasSubstr("in tension: 90.0"));
}

TEST(FigDamage, OrInShear) { EXPECT_EQ(section_of(1, 9, 0).claims.front().verdict, Verdict::disagrees); }

TEST(FigDamage, OrInTensionUpToThePeakAlone) {
  EXPECT_EQ(section_of(6, 1, 10).claims.front().verdict, Verdict::depends);
}

TEST(FigDamage, DataAreTheStages) {
  const auto stages = section_of(9, 1, 0).data["compression"];
  ASSERT_EQ(stages.size(), 6U);
  EXPECT_EQ(stages[3]["tension_failures"], 9 * 24);
  EXPECT_EQ(stages[2]["tension_failures"], 0);
}

}  // namespace fig_damage_test
