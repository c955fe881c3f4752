#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "apps/system/processes.hpp"
#include "tests/apps/fake_slurm.hpp"
#include "tests/apps/program_in_folder.hpp"
#include "tests/apps/small_study.hpp"

namespace study_submit_command_test {

namespace fs = std::filesystem;
using app::Exit;
using testing::AllOf;
using testing::HasSubstr;

class StudySubmitCommand : public test::ProgramInFolder {
 protected:
  StudySubmitCommand() : ProgramInFolder("study") { test::write_small_study(".", "seeds = 23\n"); }
  test::FakeSlurm slurm_;
};

TEST_F(StudySubmitCommand, HandsAnArrayJobToSlurm) {
  slurm_.answer("sbatch", "echo 88");
  ASSERT_EQ(run({"submit", "study.toml", "--slurm", "--sbatch=--time=10:00", "--sbatch=-p short"}), Exit::ok)
      << err_.str();
  EXPECT_EQ(err_.str(),
            "submitted job 88: 3 tasks of 10 members\n"
            "to see how far it is: mesopix study status study.toml\n"
            "for tables and report: mesopix study collect study.toml\n");
  const std::string script = test::read_text("runs/study/slurm/001/job.sh");
  for (const char* piece : {"#SBATCH --job-name=study\n", "#SBATCH --array=0-2\n",
                            "#SBATCH --time=10:00\n#SBATCH -p short\n", " study study.toml --members "})
    EXPECT_THAT(script, HasSubstr(piece));
  EXPECT_EQ(test::read_text("runs/study/slurm/001/job_id"), "88\n");
}

TEST_F(StudySubmitCommand, LeavesOutTasksThatAreOver) {
  ASSERT_EQ(run({"study.toml", "-o", "out", "--members", "4:8"}), Exit::ok) << err_.str();
  ASSERT_EQ(run({"submit", "study.toml", "-o", "out", "--commands", "--chunk", "4"}), Exit::ok) << err_.str();
  EXPECT_THAT(out_.str(), AllOf(HasSubstr("-o out --members 0:4 --jobs 1\n"), HasSubstr("--members 20:23"),
                                testing::Not(HasSubstr("--members 4:8"))));
  EXPECT_EQ(err_.str(), "");
}

TEST_F(StudySubmitCommand, WritesTheScriptAloneWhenAskedTo) {
  slurm_.answer("sbatch", "echo 88");
  ASSERT_EQ(run({"submit", "study.toml", "--slurm", "--dry-run", "--chunk", "100", "--jobs", "4"}), Exit::ok);
  EXPECT_EQ(err_.str(), "wrote runs/study/slurm/001/job.sh: 1 tasks of 100 members\n");
  EXPECT_THAT(test::read_text("runs/study/slurm/001/job.sh"), HasSubstr("#SBATCH --cpus-per-task=4\n"));
  EXPECT_EQ(slurm_.asked("sbatch"), "");
}

TEST_F(StudySubmitCommand, RefusesWhatItCannotSubmit) {
  expect_refusal({"submit", "study.toml"}, "study submit: must be told where to: --slurm or --commands");
  expect_refusal({"submit", "study.toml", "--slurm", "--commands"},
                 "study submit: --slurm and --commands; must be told where to: --slurm or --commands");
  expect_refusal({"submit", "study.toml", "--commands", "--sbatch=-p x"},
                 "--sbatch: given with --commands; goes with --slurm");
  expect_refusal({"submit", "study.toml", "--slurm", "--sbatch=short"},
                 "--sbatch: \"short\"; must be an option of sbatch; --sbatch=--time=1:00:00");
  expect_refusal(
      {"submit", "study.toml", "--slurm", "--sbatch=-p x\n#SBATCH --uid=0"},
      "--sbatch: \"-p x\\n#SBATCH --uid=0\"; must be an option of sbatch; --sbatch=--time=1:00:00");
  expect_refusal({"submit", "study.toml", "--slurm", "--chunk", "0"}, "--chunk: 0; must lie in [1, 100000]");
  expect_refusal({"submit", "study.toml", "--slurm", "--chunks", "2"},
                 "--chunks: unknown option; did you mean --chunk?; mesopix study submit --help lists them");
  expect_refusal({"submit"}, "STUDY: missing; mesopix study STUDY.toml");
}

TEST_F(StudySubmitCommand, TellsTheJobAsJsonAndIsQuiet) {
  slurm_.answer("sbatch", "echo 88");
  ASSERT_EQ(run({"submit", "study.toml", "--slurm", "--json", "-q"}), Exit::ok) << err_.str();
  EXPECT_EQ(err_.str(), "");
  EXPECT_EQ(
      nlohmann::json::parse(out_.str()),
      (nlohmann::json{
          {"job", "88"}, {"script", "runs/study/slurm/001/job.sh"}, {"tasks", 3}, {"members_a_task", 10}}));
  expect_refusal({"submit", "study.toml", "--commands", "--json"},
                 "--json: given with --commands; goes with --slurm");
}

class StudyCluster : public StudySubmitCommand {};

TEST_F(StudyCluster, StatusCountsMembersAndTasks) {
  slurm_.answer("sbatch", "echo 88");
  slurm_.answer("squeue", "printf 'RUNNING\\nPENDING\\n'");
  ASSERT_EQ(run({"submit", "study.toml", "--slurm"}), Exit::ok) << err_.str();
  ASSERT_EQ(run({"study.toml", "--members", "0:4"}), Exit::ok) << err_.str();
  ASSERT_EQ(run({"status", "study.toml"}), Exit::ok) << err_.str();
  EXPECT_EQ(
      out_.str(),
      "runs/study: 23 members: 4 done, 0 failed, 0 begun, 19 open\nSlurm job 88: 1 PENDING, 1 RUNNING\n");
  ASSERT_EQ(run({"status", "study.toml", "--json"}), Exit::ok);
  EXPECT_THAT(out_.str(),
              AllOf(HasSubstr("\"done\": 4,"), HasSubstr("\"id\": \"88\""), HasSubstr("\"RUNNING\": 1")));
}

TEST_F(StudyCluster, StatusNeedsNoSlurmForAStudyWithoutJobs) {
  ASSERT_EQ(run({"status", "study.toml", "-o", "new"}), Exit::ok) << err_.str();
  EXPECT_EQ(out_.str(), "new: 23 members: 0 done, 0 failed, 0 begun, 23 open\n");
  EXPECT_EQ(slurm_.asked("squeue"), "");
}

TEST_F(StudyCluster, CollectMakesWhatARunInOneGoMakes) {
  ASSERT_EQ(run({"study.toml", "-o", "one"}), Exit::ok) << err_.str();
  ASSERT_EQ(run({"study.toml", "-o", "parts", "--members", "10:23"}), Exit::ok);
  EXPECT_EQ(run({"collect", "study.toml", "-o", "parts"}), Exit::interrupted);
  EXPECT_THAT(err_.str(), HasSubstr("10 of 23 members have no result yet\n"));
  EXPECT_THAT(test::read_text("parts/table.csv"), HasSubstr(",open,"));
  EXPECT_EQ(run({"collect", "study.toml", "-o", "parts", "--json", "-q"}), Exit::interrupted);
  EXPECT_THAT(err_.str(), HasSubstr("warning: 9 of 13 members are no slow tests, such as member 10"));
  EXPECT_EQ(nlohmann::json::parse(out_.str())["open"], 10);
  ASSERT_EQ(run({"study.toml", "-o", "parts", "--members", "0:10"}), Exit::ok);
  ASSERT_EQ(run({"collect", "study.toml", "-o", "parts"}), Exit::ok) << err_.str();
  for (const char* name : {"/table.csv", "/table.h5", "/report.html"})
    EXPECT_EQ(test::read_text(std::string("parts") + name), test::read_text(std::string("one") + name))
        << name;
}

TEST_F(StudyCluster, CollectRefusesAStudyThatHasNothing) {
  EXPECT_EQ(run({"collect", "study.toml"}), Exit::data);
  EXPECT_EQ(err_.str(), "mesopix: study collect: runs/study; has no result yet; mesopix study submit\n");
}

}  // namespace study_submit_command_test
