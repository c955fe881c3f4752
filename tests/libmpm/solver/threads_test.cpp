#include "libmpm/solver/threads.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
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

/// How many threads a team of six has where its user may have `most` tasks; -1 = a part was not done, -2 = it
/// never ended. A process of its own tells, since it cannot take the limit back.
int threads_allowed(rlim_t most) {
  const pid_t process = ::fork();
  if (process == 0) {
    ::alarm(20);
    if (::getuid() == 0 && ::setuid(static_cast<uid_t>(61'000 + most)) != 0) ::_exit(99);
    const rlimit limit{most, most};
    ::setrlimit(RLIMIT_NPROC, &limit);
    mpm::Team team(6);
    std::array<int, 6> done{};
    for (int round = 0; round < 50; ++round)
      team.share(team.threads(), [&](int part) { ++done[static_cast<std::size_t>(part)]; });
    for (int part = 0; part < team.threads(); ++part)
      if (done[static_cast<std::size_t>(part)] != 50) ::_exit(98);
    ::_exit(team.threads() + team.missing() == 6 ? team.threads() : 97);
  }
  int status = 0;
  ::waitpid(process, &status, 0);
  if (!WIFEXITED(status)) return -2;
  return WEXITSTATUS(status) > 90 ? -1 : WEXITSTATUS(status);
}

TEST(Team, IsAsLargeAsTheSystemLetsIt) {
  EXPECT_EQ(threads_allowed(1), 1);
  if (::getuid() != 0) return;  // only root can become a user who has no other tasks
  EXPECT_EQ(threads_allowed(2), 2);
  EXPECT_EQ(threads_allowed(4), 4);
  EXPECT_EQ(threads_allowed(9), 6);
}

}  // namespace threads_test
