#include "libmpm/solver/threads.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace idle_cores_test {

TEST(IdleCores, AreOneWhereEveryCoreIsBusy) {
  const auto cores = static_cast<int>(std::thread::hardware_concurrency());
  std::atomic<bool> done{false};
  std::vector<std::jthread> busy;
  for (int i = 0; i < 3 * cores; ++i)
    busy.emplace_back([&] {
      while (!done) {
      }
    });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_EQ(mpm::idle_cores(), 1);
  done = true;
}

TEST(IdleCores, AreNoMoreThanThereAre) {
  const int cores = mpm::idle_cores();
  EXPECT_GE(cores, 1);
  EXPECT_LE(cores, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace idle_cores_test
