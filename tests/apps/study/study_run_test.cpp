#include "apps/study/study_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <future>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/study/study_outcome.hpp"
#include "apps/study/study_report.hpp"
#include "apps/study/study_results.hpp"
#include "libmpm/files/result_file.hpp"
#include "libmpm/scene/error.hpp"
#include "tests/apps/small_study.hpp"

namespace study_run_test {

using namespace app;
using testing::HasSubstr;
using testing::Not;

class StudyRun : public testing::Test {
 protected:
  StudyTally run(const std::string& text, int workers, const StudyWatch& watch = {}) {
    study_ = test::small_study(files_, text);
    members_ = list_members(study_);
    folder_.open(study_, members_);
    return run_members(study_, folder_, members_, workers, watch);
  }

  test::TemporaryFolder files_;
  StudyFolder folder_{files_ / "out"};
  Study study_;
  std::vector<Member> members_;
  int told_ = 0;  ///< folders so far
};

TEST_F(StudyRun, WritesAResultAMemberAndSkipsWhatIsThere) {
  StudyTally tally = run("seeds = 3\n", 2);
  EXPECT_EQ(tally.done, 3U);
  EXPECT_EQ(tally.open(), 0U);
  for (const Member& member : members_) EXPECT_TRUE(folder_.has_result(member));
  tally = run("seeds = 4\n", 2);  // the study has grown
  EXPECT_EQ(tally.before, 3U);
  EXPECT_EQ(tally.done, 1U);
}

/// As several machines do.
TEST_F(StudyRun, BeginsInOneFolderForSeveralProgramsAtOnce) {
  study_ = test::small_study(files_, "seeds = 2\n");
  members_ = list_members(study_);
  for (int round = 0; round < 10; ++round) {
    const std::string place = files_ / ("new_" + std::to_string(round));
    if (round % 2 == 1) {  // beside the specimen that it breaks
      std::filesystem::create_directory(place);
      test::write_text(place + "/specimen.h5", "");
    }
    std::vector<std::future<void>> programs;
    for (int i = 0; i < 4; ++i)
      programs.push_back(std::async(std::launch::async, [&] { StudyFolder(place).open(study_, members_); }));
    for (std::future<void>& program : programs) EXPECT_NO_THROW(program.get());
    EXPECT_EQ(test::read_text(place + "/study.toml"), study_.file.text);
    EXPECT_TRUE(std::filesystem::is_directory(place + "/members"));
  }
  for (const auto& entry : std::filesystem::directory_iterator(files_ / ""))
    EXPECT_NE(entry.path().extension(), ".tmp") << entry.path();
}

/// And where it was cut off as it began.
TEST_F(StudyRun, BeginsAgainWhereItWasCutOff) {
  study_ = test::small_study(files_, "seeds = 2\n");
  std::filesystem::create_directories(files_ / "out/members");
  test::write_text(files_ / "out/scene.toml", study_.scene.text);
  test::write_text(files_ / "out/study.toml.1-0.tmp", "see");
  EXPECT_NO_THROW(folder_.open(study_, list_members(study_)));
  test::write_text(files_ / "out/result.h5", "");
  std::filesystem::remove(files_ / "out/study.toml");
  EXPECT_THROW(folder_.open(study_, list_members(study_)), Rejected) << "the run of something else";
}

TEST_F(StudyRun, AMemberIsWhatSimulateMakesOfItsScene) {
  run("seeds = [7]\n", 1);
  const mpm::Result result = mpm::read_result(folder_.result_file(members_[0]).string());
  EXPECT_EQ(mpm::read_scene_text(folder_.result_file(members_[0]).string()),
            member_scene(*members_[0].settings));
  EXPECT_GT(result.peak_stress, 0);
  EXPECT_EQ(result.threads, 1);
}

TEST_F(StudyRun, EndsInOrderWhenItIsStopped) {
  int asked = 0;
  const StudyTally tally = run("seeds = 3\n", 1, {{}, [&] { return ++asked < 20; }});
  EXPECT_EQ(tally.open(), 3U);
  for (const Member& member : members_) {
    EXPECT_FALSE(folder_.has_result(member)) << "half a run is none";
    EXPECT_FALSE(folder_.has_failed(member));
  }
  EXPECT_EQ(run("seeds = 3\n", 1).open(), 0U);
}

TEST_F(StudyRun, AMemberThatFailsIsKeptWithItsReasonAndTheRestGoesOn) {
  // No aggregates of that size fill that much of the specimen.
  const std::string text = "[vary]\n\"generate.fraction\" = [0.3, 0.89, 0.2]\n";
  std::vector<StudyTally> seen;
  const StudyTally tally = run(text, 1, {[&](const StudyTally& now) { seen.push_back(now); }, {}});
  EXPECT_EQ(tally.done, 2U);
  EXPECT_EQ(tally.failed, 1U);
  ASSERT_EQ(seen.size(), 3U);
  EXPECT_EQ(seen[1].failed, 1U);
  EXPECT_THAT(folder_.failure(members_[1]), HasSubstr("generate.fraction"));
  EXPECT_EQ(run(text, 1).before, 3U) << "it is not run again";
  folder_.forget_failure(members_[1]);
  EXPECT_EQ(run(text, 1).failed, 1U);
  const StudyResults results = read_results(folder_, members_);
  EXPECT_EQ(results.count(MemberState::done), 2U);
  EXPECT_EQ(results.count(MemberState::failed), 1U);
  EXPECT_TRUE(std::isnan(results.peak_stress()[1]));
  EXPECT_EQ(results.cracks.members, 2);
}

/// The head of the report speaks of the loading only where all members share it.
TEST_F(StudyRun, ReportsTheLoadingThatAllMembersShare) {
  (void)run("[vary]\n\"generate.fraction\" = [0.3, 0.2]\n", 1);
  write_study_report(folder_, study_, members_, read_results(folder_, members_));
  EXPECT_THAT(test::read_text(folder_.file("report.html").string()), HasSubstr("platens; 2 members"));
}

TEST_F(StudyRun, ReportsNoLoadingWhereMembersDiffer) {
  (void)run("[vary]\n\"loading.velocity\" = [\"0.1 m/s\", \"0.2 m/s\"]\n", 1);
  write_study_report(folder_, study_, members_, read_results(folder_, members_));
  const std::string report = test::read_text(folder_.file("report.html").string());
  EXPECT_THAT(report, HasSubstr("2 members, 2 points"));
  EXPECT_THAT(report, Not(HasSubstr("platens; 2 members")));
}

TEST_F(StudyRun, RefusesScenesThatDoNotGoWithTheSpecimen) {
  study_ = test::small_study(files_, "[vary]\n\"phases.glass.young\" = [\"70 GPa\"]\n");
  members_ = list_members(study_);
  try {
    check_scenes(study_, members_);
    FAIL();
  } catch (const Rejected& rejected) {
    EXPECT_THAT(app::text(rejected.complaints.front()),
                HasSubstr("phases.glass: no such phase, in member 0 (phases.glass.young = 70 GPa)"));
  }
}

TEST_F(StudyRun, AMemberThatDivergesIsAFailure) {
  // Pixels alone in their cells beside a block of mortar bear no such step.
  std::string picture = "P2\n12 12\n2\n";
  for (int row = 0; row < 12; ++row)
    picture += row % 4 == 2 ? "2 2 2 2 2 2 0 2 0 0 0 0\n" : "2 2 2 2 2 2 0 0 0 0 0 0\n";
  test::write_text(files_ / "a.pgm", picture);
  test::write_text(
      files_ / "scene.toml",
      "[specimen]\npicture = \"a.pgm\"\n[convert]\nmethod = \"labels\"\nlabel_phases = [\"0: void\", "
      "\"2: mortar\"]\npixel_size = \"1 mm\"\n[phases.mortar]\npoisson = 0.4999\ntensile_scale = "
      "\"unbreakable\"\n[loading]\nvelocity = \"1 m/s\"\n[solver]\ncell = \"2 x 2\"\nlocal_damping = 0\n");
  test::write_text(files_ / "study.toml", "scene = \"scene.toml\"\n[vary]\n\"solver.cfl\" = [0.4, 1]\n");
  study_ = read_study(files_ / "study.toml");
  members_ = list_members(study_);
  folder_.open(study_, members_);
  const StudyTally tally = run_members(study_, folder_, members_, 2, {});
  EXPECT_EQ(tally.done, 1U);
  EXPECT_EQ(tally.failed, 1U);
  EXPECT_THAT(folder_.failure(members_[1]), HasSubstr("step"));
}

/// In the report, in the figures, and for those who collect what other machines have run.
TEST_F(StudyRun, WarnsOfPicturesThatAreNoConcreteAndOfFastTests) {
  std::string picture = "P2\n12 12\n2\n";
  for (int row = 0; row < 12; ++row) picture += "2 2 2 2 2 2 2 2 0 0 0 0\n";
  test::write_text(files_ / "a.pgm", picture);
  test::write_text(files_ / "scene.toml",
                   "[specimen]\npicture = \"a.pgm\"\n[convert]\nmethod = \"labels\"\nlabel_phases = [\"0: "
                   "void\", \"2: mortar\"]\npixel_size = \"1 mm\"\n[loading]\nvelocity = \"1 m/s\"\n");
  test::write_text(files_ / "study.toml", "scene = \"scene.toml\"\nseeds = 2\n");
  study_ = read_study(files_ / "study.toml");
  members_ = list_members(study_);
  folder_.open(study_, members_);
  (void)run_members(study_, folder_, members_, 2, {});
  const StudyResults results = read_results(folder_, members_);
  std::ostringstream nowhere;
  Console console{nowhere, nowhere, false, true, {}};
  const std::vector<std::string> doubts = close_study(folder_, study_, members_, results, console);
  EXPECT_THAT(doubts, testing::ElementsAre(HasSubstr("33.3 % of the area is void"),
                                           HasSubstr("there is no aggregate"),
                                           HasSubstr("2 of 2 members are no slow tests")));
  EXPECT_EQ(study_json(folder_, study_, members_, results, doubts)["warnings"], doubts);
  EXPECT_THAT(test::read_text(folder_.file("report.html").string()), HasSubstr("33.3 % of the area is void"));
}

TEST_F(StudyRun, AFailureOfTheFirstMemberLeavesAReport) {
  run("[vary]\n\"generate.fraction\" = [0.89, 0.3]\n", 1);
  write_study_report(folder_, study_, members_, read_results(folder_, members_));
  EXPECT_THAT(test::read_text(folder_.file("report.html").string()), HasSubstr("1 member failed"));
}

TEST_F(StudyRun, TellsAFolderApartWhoseMembersAnotherVersionHasNamed) {
  const auto refusal = [&] {
    try {
      folder_.open(study_, members_);
    } catch (const Rejected& rejected) {
      EXPECT_EQ(rejected.code, Exit::data);
      return std::string(rejected.what());
    }
    return std::string();
  };
  run("seeds = 1\n", 1);
  EXPECT_EQ(refusal(), "");
  test::write_text(folder_.file("format.json"), "{\"format\": 3}");
  EXPECT_THAT(refusal(), HasSubstr("holds members kept by a newer version of mesopix"));
  test::write_text(folder_.file("format.json"), "{\"format\": true}");
  EXPECT_THAT(refusal(), HasSubstr("format.json: says no format"));
  std::filesystem::remove(folder_.file("format.json"));
  EXPECT_EQ(refusal(),
            "-o: " + folder_.path().string() +
                "; holds members kept by an older version of mesopix, which have another identity; "
                "run the study anew in a folder of its own, mesopix study " +
                study_.file.path + " -o " + folder_.path().string() +
                "-new; what is in this one, its table too, stays as it is");
  EXPECT_TRUE(folder_.has_result(members_[0]));
  std::filesystem::remove(folder_.result_file(members_[0]));  // nothing is left that could be mixed
  EXPECT_EQ(refusal(), "");
  EXPECT_TRUE(std::filesystem::exists(folder_.file("format.json")));
}

TEST_F(StudyRun, TellsWhatALongStudyTakes) {
  const auto told = [&](const std::string& text) {
    study_ = test::small_study(files_, text);
    members_ = list_members(study_);
    StudyFolder folder(files_ / ("told_" + std::to_string(told_++)));
    folder.open(study_, members_);
    return announcement(folder, members_, check_scenes(study_, members_).sizes, 2);
  };
  EXPECT_EQ(told("seeds = 2\n"), "");
  EXPECT_THAT(told("seeds = 3\n[vary]\n\"loading.velocity\" = [\"1e-5 mm/s\"]\n"),
              testing::ContainsRegex("^3 members of up to [0-9]+ points and [0-9]+ steps, which take "
                                     "(about|up to) .* here, 2 at a time$"));
  EXPECT_EQ(told("seeds = 2\n[vary]\n\"solver.method\" = [\"quasi_static\"]\n"), "");
  // As if those were large.
  const std::vector<RunSize> large(2, {4'000'000, 100'000, true});
  EXPECT_THAT(announcement(StudyFolder(files_ / "large"), members_, large, 2),
              testing::ContainsRegex("^2 members of up to 4000000 points and roughly 100000 states in "
                                     "equilibrium, which take roughly .* here, 2 at a time$"));
}

TEST_F(StudyRun, RefusesAResultThatIsNotThatOfTheMember) {
  run("seeds = 2\n", 1);
  std::filesystem::copy_file(folder_.result_file(members_[0]), folder_.result_file(members_[1]),
                             std::filesystem::copy_options::overwrite_existing);
  EXPECT_THROW((void)read_results(folder_, members_), mpm::FileError);
}

}  // namespace study_run_test
