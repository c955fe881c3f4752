#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/apps/program_in_folder.hpp"
#include "tests/apps/small_study.hpp"

namespace study_command_test {

namespace fs = std::filesystem;
using app::Exit;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class StudyCommand : public test::ProgramInFolder {
 protected:
  StudyCommand() : ProgramInFolder("study") {}
  static void write(const std::string& study) { test::write_small_study(".", study); }
  static std::string table(const std::string& folder) { return test::read_text(folder + "/table.csv"); }
  static std::ptrdiff_t results(const std::string& folder) {
    return std::distance(fs::directory_iterator(folder + "/members"), fs::directory_iterator());
  }
};

TEST_F(StudyCommand, LeavesMembersTablesAndAReport) {
  write("title = \"Small ones\"\nseeds = 6\n");
  ASSERT_EQ(run({"study.toml"}), Exit::ok) << err_.str();
  EXPECT_THAT(err_.str(), AllOf(HasSubstr("mean peak "), HasSubstr("wrote runs/study\n")));
  EXPECT_EQ(results("runs/study"), 6);
  EXPECT_THAT(table("runs/study"), StartsWith("member,id,state,seed,peak_stress_Pa,peak_strain,"));
  EXPECT_THAT(table("runs/study"), Not(HasSubstr("wall")));
  EXPECT_THAT(test::read_text("runs/study/timing.csv"),
              StartsWith("member,id,wall_time_s,instruction_set\n0,"));
  const std::string report = test::read_text("runs/study/report.html");
  for (const char* piece : {"<h1>Small ones</h1>", "Peaks", "Weibull distribution of the peaks",
                            "How the mean settles", "Curves", "Where it cracks", "The study file"})
    EXPECT_THAT(report, HasSubstr(piece));
  EXPECT_TRUE(fs::exists("runs/study/cracks.png"));
  EXPECT_EQ(test::read_text("runs/study/study.toml"), test::read_text("study.toml"));
  EXPECT_EQ(test::read_text("runs/study/scene.toml"), test::read_text("scene.toml"));
}

TEST_F(StudyCommand, TheTableIsTheSameWhateverRanWhereAndWhen) {
  write("seeds = 2\n[vary]\n\"loading.velocity\" = [\"0.2 m/s\", \"0.4 m/s\"]\n");
  ASSERT_EQ(run({"study.toml", "-o", "one", "--jobs", "1"}), Exit::ok) << err_.str();
  EXPECT_EQ(run({"study.toml", "-o", "two", "--members", "2:4"}), Exit::ok) << err_.str();
  EXPECT_EQ(err_.str(), "2 members, of which 0 were there before\n");
  EXPECT_FALSE(fs::exists("two/table.csv"));
  EXPECT_EQ(run({"study.toml", "-o", "two", "--members", "1:3"}), Exit::ok);
  EXPECT_EQ(err_.str(), "2 members, of which 1 were there before\n");
  EXPECT_EQ(run({"study.toml", "-o", "two", "--jobs", "3"}), Exit::ok);
  EXPECT_EQ(table("one"), table("two"));
  EXPECT_EQ(test::read_text("one/table.h5"), test::read_text("two/table.h5"));
  EXPECT_EQ(test::read_text("one/report.html"), test::read_text("two/report.html"));
}

TEST_F(StudyCommand, AStudyMayGrowButNotChange) {
  write("seeds = 2\n");
  ASSERT_EQ(run({"study.toml"}), Exit::ok) << err_.str();
  write("seeds = 3\n");
  ASSERT_EQ(run({"study.toml"}), Exit::ok) << err_.str();
  EXPECT_EQ(results("runs/study"), 3);
  EXPECT_EQ(test::read_text("runs/study/study.toml"), test::read_text("study.toml"));
  write("seeds = 1\n");
  EXPECT_EQ(run({"study.toml"}), Exit::usage);
  EXPECT_EQ(
      err_.str(),
      "mesopix: -o: runs/study holds another study; seeds was 3 and is 1; choose another folder with -o; a "
      "study may only grow: more seeds, levels or samples\n");
  write("seeds = 3\n");
  test::write_text("scene.toml", test::read_text("scene.toml") + "[solver]\ncfl = 0.7\n");
  EXPECT_EQ(run({"study.toml"}), Exit::usage);
  EXPECT_THAT(err_.str(), HasSubstr("scene solver.cfl was not given and is 0.7"));
}

TEST_F(StudyCommand, SobolGrowsAndALatinHypercubeDoesNot) {
  const auto study = [](const char* sampling, int samples) {
    write("sampling = \"" + std::string(sampling) + "\"\nsamples = " + std::to_string(samples) +
          "\n[vary]\n\"loading.velocity\" = {low = \"0.2 m/s\", high = \"0.4 m/s\"}\n");
  };
  study("sobol", 2);
  ASSERT_EQ(run({"study.toml", "-o", "sobol"}), Exit::ok) << err_.str();
  study("sobol", 3);
  ASSERT_EQ(run({"study.toml", "-o", "sobol"}), Exit::ok) << err_.str();
  EXPECT_EQ(results("sobol"), 3);
  study("latin_hypercube", 2);
  ASSERT_EQ(run({"study.toml", "-o", "cube"}), Exit::ok) << err_.str();
  study("latin_hypercube", 3);
  EXPECT_EQ(run({"study.toml", "-o", "cube"}), Exit::usage);
  EXPECT_THAT(err_.str(),
              HasSubstr("samples was 2 and is 3; a Latin hypercube cannot grow; sampling = \"sobol\" "
                        "can, in another folder with -o\n"));
}

TEST_F(StudyCommand, FailedMembersAreListedAndRunAgainWhenAskedFor) {
  write("[vary]\n\"generate.fraction\" = [0.3, 0.89]\n");
  EXPECT_EQ(run({"study.toml"}), Exit::data);
  EXPECT_THAT(err_.str(), AllOf(HasSubstr("mesopix: member 1 (generate.fraction = 0.89): generate.fraction"),
                                HasSubstr("mesopix: study: 1 of 2 members failed; all reasons are in "
                                          "runs/study/failures; --retry runs them again\n")));
  EXPECT_THAT(table("runs/study"), HasSubstr(",failed,0.89,,,"));
  EXPECT_THAT(test::read_text("runs/study/report.html"), HasSubstr("1 member failed"));
  const auto failure = fs::directory_iterator("runs/study/failures")->path();
  EXPECT_EQ(nlohmann::json::parse(test::read_text(failure.string()))["values"]["generate.fraction"], "0.89");
  const auto before = fs::last_write_time(failure) - std::chrono::hours(1);
  fs::last_write_time(failure, before);
  EXPECT_EQ(run({"study.toml"}), Exit::data);
  EXPECT_EQ(fs::last_write_time(failure), before) << "it was run again";
  EXPECT_EQ(run({"study.toml", "--retry"}), Exit::data);
  EXPECT_NE(fs::last_write_time(failure), before);
}

TEST_F(StudyCommand, TakesAsManySeedsAsTheMeanNeeds) {
  write("seeds = 2\n");
  ASSERT_EQ(run({"study.toml", "--until-ci", "20 %", "-o", "two", "--jobs", "2"}), Exit::ok) << err_.str();
  const std::string at_once = table("two");
  EXPECT_GE(results("two"), 10);
  ASSERT_EQ(run({"study.toml", "--until-ci", "20 %", "-o", "one", "--jobs", "1", "-q"}), Exit::ok);
  EXPECT_THAT(err_.str(), AllOf(StartsWith("warning: "), HasSubstr("members are no slow tests")));
  EXPECT_EQ(table("one"), at_once);
  const std::ptrdiff_t enough = results("one");
  ASSERT_EQ(run({"study.toml", "--until-ci", "20 %", "-o", "one"}), Exit::ok);
  EXPECT_EQ(results("one"), enough);
}

TEST_F(StudyCommand, TellsItsMeanAsJson) {
  write("seeds = 3\n");
  ASSERT_EQ(run({"study.toml", "--members", "0:2", "--json", "-q"}), Exit::ok) << err_.str();
  using nlohmann::json;
  EXPECT_EQ(json::parse(out_.str()),
            (json{{"folder", "runs/study"}, {"members", 2}, {"done", 2}, {"failed", 0}, {"open", 0}}));
  ASSERT_EQ(run({"study.toml", "--json", "-q"}), Exit::ok) << err_.str();
  EXPECT_THAT(err_.str(), StartsWith("warning: 2 of 3 members are no slow tests, such as member 0"));
  const json told = json::parse(out_.str());
  EXPECT_EQ(told["done"], 3);
  EXPECT_GT(told["peak_stress"]["mean_Pa"].get<double>(), 0);
  EXPECT_GT(told["peak_stress"]["half_width_95_Pa"].get<double>(), 0);
  for (const json& file : told["files"]) EXPECT_TRUE(fs::exists(fs::path("runs/study") / file)) << file;
}

TEST_F(StudyCommand, RefusesWhatItCannotWorkWith) {
  write("[vary]\n\"solver.cfl\" = [0.5, 0.8]\n");
  expect_refusal({}, "STUDY: missing; mesopix study STUDY.toml");
  expect_refusal({"study.toml", "--jobs", "0"}, "--jobs: 0; must lie in [1, 1024]");
  expect_refusal({"study.toml", "--until-ci", "2"}, "--until-ci: 2; must lie in (0, 1)");
  expect_refusal({"study.toml", "--until-ci", "2 %"},
                 "--until-ci: 2 %; needs a study with seeds; write seeds = 10 into study.toml");
  expect_refusal({"study.toml", "--until-ci", "2 %", "--members", "0:1"},
                 "--until-ci: given with --members; give one of the two");
  for (const char* range : {"1", "1:3", "1:1", "-1:1", "a:b", ":"})
    expect_refusal({"study.toml", "--members", range},
                   "--members: " + std::string(range) +
                       "; must be I:J with 0 <= I < J <= 2, the number of "
                       "members");
  expect_refusal({"none.toml"}, Exit::io,
                 "none.toml: No such file or directory; must be a file that can be read");
  test::write_text("notes/mine.txt", "");
  fs::create_directory("notes");
  test::write_text("notes/mine.txt", "");
  expect_refusal({"study.toml", "-o", "notes"},
                 "-o: notes; holds something else than a study; choose another folder");
}

}  // namespace study_command_test
