#include "libmpm/scene/error.hpp"

#include <gtest/gtest.h>

namespace error_test {

TEST(Error, SaysFieldValueAllowedAndCure) {
  const mpm::Error error("phases.mortar.young", "-20 GPa", "must be > 0",
                         "give the modulus with its unit, e.g. \"20 GPa\"");
  EXPECT_STREQ(error.what(),
               "phases.mortar.young: -20 GPa; must be > 0; give the modulus with its unit, e.g. \"20 GPa\"");
  EXPECT_EQ(error.field, "phases.mortar.young");
}

TEST(Error, LeavesEmptyPartsOut) {
  EXPECT_STREQ(mpm::Error("seed", "-1", "must be >= 0").what(), "seed: -1; must be >= 0");
}

}  // namespace error_test
