#include "libmpm/files/checkpoint_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "libmpm/scene/error.hpp"
#include "libmpm/solver/checkpoint.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace checkpoint_file_test {

using mpm::Checkpoint;
using testing::HasSubstr;
using testing::StartsWith;

Checkpoint sample() {
  Checkpoint checkpoint;
  checkpoint.precision = mpm::Precision::single;
  checkpoint.moving = true;
  checkpoint.instruction_set = "avx2";
  checkpoint.specimen = std::string(32, '\xab');
  checkpoint.step = 1234567;
  checkpoint.fraction = 1.0 / 3;
  checkpoint.wall_time = 77.7;
  checkpoint.frames = {{0.0, 12}, {1e-6 / 3, 11}};
  checkpoint.state = std::string("st\0ate", 6) + std::string(300, 'x');
  return checkpoint;
}

class CheckpointFile : public testing::Test {
 protected:
  void write() const { mpm::write_checkpoint(path_, sample(), "a = 1\n", "remarks"); }

  /// What is said of the file.
  std::string complaint() const {
    try {
      (void)mpm::read_checkpoint(path_);
    } catch (const mpm::FileError& error) {
      EXPECT_EQ(error.field, path_);
      return std::string(error.what()).substr(path_.size() + 2);
    }
    return "nothing";
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_ / "step_1.checkpoint";
};

TEST_F(CheckpointFile, GivesBackWhatWasWritten) {
  write();
  EXPECT_EQ(folder_.size(), 1) << "nothing temporary is left";
  const mpm::CheckpointFile read = mpm::read_checkpoint(path_);
  const Checkpoint wanted = sample();
  EXPECT_EQ(read.scene_text, "a = 1\n");
  EXPECT_EQ(read.remarks, "remarks");
  EXPECT_EQ(read.checkpoint.precision, wanted.precision);
  EXPECT_EQ(read.checkpoint.moving, wanted.moving);
  EXPECT_EQ(read.checkpoint.instruction_set, wanted.instruction_set);
  EXPECT_EQ(read.checkpoint.specimen, wanted.specimen);
  EXPECT_EQ(read.checkpoint.step, wanted.step);
  EXPECT_EQ(read.checkpoint.fraction, wanted.fraction);
  EXPECT_EQ(read.checkpoint.wall_time, wanted.wall_time);
  EXPECT_EQ(read.checkpoint.state, wanted.state);
  ASSERT_EQ(read.checkpoint.frames.size(), 2U);
  EXPECT_EQ(read.checkpoint.frames[1].time, wanted.frames[1].time);
  EXPECT_EQ(read.checkpoint.frames[1].points, 11);
}

TEST_F(CheckpointFile, KnowsEveryByteThatChanged) {
  write();
  const std::string good = test::read_text(path_);
  for (std::size_t i = 0; i < good.size(); i += 3) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 0x20);
    test::write_text(path_, bad);
    EXPECT_THAT(complaint(), i < 8 ? StartsWith("is not a checkpoint") : StartsWith("is damaged: its digest"))
        << i;
  }
}

TEST_F(CheckpointFile, KnowsWhereItIsCutShortOrGoesOn) {
  write();
  const std::string good = test::read_text(path_);
  for (std::size_t length = 0; length < good.size(); length += 7) {
    test::write_text(path_, good.substr(0, length));
    EXPECT_THAT(complaint(), length < 40 ? StartsWith("is not a checkpoint") : StartsWith("is damaged"))
        << length;
  }
  test::write_text(path_, good + "x");
  EXPECT_THAT(complaint(), StartsWith("is damaged"));
}

TEST_F(CheckpointFile, SaysWhatCannotBeRead) {
  EXPECT_THAT(complaint(), StartsWith("cannot be read: No such file"));
  std::filesystem::create_directory(path_);
  EXPECT_THAT(complaint(), StartsWith("is a folder"));
  std::filesystem::remove(path_);
  std::filesystem::create_symlink("/dev/zero", path_);
  EXPECT_THAT(complaint(), StartsWith("is not a regular file"));
}

TEST_F(CheckpointFile, AsksForNoMemoryForWhatIsNone) {
  test::write_text(path_, "anything");
  std::filesystem::resize_file(path_, std::uintmax_t{1} << 42U);
  EXPECT_THAT(complaint(), StartsWith("is not a checkpoint"));
}

/// The bytes with a digest that is right.
std::string sealed(std::string bytes) {
  bytes.resize(bytes.size() - mpm::sha256_bytes);
  return bytes + mpm::Sha256().add(bytes).digest();
}

TEST_F(CheckpointFile, IsOfThisVersion) {
  write();
  std::string other = test::read_text(path_);
  other[8] = 2;
  test::write_text(path_, sealed(other));
  EXPECT_EQ(complaint(), "is of version 2; must be of version 1; resume with the program that wrote it");
}

// Whoever changes a checkpoint can make its digest right again.
TEST_F(CheckpointFile, TrustsNothingInItEither) {
  write();
  const std::string good = test::read_text(path_);
  ASSERT_EQ(sealed(good), good);
  int refused = 0;
  for (std::size_t i = 16; i < good.size() - mpm::sha256_bytes; ++i) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 0xff);
    test::write_text(path_, sealed(bad));
    const std::string said = complaint();
    if (said == "nothing") continue;  // a text or a number that can be
    EXPECT_THAT(said, StartsWith("holds ")) << i;
    ++refused;
  }
  EXPECT_GT(refused, 60) << "lengths are eight bytes each";
}

TEST_F(CheckpointFile, SaysWhereItCannotBeWritten) {
  path_ = folder_ / "no/such/folder";
  try {
    write();
    FAIL();
  } catch (const mpm::FileError& error) {
    EXPECT_EQ(error.field, path_);
  }
}

}  // namespace checkpoint_file_test
