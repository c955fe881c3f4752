#include "apps/command/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "libmpm/files/result_file.hpp"
#include "tests/apps/fake_run.hpp"
#include "tests/apps/program_in_folder.hpp"

namespace report_command_test {

namespace fs = std::filesystem;
using app::Exit;
using testing::HasSubstr;

/// Runs the program in a folder of its own that holds the runs one, two and other/one.
class ReportCommand : public test::ProgramInFolder {
 protected:
  ReportCommand() : ProgramInFolder("report") {}
  void SetUp() override {
    const FakeRun run = tension_run(30);
    for (const auto& [name, seed] : {std::pair{"one", 1}, {"two", 2}, {"other/one", 3}}) {
      fs::create_directories(name);
      mpm::write_result(std::string(name) + "/result.h5", run.result,
                        "[damage]\nseed = " + std::to_string(seed) + "\n");
    }
  }

  static std::string page(const std::string& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

TEST_F(ReportCommand, LaysRunsOverEachOther) {
  EXPECT_EQ(run({"one", "two/result.h5", "-o", "both.html"}), Exit::ok) << err_.str();
  EXPECT_THAT(err_.str(), HasSubstr("wrote both.html"));
  EXPECT_THAT(page("both.html"), HasSubstr("<th scope=\"col\">one</th><th scope=\"col\">two</th>"));
  EXPECT_THAT(page("both.html"), HasSubstr("damage.seed</th><td>1</td><td>2</td>"));
}

TEST_F(ReportCommand, TellsFiguresAsJsonAndIsQuiet) {
  ASSERT_EQ(run({"one", "two", "--json", "-q"}), Exit::ok) << err_.str();
  EXPECT_EQ(err_.str(), "");
  const auto json = nlohmann::json::parse(out_.str());
  EXPECT_EQ(json["files"], nlohmann::json{"comparison.html"});
  EXPECT_EQ(json["runs"][1]["name"], "two");
  EXPECT_GT(json["runs"][1]["peak_stress_Pa"].get<double>(), 0);
  EXPECT_EQ(json["differences"]["damage.seed"], (nlohmann::json{"1", "2"}));
}

TEST_F(ReportCommand, TellsFoldersOfTheSameNameApart) {
  EXPECT_EQ(run({"one", "other/one"}), Exit::ok) << err_.str();
  EXPECT_THAT(page("comparison.html"), HasSubstr("<th scope=\"col\">other/one</th>"));
}

TEST_F(ReportCommand, RefusesWhatIsNoPairOfRuns) {
  EXPECT_EQ(run({"one", "-o", "one.html"}), Exit::usage);
  EXPECT_EQ(
      err_.str(),
      "mesopix: -o: one.html; is for two runs or more; the report of a single run is report.html in its "
      "folder\n");
  EXPECT_EQ(run({"one"}), Exit::data) << "whose result is of another specimen";
  EXPECT_THAT(err_.str(), HasSubstr("specimen.h5 and result.h5 have other shapes"));
  EXPECT_EQ(run({"one", "one"}), Exit::usage);
  EXPECT_THAT(err_.str(), HasSubstr("must not be given twice"));
  EXPECT_EQ(run(std::vector<std::string>(11, "one")), Exit::usage);
  EXPECT_THAT(err_.str(), HasSubstr("11 given; must be 10 runs at most"));
  EXPECT_FALSE(fs::exists("comparison.html"));
}

TEST_F(ReportCommand, RefusesTheFilesOfTwoRunsInOneFolder) {
  std::ofstream("one/scene.toml") << "[damage]\nseed = 7\n";
  for (const char* name : {"one", "one/result.h5"}) {
    EXPECT_EQ(run({name, "two"}), Exit::data);
    EXPECT_THAT(err_.str(), HasSubstr("one/result.h5: is of another run than one/scene.toml"));
  }
}

TEST_F(ReportCommand, NamesTheRunThatCannotBeRead) {
  EXPECT_EQ(run({"one", "missing"}), Exit::io);
  EXPECT_THAT(err_.str(), HasSubstr("missing"));
  fs::create_directories("empty");
  EXPECT_EQ(run({"one", "empty"}), Exit::io);
  EXPECT_THAT(err_.str(), HasSubstr("empty/result.h5"));
  test::write_text("scene.toml", "[damage]\nseed = 1\n");
  EXPECT_EQ(run({"one", "scene.toml"}), Exit::usage);
  EXPECT_THAT(err_.str(), HasSubstr("must be the folder of a run"));
}

}  // namespace report_command_test
