#include "apps/system/hdf5_files.hpp"

#include <gtest/gtest.h>
#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <iostream>
#include <new>
#include <stdexcept>
#include <thread>
#include <vector>

#include "apps/text/complaint.hpp"
#include "libmpm/files/frame_file.hpp"
#include "libmpm/files/result_file.hpp"
#include "libmpm/scene/error.hpp"
#include "specimen/file/specimen_file.hpp"
#include "tests/apps/refusal.hpp"
#include "tests/damaged.hpp"
#include "tests/libmpm/sample_scenes.hpp"
#include "tests/specimen/sample_specimen.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace hdf5_files_test {

class Hdf5Files : public testing::Test {
 protected:
  static mpm::Result result() {
    mpm::Result result;
    for (int i = 0; i < 77; ++i)
      result.history.push_back({.time = 1e-6 * i, .strain = 1e-7 * i, .stress = 10. * i});
    result.failure_strain.setConstant(3, 2, 1e-4F);
    result.failure_mode.setZero(3, 2);
    return result;
  }

  /// "read", or how it was refused.
  template <class Read>
  std::string verdict(const std::string& bytes, Read read) const {
    test::write_text(path_, bytes);
    try {
      (void)read(path_);
    } catch (const app::Rejected& rejected) {
      EXPECT_EQ(rejected.code, app::Exit::data);
      return rejected.what();
    } catch (const mpm::FileError& error) {
      EXPECT_EQ(error.field, path_);
      return error.what();
    }
    return "read";
  }

  /// How often a file was refused with a bit turned over here and there, as HDF5 alone writes it:
  /// attributes have no checksum, so that a number may be another one.
  template <class Read>
  int refusals(std::size_t step, Read read) const {
    int refused = 0;
    test::flip_bits(test::unsealed(test::read_text(path_)), step,
                    [&](const std::string& bytes) { refused += verdict(bytes, read) == "read" ? 0 : 1; });
    return refused;
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_ / "file.h5";
};

TEST_F(Hdf5Files, AreReadAsTheLibrariesReadThem) {
  mpm::write_result(path_, result(), "[loading]\n");
  EXPECT_EQ(app::read_result(path_).history.size(), 77U);
  EXPECT_EQ(app::read_scene_text(path_), "[loading]\n");
}

/// HDF5 1.10 divides by zero where a chunk has no axes.
TEST_F(Hdf5Files, OnWhichHdf5FailsAreRefused) {
  mpm::write_result(path_, result(), "");
  std::string bytes = test::unsealed(test::read_text(path_));
  const std::string chunk("\x4d\0\0\0\x08\0\0\0", 8);  // 77 values of 8 bytes
  const std::size_t at = bytes.find(chunk);
  ASSERT_NE(at, std::string::npos);
  bytes[at - 9] = 0;  // number of axes, before the 8 bytes of an address
  EXPECT_EQ(verdict(bytes, app::read_result),
            path_ + ": is damaged: HDF5 fails on it; take a copy of it, or make it again");
}

TEST_F(Hdf5Files, DamagedAreReadOrRefused) {
  mpm::write_result(path_, result(), "[loading]\n");
  EXPECT_GT(refusals(1009, app::read_result), 0);
  mpm::Frame frame;
  for (std::uint32_t i = 0; i < 50; ++i) frame.points.push_back({.id = i, .x = 0.1 * i, .damage = 0.01 * i});
  mpm::write_frame(path_, frame, samples::mortar_block(10, 10));
  EXPECT_GT(refusals(1009, app::read_frame), 0);
}

TEST(Hdf5Turn, IsHadByOneThreadAtATime) {
  std::atomic<int> inside = 0, most = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      for (int k = 0; k < 200; ++k) {
        const app::Hdf5Turn turn = app::hdf5_turn();
        const int now = ++inside;
        if (now > most) most = now;
        std::this_thread::yield();
        --inside;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(most, 1);
}

std::string verdict(const std::function<void()>& read) {
  return test::refusal([&] { app::try_reading("file.h5", read, 1); });
}

constexpr const char* cure = "; take a copy of it, or make it again";

TEST(Trial, LeavesNoTraceOfWhatWasRead) {
  bool was_read = false;
  EXPECT_EQ(verdict([&] { was_read = true; }), "nothing");
  EXPECT_FALSE(was_read) << "in this process";
}

#ifdef NDEBUG  // under sanitizers there is no limit

rlim_t memory_in_use() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmData:")) return 1024 * std::stoull(line.substr(7));
  return 0;
}

/// What reading with so much memory more comes to: 0 = it is read, 1 = the memory is told, 2 = a fault of the
/// file is.
int outcome_with(rlim_t more, const std::function<void()>& read) {
  const pid_t process = ::fork();
  if (process == 0) {
    ::malloc_trim(0);  // what is free in the heap would do as well
    const rlimit limit{memory_in_use() + more, RLIM_INFINITY};
    ::setrlimit(RLIMIT_DATA, &limit);
    try {
      read();
    } catch (const std::bad_alloc&) {
      ::_exit(1);
    } catch (...) {
      ::_exit(2);
    }
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(process, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 3;
}

TEST_F(Hdf5Files, AreNotDamagedWhereMemoryIsMissing) {
  mpm::Result large = result();
  large.failure_strain.setRandom(800, 800);
  large.failure_mode.setZero(800, 800);
  mpm::write_result(path_, large, "[loading]\n");
  specimen::Specimen specimen = test::sample_specimen();
  specimen.mask.labels = specimen::Raster<std::uint8_t>(2500, 2500, specimen::phase::mortar);
  specimen::write_specimen(folder_ / "s.h5", specimen);
  const std::function<void()> reads[] = {[&] { (void)mpm::read_result(path_); },
                                         [&] { (void)specimen::read_specimen(folder_ / "s.h5"); }};
  for (const auto& read : reads) {
    std::array<int, 4> count{};
    for (rlim_t more = 0; more <= (rlim_t{16} << 20U); more += rlim_t{1} << 19U)
      ++count.at(static_cast<std::size_t>(outcome_with(more, read)));
    EXPECT_GT(count[0], 0);
    EXPECT_GT(count[1], 0);
    EXPECT_EQ(count[2], 0) << "but HDF5 itself may end the process";
  }
}
#endif

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

/// As the system ends what takes more memory than there is.
TEST(Trial, ThatIsKilledAtOnceLacksMemory) {
  EXPECT_THROW(app::try_reading("file.h5", [] { std::raise(SIGKILL); }), std::bad_alloc);
}

TEST(Trial, ThatTheUserEndsSaysNothingOfTheFile) {
  EXPECT_EQ(verdict([] { std::raise(SIGTERM); }), "nothing");
}

}  // namespace hdf5_files_test
