#include "apps/run/checkpoint_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "libmpm/scene/error.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace checkpoint_folder_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class CheckpointFolder : public testing::Test {
 protected:
  void write(std::int64_t step) {
    mpm::Checkpoint checkpoint;
    checkpoint.instruction_set = "avx2";
    checkpoint.step = step;
    checkpoint.state = "state " + std::to_string(step);
    folder_.write(checkpoint, "a = 1\n", "remarks");
  }
  std::vector<std::string> names() const {
    std::vector<std::string> found;
    if (!fs::exists(checkpoints_)) return found;
    for (const auto& entry : fs::directory_iterator(checkpoints_)) found.push_back(entry.path().filename());
    std::sort(found.begin(), found.end());
    return found;
  }
  void damage(std::int64_t step) const {
    const std::string path = path_of(step);
    std::string bytes = test::read_text(path);
    bytes[bytes.size() / 2] ^= 1;
    test::write_text(path, bytes);
  }
  std::string path_of(std::int64_t step) const {
    std::string digits = std::to_string(step);
    return checkpoints_ / ("step_" + std::string(12 - digits.size(), '0') + digits + ".checkpoint");
  }

  test::TemporaryFolder temporary_;
  fs::path run_ = temporary_ / "run";
  fs::path checkpoints_ = run_ / "checkpoints";
  app::CheckpointFolder folder_{run_};
};

TEST_F(CheckpointFolder, KeepsTheLastTwo) {
  EXPECT_FALSE(folder_.last().last);
  write(90);
  EXPECT_THAT(names(), ElementsAre("step_000000000090.checkpoint"));
  write(1000);
  write(200000);
  EXPECT_THAT(names(), ElementsAre("step_000000001000.checkpoint", "step_000000200000.checkpoint"));
  EXPECT_EQ(folder_.written(), 3);
  EXPECT_GT(folder_.wall_time(), 0);
  const auto found = folder_.last();
  ASSERT_TRUE(found.last);
  EXPECT_THAT(found.faults, IsEmpty());
  EXPECT_EQ(found.last->path, path_of(200000));
  EXPECT_EQ(found.last->file.checkpoint.state, "state 200000");
  EXPECT_EQ(found.last->file.scene_text, "a = 1\n");
  EXPECT_EQ(found.last->file.remarks, "remarks");
}

TEST_F(CheckpointFolder, FallsBackOnTheOneBeforeADamagedOne) {
  write(1);
  write(2);
  damage(2);
  const auto found = folder_.last();
  ASSERT_TRUE(found.last);
  EXPECT_EQ(found.last->file.checkpoint.step, 1);
  EXPECT_THAT(found.faults, ElementsAre(HasSubstr(path_of(2) + ": is damaged")));
  damage(1);
  EXPECT_FALSE(folder_.last().last);
  EXPECT_EQ(folder_.last().faults.size(), 2U);
}

TEST_F(CheckpointFolder, ForgetsWhatIsBehindAStepAndWhatWasCutOff) {
  write(10);
  write(20);
  test::write_text(path_of(30) + ".123-4.tmp", "half");
  test::write_text(checkpoints_ / "notes.tmp", "mine");
  test::write_text(checkpoints_ / "step_12.checkpoint", "mine");
  folder_.remove_behind(10);
  EXPECT_THAT(names(), ElementsAre("notes.tmp", "step_000000000010.checkpoint", "step_12.checkpoint"));
  folder_.remove();
  EXPECT_THAT(names(), ElementsAre("notes.tmp", "step_12.checkpoint"));
}

TEST_F(CheckpointFolder, IsGoneWhenTheRunIsOver) {
  folder_.remove();
  EXPECT_FALSE(fs::exists(run_)) << "nothing is made to be removed";
  write(10);
  folder_.remove();
  EXPECT_FALSE(fs::exists(checkpoints_));
  EXPECT_TRUE(fs::exists(run_));
}

TEST_F(CheckpointFolder, SaysWhereItCannotBeMade) {
  test::write_text(run_, "a file");
  EXPECT_THROW(write(1), mpm::FileError);
}

mpm::Checkpoint checkpoint_of(std::int64_t step) {
  mpm::Checkpoint checkpoint;
  checkpoint.instruction_set = "avx2";
  checkpoint.step = step;
  return checkpoint;
}

TEST_F(CheckpointFolder, IsWrittenBesideTheRun) {
  {
    app::CheckpointWriter writer(folder_, "a = 1\n", "remarks");
    for (std::int64_t step = 1; step <= 5; ++step) writer.write(checkpoint_of(step));
    writer.wait();
    EXPECT_FALSE(writer.is_busy());
    EXPECT_GT(writer.last_time(), 0);
    EXPECT_EQ(writer.trouble(), "");
    writer.write(checkpoint_of(6));
  }
  EXPECT_EQ(folder_.written(), 6) << "none is left behind at the end";
  EXPECT_EQ(folder_.last().last->file.checkpoint.step, 6);
  EXPECT_EQ(folder_.last().last->file.remarks, "remarks");
}

TEST_F(CheckpointFolder, KeepsWhyOneIsMissingForTheRun) {
  test::write_text(run_, "a file");
  app::CheckpointWriter writer(folder_, "", "");
  writer.write(checkpoint_of(1));
  writer.wait();
  EXPECT_THAT(writer.trouble(), HasSubstr("cannot be created"));
  fs::remove(run_);
  writer.write(checkpoint_of(2));
  writer.wait();
  EXPECT_EQ(writer.trouble(), "");
}

}  // namespace checkpoint_folder_test
