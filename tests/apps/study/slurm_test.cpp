#include "apps/study/slurm.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "apps/system/processes.hpp"
#include "apps/text/complaint.hpp"
#include "apps/text/text_parts.hpp"
#include "libmpm/files/replace_file.hpp"
#include "tests/apps/fake_slurm.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace slurm_test {

using ::testing::HasSubstr;
namespace fs = std::filesystem;
using namespace app;

app::SlurmJob job_of(std::vector<std::string> study) {
  return {.name = "strength",
          .folder = "/tmp",
          .logs = "/tmp/logs",
          .study = std::move(study),
          .members = 23,
          .chunk = 5,
          .tasks = {0, 1, 2, 4},
          .cpus = 2,
          .wishes = {"--time=1:00:00"}};
}

TEST(SlurmJob, WritesNumbersAsRanges) {
  EXPECT_EQ(app::ranges_text({0}), "0");
  EXPECT_EQ(app::ranges_text({0, 1, 2, 3}), "0-3");
  EXPECT_EQ(app::ranges_text({0, 2, 3, 7, 9, 10}), "0,2-3,7,9-10");
}

TEST(SlurmJob, AsksForWhatItsTasksNeed) {
  const std::string script = app::slurm_script(job_of({"mesopix", "study", "a b.toml"}));
  for (const char* line : {"#!/bin/bash\n", "#SBATCH --array=0-2,4\n", "#SBATCH --cpus-per-task=2\n",
                           "#SBATCH --output='/tmp/logs/task_%a.log'\n", "#SBATCH --requeue\n",
                           "#SBATCH --time=1:00:00\n", "mesopix study 'a b.toml' --members"})
    EXPECT_THAT(script, HasSubstr(line));
}

TEST(SlurmJob, KeepsNamesOnTheirLines) {
  app::SlurmJob job = job_of({"mesopix"});
  job.name = "a\n#SBATCH --uid=0";
  job.logs = "/tmp/100%";
  const std::string script = app::slurm_script(job);
  EXPECT_THAT(script, HasSubstr("#SBATCH --job-name='a?#SBATCH --uid=0'\n"));
  EXPECT_THAT(script, HasSubstr("'/tmp/100%%/task_%a.log'\n"));
}

TEST(SlurmJob, ListsACommandATask) {
  EXPECT_EQ(app::command_list(job_of({"mesopix", "study", "s.toml"})),
            "cd /tmp && mesopix study s.toml --members 0:5 --jobs 2\n"
            "cd /tmp && mesopix study s.toml --members 5:10 --jobs 2\n"
            "cd /tmp && mesopix study s.toml --members 10:15 --jobs 2\n"
            "cd /tmp && mesopix study s.toml --members 20:23 --jobs 2\n");
}

/// The script runs in Bash, with a stand-in for scontrol that notes what it is asked for.
class SlurmScript : public ::testing::Test {
 protected:
  void SetUp() override {
    test::write_text(folder_ / "scontrol",
                     "#!/bin/sh\necho \"$@\" >" + app::shell_word(folder_ / "asked") + "\n");
    fs::permissions(folder_ / "scontrol", fs::perms::owner_all);
  }

  /// As task 4, beside a command that may send it signals.   @param study  what it runs.
  app::ProgramOutcome run(const std::string& study, const std::string& beside = "") {
    test::write_text(folder_ / "job.sh", app::slurm_script(job_of({"sh", "-c", study, "study"})));
    const std::string path = app::shell_word(folder_ / "");
    return app::run_other_program(
        {"sh", "-c",
         "cd " + path + "; export PATH=" + path +
             ":\"$PATH\" SLURM_ARRAY_TASK_ID=4 SLURM_JOB_ID=77\nbash job.sh & job=$!\n" + beside +
             "\nwait $job"});
  }

  const test::TemporaryFolder folder_;
};

TEST_F(SlurmScript, RunsTheMembersOfItsTask) {
  const auto outcome = run("echo \"$@\"; exit 65");
  EXPECT_EQ(outcome.out, "--members 20:23 --jobs 2\n");
  EXPECT_EQ(outcome.code, 65);
  EXPECT_EQ(test::read_text(folder_ / "asked"), "");
}

/// Says when it can be sent signals, and ends on one.
std::string ends_on(const char* signal) {
  return std::string("trap 'echo got ") + signal + "; exit 75' " + signal +
         "; : >ready; while :; do sleep 0.01; done";
}

std::string send(const char* signal) {
  return std::string("while [ ! -e ready ]; do sleep 0.01; done; kill -") + signal + " $job";
}

TEST_F(SlurmScript, QueuesItselfAgainWhenItsTimeIsNearlyUp) {
  const auto outcome = run("cd " + app::shell_word(folder_ / "") + "; " + ends_on("USR1"), send("USR1"));
  EXPECT_EQ(outcome.out, "got USR1\n");
  EXPECT_EQ(test::read_text(folder_ / "asked"), "requeue 77\n");
  EXPECT_EQ(outcome.code, 75);
}

TEST_F(SlurmScript, EndsForGoodWhenItIsCancelled) {
  const auto outcome = run("cd " + app::shell_word(folder_ / "") + "; " + ends_on("TERM"), send("TERM"));
  EXPECT_EQ(outcome.out, "got TERM\n");
  EXPECT_EQ(test::read_text(folder_ / "asked"), "");
  EXPECT_EQ(outcome.code, 75);
}

TEST_F(SlurmScript, TellsOfAProgramThatWasKilled) { EXPECT_EQ(run("kill -9 $$").code, 137); }

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

}  // namespace slurm_test
