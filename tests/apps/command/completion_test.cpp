/// What shells are told to complete.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/program_in_folder.hpp"

namespace completion_test {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;
using testing::StartsWith;

class Completion : public test::ProgramInFolder {
 protected:
  std::vector<std::string> lines(std::vector<std::string> words) {
    words.insert(words.begin(), "complete");
    EXPECT_EQ(call(words), app::Exit::ok);
    std::vector<std::string> found;
    std::istringstream stream(out_.str());
    for (std::string line; std::getline(stream, line);) found.push_back(line);
    return found;
  }

  /// Without what is said of them.
  std::vector<std::string> words(const std::vector<std::string>& typed) {
    std::vector<std::string> found = lines(typed);
    for (std::string& line : found) line = line.substr(0, line.find('\t'));
    return found;
  }
};

TEST_F(Completion, TellsCommandsWithWhatTheyDo) {
  EXPECT_THAT(lines({""}), Contains(StartsWith("simulate\tBreak a specimen")));
  EXPECT_THAT(words({}), AllOf(IsSupersetOf({"generate", "help"}), Not(Contains("complete"))));
  EXPECT_THAT(words({"study", ""}), ElementsAre("submit", "status", "collect", "@files toml"));
  EXPECT_THAT(words({"help", ""}), IsSupersetOf({"simulate", "submit", "help"}));
}

TEST_F(Completion, TellsOptionsByTheNamesOfTheHelp) {
  EXPECT_THAT(lines({"simulate", "-"}), Contains("--quiet\tsay nothing but errors"));
  EXPECT_THAT(words({"simulate", "--pl"}),
              AllOf(IsSupersetOf({"-o", "--output", "--platen"}), Not(Contains("--loading.platen")),
                    Not(Contains("--generate.width"))));
  EXPECT_THAT(words({"study", "submit", "--s"}), AllOf(Contains("--slurm"), Not(Contains("--until-ci"))));
}

TEST_F(Completion, TellsNamesByKeyOnceADotIsTyped) {
  EXPECT_THAT(words({"simulate", "--loading."}),
              IsSupersetOf({"--platen", "--loading.platen", "--generate.width"}));
}

TEST_F(Completion, WritesOptionsOfPhasesOut) {
  EXPECT_THAT(words({"simulate", "--"}),
              AllOf(IsSupersetOf({"--mortar.young", "--itz.tensile-scale", "--aggregate.density"}),
                    Each(Not(StartsWith("--PHASE")))));
  EXPECT_THAT(lines({"simulate", "--m"}), Contains("--mortar.young\tYoung's modulus of mortar"));
}

TEST_F(Completion, OffersAnOptionOnceUnlessItAddsToThoseBefore) {
  EXPECT_THAT(words({"simulate", "-q", "--platen", "rough", "--"}),
              AllOf(Not(Contains("--quiet")), Not(Contains("--platen"))));
  EXPECT_THAT(words({"simulate", "--set", "loading.platen=rough", "--"}), Contains("--set"));
  EXPECT_THAT(words({"study", "submit", "--sbatch", "a", "--"}), Contains("--sbatch"));
}

TEST_F(Completion, TellsTheWordsThatAnOptionTakes) {
  EXPECT_THAT(words({"simulate", "--platen", ""}), ElementsAre("smooth", "rough"));
  EXPECT_THAT(words({"simulate", "--loading.platen", "r"}), ElementsAre("smooth", "rough"));
  EXPECT_THAT(words({"simulate", "--mortar.fracture-energy", ""}), ElementsAre("brittle"));
  EXPECT_THAT(words({"twin", "--gap", ""}), ElementsAre("auto"));
  EXPECT_THAT(words({"generate", "--grading", ""}), IsSupersetOf({"fuller", "A16"}));
  EXPECT_THAT(words({"plot", "--what", ""}), ElementsAre("damage", "stress", "curve"));
  EXPECT_THAT(words({"simulate", "--velocity", ""}), IsEmpty());
}

TEST_F(Completion, TellsFilesAndFolders) {
  EXPECT_THAT(words({"simulate", "--output", ""}), ElementsAre("@folders"));
  EXPECT_THAT(words({"simulate", "--specimen.picture", ""}),
              ElementsAre("@files png tif tiff jpg jpeg bmp pgm ppm"));
  EXPECT_THAT(words({"simulate", ""}), ElementsAre("@files h5 toml png tif tiff jpg jpeg bmp pgm ppm"));
  EXPECT_THAT(words({"calibrate", "--target", ""}), ElementsAre("@files csv"));
  EXPECT_THAT(words({"report", ""}), ElementsAre("@files h5"));
  EXPECT_THAT(words({"plot", ""}), ElementsAre("@folders"));
  EXPECT_THAT(words({"export", "-o", ""}), ElementsAre("@files"));
}

TEST_F(Completion, TellsKeysBehindSet) {
  EXPECT_THAT(words({"simulate", "--set", ""}),
              IsSupersetOf({"loading.velocity=", "generate.width=", "phases.mortar.tensile_scale="}));
  EXPECT_THAT(words({"generate", "--set", ""}),
              AllOf(Contains("generate.width="), Not(Contains("loading.velocity=")),
                    Not(Contains("specimen.file="))));
}

TEST_F(Completion, TellsWhatStandsBehindAnEqualsSign) {
  EXPECT_THAT(words({"simulate", "--platen=r"}), ElementsAre("smooth", "rough"));
  EXPECT_THAT(words({"simulate", "--set", "loading.platen="}), ElementsAre("smooth", "rough"));
  EXPECT_THAT(words({"simulate", "--set", "phases.itz.fracture_energy="}), ElementsAre("brittle"));
  EXPECT_THAT(words({"simulate", "--set", "loading.separation="}), ElementsAre("true", "false"));
}

}  // namespace completion_test
