#include "libmpm/instruction_set.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "libmpm/error.hpp"

namespace {

TEST(InstructionSet, AlwaysHasTheBaselineAndPrefersTheFastest) {
  const auto available = mpm::available_kernels();
  EXPECT_STREQ(available.back()->name, "baseline");
  EXPECT_EQ(&mpm::chosen_kernels(), available.front());
}

TEST(InstructionSet, CanBeChosenAndNamesWhatThereIs) {
  setenv("MESOPIX_INSTRUCTION_SET", "baseline", 1);
  EXPECT_STREQ(mpm::chosen_kernels().name, "baseline");
  setenv("MESOPIX_INSTRUCTION_SET", "avx1024", 1);
  try {
    (void)mpm::chosen_kernels();
    FAIL();
  } catch (const mpm::Error& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("MESOPIX_INSTRUCTION_SET: avx1024; this processor runs "));
    EXPECT_THAT(error.what(), testing::HasSubstr("baseline"));
  }
  unsetenv("MESOPIX_INSTRUCTION_SET");
}

}  // namespace
