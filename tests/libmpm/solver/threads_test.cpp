#include "libmpm/solver/threads.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace threads_test {

/// What thread `index` does in a round before it comes to the barrier.
using Work = void (*)(int index, int round);

/// Every thread writes the round to its place, and behind the barrier reads those of all others.
/// @return how often a place held another round.
int wrong_places(int threads, int rounds, Work work) {
  mpm::Barrier barrier(threads);
  std::vector<int> places(static_cast<std::size_t>(threads), -1);
  std::vector<int> wrong(static_cast<std::size_t>(threads), 0);
  {
    std::vector<std::jthread> all;
    for (int i = 0; i < threads; ++i)
      all.emplace_back([&, i] {
        for (int round = 0; round < rounds; ++round) {
          work(i, round);
          places[static_cast<std::size_t>(i)] = round;
          barrier.arrive_and_wait();
          for (const int place : places) wrong[static_cast<std::size_t>(i)] += place == round ? 0 : 1;
          barrier.arrive_and_wait();
        }
      });
  }
  int sum = 0;
  for (const int count : wrong) sum += count;
  return sum;
}

TEST(Barrier, NobodyPassesBeforeAllHaveCome) {
  EXPECT_EQ(wrong_places(1, 10, [](int, int) {}), 0);
  EXPECT_EQ(wrong_places(2, 2000, [](int, int) {}), 0);
  EXPECT_EQ(wrong_places(5, 500, [](int, int) {}), 0);
}

TEST(Barrier, WakesThreadsThatHaveFallenAsleep) {
  const auto late = [](int index, int round) {
    if (index == round % 3) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  };
  EXPECT_EQ(wrong_places(3, 6, late), 0);
}

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

}  // namespace threads_test
