#include "libmpm/kernels/instruction_set.hpp"

#include <gtest/gtest.h>

namespace flush_to_zero_test {

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

}  // namespace flush_to_zero_test
