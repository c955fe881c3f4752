#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "apps/evidence_commands.hpp"
#include "tests/apps/program_in_folder.hpp"

namespace bench_command_test {

namespace fs = std::filesystem;
using app::Exit;
using testing::HasSubstr;

/// Runs the program in a folder of its own.
class BenchCommand : public test::ProgramInFolder {
 protected:
  BenchCommand() : ProgramInFolder("bench", app::evidence_commands()) {}
};

TEST_F(BenchCommand, ShellsCompleteWhatItMeasures) {
  EXPECT_EQ(call({"complete", "bench", ""}), app::Exit::ok);
  EXPECT_EQ(out_.str(), "error\nstability\nfeatures\n");
}

TEST_F(BenchCommand, WritesErrorsAgainstRunTime) {
  ASSERT_EQ(run({"error", "--problem", "flight"}), Exit::ok) << err_.str();
  EXPECT_THAT(out_.str(), HasSubstr("flight            5 %   "));
  EXPECT_EQ(err_.str(), "wrote runs/bench-error\n");
  const std::string csv = test::read_text("runs/bench-error/error.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 10 * 3);
  EXPECT_THAT(test::read_text("runs/bench-error/error_vs_time.html"),
              HasSubstr("<h1>Error against run time</h1>"));
  EXPECT_EQ(test::read_text("runs/bench-error/flight.png").substr(1, 3), "PNG");
  ASSERT_EQ(run({"error", "--problem", "flight", "-q", "--overwrite", "-o", "runs/bench-error"}), Exit::ok);
  EXPECT_EQ(out_.str() + err_.str(), "");
  ASSERT_EQ(run({"error", "--problem", "flight", "-q", "--json", "-o", "json"}), Exit::ok);
  EXPECT_EQ(err_.str(), "");
  const auto samples = nlohmann::json::parse(out_.str());
  EXPECT_EQ(samples.size(), 10U * 3U);
  EXPECT_EQ(samples[0]["problem"], "flight");
}

TEST_F(BenchCommand, RefusesWhatItDoesNotKnow) {
  expect_refusal({}, "WHAT: missing; must be error, stability or features; mesopix bench error");
  expect_refusal({"errors"}, "WHAT: errors; must be error, stability or features; did you mean error?");
  expect_refusal(
      {"error", "--problem", "bars"},
      "--problem: bars; must be tension, modulus, bar, manufactured, inclusion, hole, layers, spin, "
      "collision or flight; did you mean bar?");
  expect_refusal({"features", "--problem", "bar"},
                 "--problem: given with features; belongs to mesopix bench error");
  expect_refusal({"error", "--case", "contrast"},
                 "--case: given with error; belongs to mesopix bench stability");
  expect_refusal({"error", "--cases", "bar"},
                 "--cases: unknown option; did you mean --case?; mesopix bench --help lists them");
}

TEST_F(BenchCommand, RunsCasesOfStability) {
  ASSERT_EQ(run({"stability", "--case", "contrast", "--case", "extreme-draws"}), Exit::ok) << err_.str();
  EXPECT_THAT(out_.str(), HasSubstr("contrast"));
  EXPECT_EQ(err_.str(), "wrote runs/bench-stability\n");
  const std::string csv = test::read_text("runs/bench-stability/stability.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
  ASSERT_EQ(run({"stability", "--case", "contrast", "--json", "-o", "json"}), Exit::ok);
  EXPECT_TRUE(nlohmann::json::parse(out_.str())[0]["holds"].get<bool>());
  EXPECT_THAT(test::read_text("runs/bench-stability/stability.html"), HasSubstr("extreme-draws"));
}

TEST_F(BenchCommand, MakesNoFolderForACaseThatIsNotThere) {
  EXPECT_EQ(run({"stability", "--case", "contrasts"}), Exit::usage);
  EXPECT_THAT(err_.str(), HasSubstr("did you mean contrast?"));
  EXPECT_FALSE(fs::exists("runs"));
}

}  // namespace bench_command_test
