// The verdicts of figures 8 to 11 follow from the peaks and from where the points failed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "apps/job/specimen_source.hpp"
#include "apps/reproduce/figure.hpp"
#include "tests/apps/reproduce/fake_results.hpp"
#include "tests/apps/reproduce/tiny_effort.hpp"

namespace fig_two_aggregates_test {

using namespace app::reproduce;
using testing::HasSubstr;

/// Height of a row of pixels above the bottom [m] that has cracked in a field (1, 2, ...).
using CrackHeight = std::function<double(int field)>;

constexpr double tops = 52e-3, bottoms = 23e-3;

/// As if a trial had been run: a peak, and one crack straight across.
void put(TrialResults& outcomes, const Trial& trial, double stress, double strain, double crack_height) {
  mpm::Result result = test::triangle(stress, strain);
  const specimen::Specimen specimen = app::prepare_specimen(settings_of(trial)).specimen;
  const specimen::LabelledMask& mask = specimen.mask;
  result.failure_strain = mpm::PixelField<float>::Constant(mask.labels.rows, mask.labels.cols,
                                                           std::numeric_limits<float>::quiet_NaN());
  result.failure_mode = mpm::PixelField<std::uint8_t>::Constant(mask.labels.rows, mask.labels.cols, 1);
  const auto row = static_cast<Eigen::Index>(mask.labels.rows - 1 - crack_height / mask.pixel_size);
  result.failure_strain.row(row).setConstant(static_cast<float>(1.2 * strain));
  test::put(outcomes, trial, std::move(result));
  outcomes.of(trial).specimen = specimen;
}

/// What the figure makes of fields with these peaks; calibrated runs scale the stress with their strength.
Section section_of(double stress, double strain, const CrackHeight& crack_height) {
  Effort effort = test::tiny_effort();
  effort.specimens = 10;
  const Figure figure = two_aggregates_figure();
  TrialResults outcomes;
  int field = 0;
  for (const Trial& trial : figure.trials(effort))
    put(outcomes, trial, stress, strain, crack_height(++field));
  field = 0;
  for (const Trial& trial : figure.more_trials(effort, outcomes)) {
    const double share = settings_of(trial).phases[1].tensile_scale / 15e6;
    put(outcomes, trial, share * stress, share * strain, crack_height(++field));
  }
  return figure.evaluate(effort, outcomes);
}

double at_the_tops(int) { return tops; }

TEST(FigTwoAggregates, CalibratesTheStrengthForTheMiddleOfThePapersPeaks) {
  const Section section = section_of(3.27e6, 160e-6, at_the_tops);
  EXPECT_NEAR(section.data["calibrated"]["tensile_scale_Pa"].get<double>(), 8.0e6,
              1);  // 15 * 1.745 / 3.27 = 8.005
  EXPECT_NEAR(section.data["table_1"]["tensile_scale_Pa"].get<double>(), 15e6, 1);
}

TEST(FigTwoAggregates, ThePeakDependsOnTheStrengthWhereOnlyACalibratedOneGivesIt) {
  const Claim claim = section_of(3.27e6, 160e-6, at_the_tops).claims[0];
  EXPECT_EQ(claim.verdict, Verdict::depends);
  EXPECT_THAT(claim.why, HasSubstr("f_t = 8.00 MPa in the mortar does"));
}

TEST(FigTwoAggregates, ThePeakAgreesWhereTable1GivesIt) {
  EXPECT_EQ(section_of(1.6e6, 80e-6, at_the_tops).claims[0].verdict, Verdict::agrees);
}

TEST(FigTwoAggregates, ThePeakDisagreesWhereTheStrainIsOffWhateverTheStrength) {
  EXPECT_EQ(section_of(3.27e6, 400e-6, at_the_tops).claims[0].verdict, Verdict::disagrees);
}

TEST(FigTwoAggregates, TheCrackAgreesWhereMostFieldsCrackAtTheTops) {
  const Claim claim =
      section_of(3.27e6, 160e-6, [](int field) { return field <= 8 ? tops : bottoms; }).claims[1];
  EXPECT_EQ(claim.verdict, Verdict::agrees);
  EXPECT_THAT(claim.measured,
              HasSubstr("tops of both aggregates in 8 of 10 fields, near both bottoms in 2, elsewhere in 0; "
                        "it passes above the centres of both in 8 fields and below them in 2"));
}

TEST(FigTwoAggregates, TheCrackDependsOnTheFieldOrDisagrees) {
  const auto verdict = [](int fields) {
    return section_of(3.27e6, 160e-6, [=](int field) { return field <= fields ? tops : 65e-3; })
        .claims[1]
        .verdict;
  };
  EXPECT_EQ(verdict(5), Verdict::depends);
  EXPECT_EQ(verdict(2), Verdict::disagrees);
}

}  // namespace fig_two_aggregates_test
