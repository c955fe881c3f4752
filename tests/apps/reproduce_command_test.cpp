#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/evidence_commands.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;
using app::Exit;
using nlohmann::json;
using testing::HasSubstr;

/// Runs the program in a folder of its own.
class ReproduceCommand : public testing::Test {
 protected:
  void SetUp() override { fs::current_path(folder_ / ""); }
  void TearDown() override { fs::current_path(before_); }

  Exit run(std::vector<std::string> arguments) {
    out_.str("");
    err_.str("");
    arguments.insert(arguments.begin(), "reproduce");
    app::Console console{out_, err_, false, false, {}};
    return app::run_program(arguments, console, app::evidence_commands());
  }

  void expect_refusal(const std::vector<std::string>& arguments, const std::string& message) {
    EXPECT_EQ(run(arguments), Exit::usage) << err_.str();
    EXPECT_EQ(err_.str(), "mesopix: " + message + "\n");
    EXPECT_FALSE(fs::exists("runs"));
  }

  std::ostringstream out_;
  std::ostringstream err_;

 private:
  fs::path before_ = fs::current_path();
  test::TemporaryFolder folder_;
};

TEST_F(ReproduceCommand, ReproducesOneFigureOfThePaper) {
  EXPECT_EQ(run({"--figure", "3", "-o", "paper"}), Exit::ok) << err_.str();
  EXPECT_THAT(err_.str(),
              HasSubstr("figure  3, agrees   : The strengths of the points follow a Weibull distribution."));
  EXPECT_TRUE(fs::exists("paper/report.html"));
  EXPECT_EQ(json::parse(test::read_text("paper/reproduction.json"))["figures"].size(), 1U);
  EXPECT_EQ(run({"--figure", "3", "-o", "paper"}), Exit::usage);
  EXPECT_EQ(run({"--figure", "3", "-o", "paper", "--overwrite", "-q"}), Exit::ok);
  EXPECT_EQ(err_.str(), "");
}

TEST_F(ReproduceCommand, RefusesFiguresThatThePaperHasNot) {
  expect_refusal({"--figure", "3", "--figure", "99"},
                 "--figure: 99; must be 1, 2, 3, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14 or objectivity; leave it "
                 "out, or give "
                 "--all, for all of them");
  expect_refusal({"--figure", "3", "--all"}, "--all: given with --figure; give one of the two");
  EXPECT_FALSE(fs::exists("runs"));
}

}  // namespace
