#include "apps/command/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/apps/program_in_folder.hpp"

namespace simulate_command_test {

namespace fs = std::filesystem;
using app::Exit;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

/// Runs the program in a folder of its own that holds a small scene.
class SimulateCommand : public test::ProgramInFolder {
 protected:
  SimulateCommand() : ProgramInFolder("simulate") {}
  void SetUp() override {
    test::write_text("scene.toml",
                     "[generate]\nwidth = \"32 mm\"\nheight = \"32 mm\"\npixel_size = \"1 mm\"\n"
                     "fraction = 0.3\nd_min = \"4 mm\"\nd_max = \"8 mm\"\n");
  }
};

TEST_F(SimulateCommand, SaysWhereTheRunCanBeWatched) {
  ASSERT_EQ(run({"scene.toml", "--serve", "-q", "-o", "run"}), Exit::ok) << err_.str();
  EXPECT_THAT(err_.str(),
              testing::ContainsRegex("^watch the run at http://127\\.0\\.0\\.1:[0-9]+/[0-9a-f]+/\n$"));
  EXPECT_TRUE(fs::exists("run/report.html"));
}

TEST_F(SimulateCommand, CallsTheLastStressOfARisingCurveNoPeak) {
  ASSERT_EQ(run({"scene.toml", "--stop-strain", "2e-5", "-o", "run"}), Exit::ok) << err_.str();
  EXPECT_THAT(err_.str(),
              HasSubstr("warning: no peak was reached: the stress was still rising at stop_strain, 20"));
  EXPECT_THAT(err_.str(), HasSubstr("no peak, largest stress "));
  EXPECT_THAT(err_.str(), Not(testing::ContainsRegex("(^|\n)peak ")));
  EXPECT_EQ(json::parse(test::read_text("run/summary.json"))["peak_reached"], false);
  EXPECT_THAT(test::read_text("run/report.html"), HasSubstr("Largest stress, no peak"));
}

TEST_F(SimulateCommand, TellsAllThatIsWrongWithASceneAtOnce) {
  test::write_text("scene.toml",
                   "[generate]\nwidth = \"20.3 mm\"\naspect_min = 0.01\n[loading]\nseparation = true\n"
                   "[phases.mortar]\npoisson = 0.5\n");
  EXPECT_EQ(run({"scene.toml", "-o", "run"}), Exit::data);
  for (const char* field :
       {"generate.width", "generate.aspect_min", "loading.separation", "phases.mortar.poisson"})
    EXPECT_THAT(err_.str(), HasSubstr(field));
}

TEST_F(SimulateCommand, EstimatesTheErrorOfItsPeak) {
  ASSERT_EQ(run({"scene.toml", "--estimate-error", "-o", "run"}), Exit::ok) << err_.str();
  EXPECT_THAT(err_.str(), HasSubstr("the peak stress may be wrong by "));
  EXPECT_THAT(err_.str(), HasSubstr("(loading rate "));
  const json figures = json::parse(test::read_text("run/summary.json"));
  const json& estimate = figures["error_estimate"];
  ASSERT_EQ(estimate["sources"].size(), 4U);
  double sum = 0;
  for (const json& source : estimate["sources"]) {
    sum += source["peak_stress_error"].get<double>();
    EXPECT_GT(source["peak_stress_Pa"].get<double>(), 0.5 * figures["peak_stress_Pa"].get<double>());
    EXPECT_GT(source["wall_s"].get<double>(), 0);
  }
  EXPECT_DOUBLE_EQ(estimate["peak_stress_error"].get<double>(), sum);
  const std::string page = test::read_text("run/report.html");
  EXPECT_THAT(page, HasSubstr("<h2>Error of the peak</h2>"));
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">pixel size</th><td>2 mm</td>"));
}

TEST_F(SimulateCommand, LeavesTheEstimateOutWhereNoneWasAskedFor) {
  ASSERT_EQ(run({"scene.toml", "-o", "run"}), Exit::ok) << err_.str();
  EXPECT_FALSE(json::parse(test::read_text("run/summary.json")).contains("error_estimate"));
  EXPECT_THAT(test::read_text("run/report.html"), Not(HasSubstr("Error of the peak")));
}

TEST_F(SimulateCommand, ChoosesWhatAToleranceAsksForAndWritesItDown) {
  ASSERT_EQ(run({"scene.toml", "--tolerance", "10 %", "-o", "run"}), Exit::ok) << err_.str();
  EXPECT_THAT(err_.str(), HasSubstr("a tolerance of 10 % is met at "));
  const json figures = json::parse(test::read_text("run/summary.json"));
  EXPECT_LE(figures["error_estimate"]["peak_stress_error"].get<double>(), 0.1);
  EXPECT_EQ(figures["precision"], "single");
  // The scene that was written is the one that was solved.
  ASSERT_EQ(run({"run/scene.toml", "-o", "again"}), Exit::ok) << err_.str();
  EXPECT_EQ(test::read_text("run/curve.csv"), test::read_text("again/curve.csv"));
}

