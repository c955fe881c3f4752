#include "apps/system/hdf5_files.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <stdexcept>

#include "tests/apps/refusal.hpp"

namespace trial_test {

std::string verdict(const std::function<void()>& read) {
  return test::refusal([&] { app::try_reading("file.h5", read, 1); });
}

constexpr const char* cure = "; take a copy of it, or make it again";

TEST(Trial, LeavesNoTraceOfWhatWasRead) {
  bool was_read = false;
  EXPECT_EQ(verdict([&] { was_read = true; }), "nothing");
  EXPECT_FALSE(was_read) << "in this process";
}

TEST(Trial, LeavesErrorsToTheProgram) {
  EXPECT_EQ(verdict([] { throw std::runtime_error("no such file"); }), "nothing");
}

TEST(Trial, OutlivesWhatEndsAProcess) {
  for (const int signal : {SIGSEGV, SIGFPE, SIGBUS, SIGABRT, SIGILL})
    EXPECT_EQ(verdict([&] { std::raise(signal); }),
              std::string("file.h5: is damaged: HDF5 fails on it") + cure)
        << signal;
  testing::internal::CaptureStderr();
  EXPECT_EQ(verdict([] {
              std::cerr << "free(): invalid pointer" << std::endl;
              std::exit(3);
            }),
            std::string("file.h5: is damaged: HDF5 fails on it") + cure);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Trial, DoesNotWaitForWhatHasNoEnd) {
  EXPECT_EQ(verdict([] {
              for (volatile bool goes_on = true; goes_on;) continue;
            }),
            std::string("file.h5: is damaged: HDF5 comes to no end with it") + cure);
}

TEST(Trial, ThatTheUserEndsSaysNothingOfTheFile) {
  EXPECT_EQ(verdict([] { std::raise(SIGTERM); }), "nothing");
}

}  // namespace trial_test
