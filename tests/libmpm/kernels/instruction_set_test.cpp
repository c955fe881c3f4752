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
    EXPECT_THAT(error.what(),
                testing::StartsWith("solver.instruction_set: avx1024; this processor supports "));
    EXPECT_THAT(error.what(), testing::HasSubstr("baseline"));
  }
}

/// Half the least number of full precision, which the compiler cannot know.
double half_of_least() {
  volatile double least = 2.2250738585072014e-308;
  volatile double half = 0.5;
  return least * half;
}

TEST(FlushToZero, LastsAsLongAsItLives) {
  EXPECT_GT(half_of_least(), 0);
  {
    const mpm::FlushToZero flush;
#ifdef __x86_64__
    EXPECT_EQ(half_of_least(), 0);
#endif
    { const mpm::FlushToZero again; }
#ifdef __x86_64__
    EXPECT_EQ(half_of_least(), 0) << "what an outer one asked for stays";
#endif
  }
  EXPECT_GT(half_of_least(), 0);
}

}  // namespace instruction_set_test
