#include "apps/report/key_figures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/apps/fake_run.hpp"

namespace key_figures_test {

using namespace output;
using testing::ElementsAre;
using testing::Pair;

TEST(SecantModulus, IsTakenAtFortyPercentOfThePeak) {
  mpm::Result result;
  result.peak_stress = 10;
  for (const double stress : {0.0, 3.0, 4.5, 10.0})
    result.history.push_back({.strain = stress * stress + stress, .stress = stress});
  EXPECT_DOUBLE_EQ(secant_modulus(result), 4.5 / (4.5 * 4.5 + 4.5));
}

TEST(SecantModulus, IsNoNumberWithoutARun) {
  EXPECT_TRUE(std::isnan(secant_modulus({})));
  mpm::Result at_rest;
  at_rest.history.push_back({});
  EXPECT_TRUE(std::isnan(secant_modulus(at_rest)));
}

TEST(PhaseShares, NameThePhasesThatAreThere) {
  const FakeRun run = still_run({"1222", "1222"});
  EXPECT_THAT(phase_shares(run.specimen.mask), ElementsAre(Pair("aggregate", 0.25), Pair("mortar", 0.75)));
}

TEST(Notes, EndWithThePicturesThatAreMissing) {
  const FakeRun run = tension_run(30, 110);
  RunRecord record = run.record();
  record.notes = {"first"};
  EXPECT_THAT(all_notes(record),
              ElementsAre("first",
                          "The run ended at 110 % of the peak strain: there is no picture of damage at "
                          "125 % and 150 %."));
}

}  // namespace key_figures_test
