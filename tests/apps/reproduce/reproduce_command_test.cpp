#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "apps/evidence_commands.hpp"
#include "tests/apps/program_in_folder.hpp"

namespace reproduce_command_test {

namespace fs = std::filesystem;
using app::Exit;
using nlohmann::json;
using testing::HasSubstr;

/// Runs the program in a folder of its own.
class ReproduceCommand : public test::ProgramInFolder {
 protected:
  ReproduceCommand() : ProgramInFolder("reproduce", app::evidence_commands()) {}
};

TEST_F(ReproduceCommand, ReproducesOneFigureOfThePaper) {
  EXPECT_EQ(run({"--figure", "3", "-o", "paper"}), Exit::ok) << err_.str();
  EXPECT_THAT(err_.str(),
              HasSubstr("figure  3, agrees   : The strengths of the points follow a Weibull distribution."));
  EXPECT_TRUE(fs::exists("paper/report.html"));
  EXPECT_EQ(json::parse(test::read_text("paper/reproduction.json"))["figures"].size(), 1U);
  EXPECT_EQ(run({"--figure", "3", "-o", "paper"}), Exit::usage);
  EXPECT_EQ(run({"--figure", "3", "-o", "paper", "--overwrite", "-q", "--json"}), Exit::ok);
  EXPECT_EQ(err_.str(), "");
  EXPECT_EQ(json::parse(out_.str()), json::parse(test::read_text("paper/reproduction.json")));
}

TEST_F(ReproduceCommand, RefusesFiguresThatThePaperHasNot) {
  expect_refusal(
      {"--figure", "3", "--figure", "99"},
      "--figure: 99; must be 1, 2, 3, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, objectivity or inertia; leave it "
      "out, or give "
      "--all, for all of them");
  expect_refusal({"--figure", "3", "--all"}, "--all: given with --figure; give one of the two");
  EXPECT_FALSE(fs::exists("runs"));
}

}  // namespace reproduce_command_test
