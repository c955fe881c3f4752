// The verdicts of figures 12 to 14 follow from the peaks, whatever these are.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "apps/reproduce/figure.hpp"
#include "tests/apps/reproduce/fake_results.hpp"

namespace fig_parameters_test {

using namespace app::reproduce;
using testing::HasSubstr;

/// A figure's section for results that are made from the settings of each run.
Section section_of(const Figure& figure,
                   const std::function<mpm::Result(const Trial&, const app::Settings&)>& result) {
  Effort effort;
  effort.repeats = 1;
  TrialResults outcomes;
  for (const Trial& trial : figure.trials(effort))
    test::put(outcomes, trial, result(trial, settings_of(trial)));
  return figure.evaluate(effort, outcomes);
}

const mpm::Phase& mortar(const app::Settings& settings) { return settings.phases[1]; }

Claim claim_of(const Section& section, const std::string& id) {
  for (const Claim& claim : section.claims)
    if (claim.id == id) return claim;
  ADD_FAILURE() << "no claim " << id;
  return {};
}

/// Peaks that go with m to a power, by the scene.
Section modulus_section(double tension_power, double compression_power, double drop_power = 0) {
  return section_of(modulus_figure(), [=](const Trial& trial, const app::Settings& settings) {
    const double m = mortar(settings).weibull_modulus;
    return test::triangle(1e6 * std::pow(m, trial.scene == "tension" ? tension_power : compression_power),
                          1e-4, 1 + std::pow(m, drop_power));
  });
}

TEST(FigParameters, PeaksRiseWithTheModulus) {
  EXPECT_EQ(claim_of(modulus_section(0.3, 0.5), "peaks-rise-with-m").verdict, Verdict::agrees);
  EXPECT_EQ(claim_of(modulus_section(-0.3, -0.5), "peaks-rise-with-m").verdict, Verdict::disagrees);
  const Claim half = claim_of(modulus_section(0.3, -0.5), "peaks-rise-with-m");
  EXPECT_EQ(half.verdict, Verdict::depends);
  EXPECT_EQ(
      half.why,
      "Holds in: tension; does not hold in: compression. A trend counts from a rank correlation of 0.85 on.");
}

TEST(FigParameters, TheMeasuredTextHoldsTheNumbersOfTheRuns) {
  EXPECT_EQ(claim_of(modulus_section(1, 2), "peaks-rise-with-m").measured,
            "Peaks: tension 1.00 to 6.00 MPa, compression 1.00 to 36.0 MPa for m = 1 to 6.");
}

TEST(FigParameters, MoreBrittleWithTheModulus) {
  EXPECT_EQ(claim_of(modulus_section(0.3, 0.5, -0.5), "more-brittle-with-m").verdict, Verdict::agrees);
  EXPECT_EQ(claim_of(modulus_section(0.3, 0.5, 0.2), "more-brittle-with-m").verdict, Verdict::disagrees);
}

TEST(FigParameters, StrengthMovesThePeaks) {
  const auto verdict = [](double tension_power, double compression_power) {
    const Section section =
        section_of(strength_figure(), [=](const Trial& trial, const app::Settings& settings) {
          EXPECT_NEAR(settings.phases[2].tensile_scale, 0.6 * mortar(settings).tensile_scale, 1);
          return test::triangle(std::pow(mortar(settings).tensile_scale,
                                         trial.scene == "tension" ? tension_power : compression_power),
                                1e-4);
        });
    return claim_of(section, "strength-moves-both-peaks").verdict;
  };
  EXPECT_EQ(verdict(1, 0.9), Verdict::agrees);
  EXPECT_EQ(verdict(1, 0.1), Verdict::depends);
  EXPECT_EQ(verdict(0, 0), Verdict::disagrees);
}

Claim cohesion_claim(double tension_power, double open_power, double closing_power) {
  const Section section =
      section_of(cohesion_figure(), [=](const Trial& trial, const app::Settings& settings) {
        const double power = trial.scene == "tension"       ? tension_power
                             : trial.scene == "compression" ? open_power
                                                            : closing_power;
        return test::triangle(std::pow(mortar(settings).cohesion, power), 1e-4);
      });
  return claim_of(section, "cohesion-moves-compression");
}

TEST(FigParameters, CohesionMovesCompressionMainly) {
  EXPECT_EQ(cohesion_claim(0, 0.5, 0.5).verdict, Verdict::agrees);
  EXPECT_EQ(cohesion_claim(0, 0, 0).verdict, Verdict::disagrees);
  EXPECT_EQ(cohesion_claim(0.5, 0.5, 0.5).verdict, Verdict::disagrees);  // not mainly
}

TEST(FigParameters, CohesionDependsOnCrackClosure) {
  const Claim claim = cohesion_claim(0, 0, 1);
  EXPECT_EQ(claim.verdict, Verdict::depends);
  EXPECT_THAT(claim.why,
              HasSubstr("Holds in: compression, cracks close (clipped) and compression, cracks close "
                        "(unilateral); does not hold in: compression."));
}

TEST(FigParameters, TheValueOfTable1IsTheSceneAsItStands) {
  Effort effort;
  int plain = 0;
  for (const Trial& trial : modulus_figure().trials(effort))
    plain += trial.settings.size() == 2;  // the two seeds
  EXPECT_EQ(plain, 2 * effort.repeats);
}

TEST(FigParameters, DataHoldEveryCase) {
  const Section section = modulus_section(1, 2);
  EXPECT_NEAR(section.data["compression"]["peak_stress_Pa"][4]["mean"].get<double>(), 36e6, 1);
  EXPECT_NEAR(section.data["tension"]["shear_share"][0].get<double>(), 0.1, 1e-12);
}

}  // namespace fig_parameters_test
