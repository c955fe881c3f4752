#include "specimen/teach/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace parallel_test {

TEST(ShareOut, DoesEachPieceOnceOnAnyNumberOfThreads) {
  for (const int threads : {0, 1, 3, 16}) {
    std::vector<int> times(100, 0);
    specimen::share_out(100, threads, [&](int i) { ++times[static_cast<std::size_t>(i)]; });
    EXPECT_EQ(times, std::vector<int>(100, 1)) << threads;
  }
  specimen::share_out(0, 2, [](int) { FAIL(); });
}

TEST(ShareOut, HandsOnAnExceptionAndBeginsNoMore) {
  std::atomic<int> begun{0};
  const auto work = [&](int i) {
    ++begun;
    if (i == 3) throw std::runtime_error("the third");
  };
  EXPECT_THROW(specimen::share_out(1'000'000, 2, work), std::runtime_error);
  EXPECT_LT(begun, 1'000'000);
}

}  // namespace parallel_test