// A strip one cell high, whose points all have nearly the same strength.
TEST_F(SimulateCommand, BreaksInEquilibriumWithoutASettingOfInertia) {
  test::write_text("still.toml", test::read_text("scene.toml") +
                                     "[loading]\nvelocity = \"0.1 m/s\"\n[solver]\ncfl = 0.4\n"
                                     "method = \"quasi_static\"\ncell = \"pixel\"\n");
  ASSERT_EQ(run({"still.toml", "--estimate-error", "-o", "run"}), Exit::ok) << err_.str();
  EXPECT_THAT(err_.str(), HasSubstr("note: left out, for each has no effect with solver.method = "
                                    "\"quasi_static\": loading.velocity and solver.cfl\n"));
  const json figures = json::parse(test::read_text("run/summary.json"));
  EXPECT_EQ(figures["method"], "quasi_static");
  EXPECT_EQ(figures["cell"], "pixel");
  EXPECT_FALSE(figures.contains("velocity_m_per_s"));
  EXPECT_LT(figures["energy_error"].get<double>(), 1e-9);
  EXPECT_EQ(figures["error_estimate"]["sources"].size(), 2U);
  EXPECT_THAT(test::read_text("run/scene.toml"), Not(HasSubstr("velocity")));
  EXPECT_THAT(test::read_text("run/report.html"), HasSubstr("Quasi-static tension, smooth platens"));
  ASSERT_EQ(run({"run/scene.toml", "-o", "again"}), Exit::ok) << err_.str();
  EXPECT_EQ(test::read_text("run/curve.csv"), test::read_text("again/curve.csv"));
  // On the command line such a setting is a mistake.
  EXPECT_EQ(run({"still.toml", "--local-damping", "0.2", "-o", "third"}), Exit::usage);
  EXPECT_EQ(run({"still.toml", "--tolerance", "2 %", "-o", "third"}), Exit::usage);
}

TEST_F(SimulateCommand, SaysWhenNothingCarriesLoadAnyMore) {
  test::write_text(
      "strip.pgm", "P2\n16 2\n255\n" + [] {
        std::string values;
        for (int i = 0; i < 32; ++i) values += "2\n";
        return values;
      }());
  test::write_text("strip.toml",
                   "[specimen]\npicture = \"strip.pgm\"\n[convert]\nmethod = \"labels\"\nwidth = \"16 mm\"\n"
                   "label_phases = [\"2: mortar\"]\n[itz]\nmode = \"none\"\n[phases.mortar]\n"
                   "weibull_modulus = 100\n[loading]\nvelocity = \"20 m/s\"\nstop_strain = 0.05\n"
                   "[solver]\ncell = \"2 x 2\"\nlocal_damping = 0\n");
  ASSERT_EQ(run({"strip.toml", "-o", "run"}), Exit::ok) << err_.str();
  EXPECT_THAT(err_.str(),
              HasSubstr("note: nothing carries load any more: every point has failed; the run ended at"));
  const json figures = json::parse(test::read_text("run/summary.json"));
  EXPECT_EQ(figures["nothing_carries"], true);
  EXPECT_EQ(figures["tension_failures"], 32);
}

TEST_F(SimulateCommand, KeepsWhatTheDiskTakesAndNamesTheRest) {
  fs::create_directories("run/report.html/in the way");
  fs::create_directories("run/curve.png/in the way");
  test::write_text("run/frames", "a file");
  ASSERT_EQ(run({"scene.toml", "-o", "run", "--overwrite", "--frames", "2", "--json"}), Exit::io);
  EXPECT_GT(json::parse(out_.str())["peak_stress_Pa"], 0) << "what was computed is told all the same";
  EXPECT_TRUE(fs::exists("run/result.h5"));
  EXPECT_TRUE(fs::exists("run/damage_150.png"));
  EXPECT_THAT(err_.str(), testing::StartsWith("warning: run/frames: cannot be created: "));
  EXPECT_THAT(err_.str(), HasSubstr("; the run goes on\n"));
  EXPECT_THAT(err_.str(), HasSubstr("\nmesopix: run/frames: cannot be created: "));
  EXPECT_THAT(err_.str(), HasSubstr("; 3 of 3 frames are missing\n"));
  EXPECT_THAT(err_.str(), HasSubstr("\nmesopix: run/report.html: cannot be written: "));
  EXPECT_THAT(err_.str(), HasSubstr("\nmesopix: run/curve.png: cannot be written: "));
  EXPECT_THAT(err_.str(), Not(HasSubstr("wrote run")));
}

TEST_F(SimulateCommand, RefusesWhatDoesNotGoTogether) {
  expect_refusal({"scene.toml", "--port", "8080"}, Exit::usage,
                 "--port: 8080; is for --serve, which is not given; add --serve");
  expect_refusal({"scene.toml", "--serve", "--port", "70000"}, Exit::usage,
                 "--port: 70000; must lie in [1, 65535]");
  expect_refusal({"scene.toml", "--tolerance", "1"}, Exit::usage, "--tolerance: 1; must lie in (0, 1)");
  expect_refusal({"scene.toml", "--tolerance", "1 %", "--estimate-error"}, Exit::usage,
                 "--tolerance: given with --estimate-error; give one of the two");
  expect_refusal({"scene.toml", "--explain", "--estimate-error"}, Exit::usage,
                 "--estimate-error: given with --explain; give one of the two");
  expect_refusal({"scene.toml", "--explain", "--serve"}, Exit::usage,
                 "--serve: given with --explain; give one of the two");
  expect_refusal({"scene.toml", "--print-scene", "--tolerance", "1 %"}, Exit::usage,
                 "--tolerance: given with --print-scene; give one of the two");
  expect_refusal({"scene.toml", "--estimate-error", "--kinematics", "moving", "--direction", "none",
                  "--duration", "1 us", "--initial-velocity-y", "-1 m/s"},
                 Exit::usage,
                 "--estimate-error: there are no platens; needs a test in tension or compression");
}

}  // namespace simulate_command_test
