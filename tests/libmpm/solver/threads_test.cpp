#include "libmpm/solver/threads.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <sstream>
#include <string>
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

/// What /proc/loadavg says with so many tasks that run, this one among them.
int idle_cores_with(const char* running, int cores) {
  std::istringstream load(std::string("0.20 0.18 0.12 ") + running + "/480 11206\n");
  return mpm::idle_cores(load, cores);
}

TEST(IdleCores, AreOneWhereEveryCoreIsBusy) {
  EXPECT_EQ(idle_cores_with("9", 8), 1);
  EXPECT_EQ(idle_cores_with("100", 8), 1);
}

TEST(IdleCores, AreNoMoreThanThereAre) {
  EXPECT_EQ(idle_cores_with("1", 8), 8);
  EXPECT_EQ(idle_cores_with("3", 8), 6);
  EXPECT_EQ(idle_cores_with("0", 8), 8) << "as where the tasks of others are not told";
  std::istringstream nothing;
  EXPECT_EQ(mpm::idle_cores(nothing, 8), 8);
  const int cores = mpm::idle_cores();
  EXPECT_GE(cores, 1);
  EXPECT_LE(cores, static_cast<int>(std::thread::hardware_concurrency()));
}

TEST(Team, DoesEveryPartOnce) {
  for (const int threads : {1, 2, 4}) {
    mpm::Team team(threads);
    EXPECT_EQ(team.threads(), threads);
    std::vector<int> done(4, 0);
    int expected[4] = {0, 0, 0, 0};
    for (int round = 0; round < 500; ++round) {
      const int parts = 1 + round % threads;
      team.share(parts, [&](int part) { ++done[static_cast<std::size_t>(part)]; });
      for (int part = 0; part < parts; ++part) ++expected[part];
      for (int part = 0; part < 4; ++part)
        ASSERT_EQ(done[static_cast<std::size_t>(part)], expected[part]) << round;
    }
  }
}

}  // namespace threads_test
