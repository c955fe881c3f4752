#include "libmpm/files/replace_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "libmpm/scene/error.hpp"

namespace replace_file_test {

namespace fs = std::filesystem;

class ReplaceFile : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string content(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    return bytes.str();
  }
  std::ptrdiff_t files() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }

  fs::path folder_ = fs::path(testing::TempDir()) / ("replace_file_" + std::to_string(::getpid()));
};

TEST_F(ReplaceFile, HoldsTheBytesAndLeavesNoTemporaryFile) {
  const std::string bytes("a\0b\r\n", 5);
  mpm::replace_file(folder_ / "x", bytes);
  EXPECT_EQ(content(folder_ / "x"), bytes);
  EXPECT_EQ(files(), 1);
}

TEST_F(ReplaceFile, PutsPiecesOneBehindTheOther) {
  const std::string first("a\0", 2);
  mpm::replace_file(folder_ / "x", {first, "", "bc"});
  EXPECT_EQ(content(folder_ / "x"), first + "bc");
  EXPECT_EQ(files(), 1);
}

TEST_F(ReplaceFile, TakesThePlaceOfALongerOne) {
  mpm::replace_file(folder_ / "x", "a longer text");
  mpm::replace_file(folder_ / "x", "short");
  EXPECT_EQ(content(folder_ / "x"), "short");
  EXPECT_EQ(files(), 1);
}

TEST_F(ReplaceFile, SaysWhyItFailsAndCleansUp) {
  fs::create_directory(folder_ / "taken");
  try {
    mpm::replace_file(folder_ / "taken", "bytes");
    FAIL() << "a folder was replaced";
  } catch (const mpm::FileError& error) {
    EXPECT_EQ(error.field, (folder_ / "taken").string());
    EXPECT_THAT(error.what(), testing::HasSubstr("cannot be written: Is a directory"));
  }
  EXPECT_EQ(files(), 1);
}

TEST_F(ReplaceFile, NamesAPathUnderAFile) {
  mpm::replace_file(folder_ / "file", "");
  try {
    mpm::replace_file(folder_ / "file" / "x", "bytes");
    FAIL() << "a file was taken for a folder";
  } catch (const mpm::FileError& error) {
    EXPECT_THAT(error.what(),
                testing::HasSubstr("cannot be written: Not a directory; check that the folder"));
  }
}

/// While it lives, no file of this process may grow beyond a size: a disk that is full in the midst of a
/// write.
class SizeLimit {
 public:
  explicit SizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  SizeLimit(const SizeLimit&) = delete;
  SizeLimit& operator=(const SizeLimit&) = delete;
  ~SizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST_F(ReplaceFile, KeepsTheOldFileWhenTheDiskFillsUp) {
  mpm::replace_file(folder_ / "x", "old");
  {
    const SizeLimit limit(10);
    EXPECT_THROW(mpm::replace_file(folder_ / "x", std::string(100, 'n')), mpm::FileError);
  }
  EXPECT_EQ(content(folder_ / "x"), "old");
  EXPECT_EQ(files(), 1);
}

}  // namespace replace_file_test
