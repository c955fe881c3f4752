#include "apps/study/slurm.hpp"

#include <gtest/gtest.h>

#include "apps/text/complaint.hpp"
#include "libmpm/files/replace_file.hpp"
#include "tests/apps/fake_slurm.hpp"

namespace slurm_queue_test {

using namespace app;

class SlurmQueue : public testing::Test {
 protected:
  test::TemporaryFolder study_;
  test::FakeSlurm slurm_;
};

TEST_F(SlurmQueue, EveryJobHasAFolderOfItsOwn) {
  EXPECT_TRUE(slurm_folders(study_ / "").empty());
  const SlurmFolder first = SlurmFolder::next(study_ / ""), second = SlurmFolder::next(study_ / "");
  EXPECT_EQ(first.path(), study_ / "slurm/001");
  EXPECT_EQ(second.path(), study_ / "slurm/002");
  ASSERT_EQ(slurm_folders(study_ / "").size(), 2U);
  EXPECT_EQ(slurm_folders(study_ / "")[1].path(), second.path());
  EXPECT_EQ(second.job_id(), "") << "it was not submitted";
}

TEST_F(SlurmQueue, KeepsWhatSlurmCallsAJob) {
  slurm_.answer("sbatch", "echo '4711;hall_b'");
  const SlurmFolder folder = SlurmFolder::next(study_ / "");
  mpm::replace_file(folder.script().string(), "#!/bin/bash\n");
  EXPECT_EQ(folder.submit(), "4711");
  EXPECT_EQ(folder.job_id(), "4711");
  EXPECT_EQ(slurm_.asked("sbatch"), "--parsable " + folder.script().string() + "\n");
}

TEST_F(SlurmQueue, TellsWhySlurmRefusesAJob) {
  slurm_.answer("sbatch", "echo 'sbatch: error: invalid partition' >&2; echo more >&2; exit 1");
  const SlurmFolder folder = SlurmFolder::next(study_ / "");
  try {
    (void)folder.submit();
    FAIL() << "nothing was thrown";
  } catch (const Rejected& rejected) {
    EXPECT_EQ(rejected.code, Exit::io);
    EXPECT_STREQ(
        rejected.what(),
        "sbatch: sbatch: error: invalid partition more; mesopix study submit --help tells how to give "
        "it options");
  }
  EXPECT_EQ(folder.job_id(), "");
}

TEST_F(SlurmQueue, CountsTasksByState) {
  slurm_.answer("squeue", "printf 'RUNNING\\nPENDING\\nRUNNING\\n'");
  EXPECT_EQ(tasks_in_queue("12"), (std::map<std::string, int>{{"PENDING", 1}, {"RUNNING", 2}}));
  EXPECT_EQ(slurm_.asked("squeue"), "--array --noheader --format=%T --jobs=12\n");
  slurm_.answer("squeue", "echo 'slurm_load_jobs error: Invalid job id specified' >&2; exit 1");
  EXPECT_TRUE(tasks_in_queue("12").empty()) << "Slurm has forgotten it";
}

}  // namespace slurm_queue_test
