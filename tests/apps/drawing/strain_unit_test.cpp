#include "apps/drawing/ticks.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace strain_unit_test {

using output::strain_unit;

TEST(StrainUnit, IsPercentFromOnePercentOn) {
  EXPECT_EQ(strain_unit(0.00999).name, "microstrain");
  EXPECT_EQ(strain_unit(0.00999).per_strain, 1e6);
  EXPECT_EQ(strain_unit(0.01).name, "%");
  EXPECT_EQ(strain_unit(0.01).per_strain, 100);
}

TEST(StrainUnit, OfARunIsThatOfItsLargestStrain) {
  mpm::Result result;
  EXPECT_EQ(strain_unit(result).name, "microstrain");
  result.history.resize(3);
  result.history[1].strain = 0.05;
  result.history[2].strain = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(strain_unit(result).name, "%");
}

TEST(StrainWords, NameTheShareOfThePeakWhereThereIsOne) {
  mpm::Result result;
  EXPECT_EQ(output::strain_words(result, 118e-6, 1), "118 microstrain");
  result.peak_strain = 118.4e-6;
  EXPECT_EQ(output::strain_words(result, 118e-6, 0), "118 microstrain, 100\u00A0% of the peak strain");
  EXPECT_EQ(output::strain_words(result, 118e-6, 1), "118 microstrain, 99.7\u00A0% of the peak strain");
}

}  // namespace strain_unit_test
