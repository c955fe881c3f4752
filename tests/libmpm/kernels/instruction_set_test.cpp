#include "libmpm/kernels/instruction_set.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "libmpm/scene/error.hpp"

namespace instruction_set_test {

TEST(InstructionSet, AlwaysHasTheBaselineAndPrefersTheFastest) {
  const auto available = mpm::available_kernels();
  EXPECT_STREQ(available.back()->name, "baseline");
  EXPECT_EQ(&mpm::chosen_kernels(""), available.front());
}

TEST(InstructionSet, CanBeChosenAndNamesWhatThereIs) {
  EXPECT_STREQ(mpm::chosen_kernels("baseline").name, "baseline");
  try {
    (void)mpm::chosen_kernels("avx1024");
    FAIL();
  } catch (const mpm::Error& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("solver.instruction_set: avx1024; this processor runs "));
    EXPECT_THAT(error.what(), testing::HasSubstr("baseline"));
  }
}

}  // namespace instruction_set_test
