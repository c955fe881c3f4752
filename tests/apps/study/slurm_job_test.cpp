#include "apps/study/slurm.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "apps/system/processes.hpp"
#include "apps/text/text_parts.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace slurm_job_test {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

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

}  // namespace slurm_job_test
