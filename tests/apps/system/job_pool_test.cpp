#include "apps/system/job_pool.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <numeric>
#include <stdexcept>
#include <thread>

namespace job_pool_test {

using app::run_jobs;
using testing::ElementsAre;
using Jobs = std::vector<std::function<void()>>;

TEST(JobPool, EachJobWritesItsOwnPlaceWhoeverDoesIt) {
  std::vector<int> places(50, 0), expected(50);
  std::iota(expected.begin(), expected.end(), 0);
  Jobs jobs;
  for (int i = 0; i < 50; ++i)
    jobs.emplace_back([&places, i] {
      std::this_thread::sleep_for(std::chrono::microseconds((50 - i) * 10));  // later ones end first
      places[static_cast<std::size_t>(i)] += i;
    });
  EXPECT_EQ(run_jobs(jobs, 4), 50U);
  EXPECT_EQ(places, expected);
}

TEST(JobPool, OneWorkerDoesThemInTheirOrder) {
  std::vector<int> order;
  EXPECT_EQ(
      run_jobs({[&] { order.push_back(1); }, [&] { order.push_back(2); }, [&] { order.push_back(3); }}, 1),
      3U);
  EXPECT_THAT(order, ElementsAre(1, 2, 3));
}

TEST(JobPool, HoldsWorkersToTheCores) {
  const int cores = app::core_count();
  EXPECT_EQ(app::workers_within_cores(1, "--jobs").count, 1);
  EXPECT_EQ(app::workers_within_cores(cores, "--jobs").note, "");
  const app::Workers held = app::workers_within_cores(cores + 62, "--jobs");
  EXPECT_EQ(held.count, cores);
  EXPECT_THAT(held.note, testing::StartsWith("--jobs " + std::to_string(cores + 62) +
                                             " is more than there are cores: there "));
}

TEST(JobPool, UsesSeveralThreadsAtOnce) {
  std::atomic<int> waiting = 0;
  const auto meet = [&] {
    ++waiting;
    while (waiting < 2) std::this_thread::yield();  // would hang for ever on one thread
  };
  EXPECT_EQ(run_jobs({meet, meet}, 2), 2U);
}

TEST(JobPool, PassesOnTheErrorOfTheFirstJobOfTheList) {
  std::atomic<bool> second_failed = false;
  const Jobs jobs{[&] {
                    while (!second_failed) std::this_thread::yield();
                    throw std::runtime_error("first");
                  },
                  [&] {
                    second_failed = true;
                    throw std::runtime_error("second");
                  }};
  try {
    run_jobs(jobs, 2);
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "first");
  }
}

TEST(JobPool, BeginsNoJobAfterAFailure) {
  int done = 0;
  EXPECT_THROW(run_jobs({[] { throw std::runtime_error("no"); }, [&] { ++done; }}, 1), std::runtime_error);
  EXPECT_EQ(done, 0);
}

TEST(JobPool, StopsWhenItIsTold) {
  int done = 0;
  const Jobs jobs(5, [&] { ++done; });
  EXPECT_EQ(run_jobs(jobs, 1, {{}, [&] { return done < 2; }}), 2U);
  EXPECT_EQ(done, 2);
}

TEST(JobPool, TellsHowManyAreDone) {
  std::vector<std::size_t> told;
  run_jobs(Jobs(3, [] {}), 2, {[&](std::size_t done, std::size_t) { told.push_back(done); }, {}});
  EXPECT_THAT(told, ElementsAre(1, 2, 3));
}

TEST(JobPool, HasNothingToDoWithoutJobs) { EXPECT_EQ(run_jobs({}, 2), 0U); }

TEST(JobPool, ThereIsACore) { EXPECT_GE(app::core_count(), 1); }

}  // namespace job_pool_test
