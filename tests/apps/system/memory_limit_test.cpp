#include "apps/system/processes.hpp"

#include <gtest/gtest.h>

namespace memory_limit_test {

using app::memory_to_take;

TEST(MemoryLimit, IsWhatTheMachineOrTheContainerHas) {
  EXPECT_EQ(memory_to_take(1000, ""), 1000);
  EXPECT_EQ(memory_to_take(1000, "max"), 1000);
  EXPECT_EQ(memory_to_take(1000, "400"), 400);
  EXPECT_EQ(memory_to_take(1000, "4000"), 1000);
  EXPECT_EQ(memory_to_take(1000, "99999999999999999999999"), 1000);
}

#ifdef NDEBUG  // presets of sanitizers, under which there is no limit, are for debugging
TEST(MemoryLimitDeathTest, TurnsTooLargeAWishIntoAnError) {
  const auto ask = [] {
    app::limit_memory();
    try {
      // Untouched, so that nothing but the limit stands in the way.
      for (int i = 0; i < 1'000'000; ++i) (void)new char[std::size_t{1} << 28U];
    } catch (const std::bad_alloc&) {
      std::exit(3);
    }
    std::exit(4);
  };
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(ask(), testing::ExitedWithCode(3), "");
}
#endif

}  // namespace memory_limit_test
