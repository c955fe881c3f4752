#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/apps/program_in_folder.hpp"

namespace calibrate_command_test {

namespace fs = std::filesystem;
using app::Exit;
using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

/// Runs the program in a folder of its own that holds a small scene.
class CalibrateCommand : public test::ProgramInFolder {
 protected:
  CalibrateCommand() : ProgramInFolder("calibrate") {}
  void SetUp() override {
    test::write_text("scene.toml",
                     "[generate]\nwidth = \"16 mm\"\nheight = \"16 mm\"\npixel_size = \"1 mm\"\n"
                     "fraction = 0.3\nd_min = \"4 mm\"\nd_max = \"8 mm\"\n");
  }
};

TEST_F(CalibrateCommand, WritesASceneThatReproducesTheFit) {
  ASSERT_EQ(run({"scene.toml", "--peak-stress", "1.5 MPa", "--peak-strain", "80 microstrain", "--seeds", "2",
                 "--json"}),
            Exit::ok)
      << err_.str();
  EXPECT_THAT(err_.str(), HasSubstr("wrote runs/scene-calibration\n"));
  const json found = json::parse(out_.str());
  EXPECT_EQ(found, json::parse(test::read_text("runs/scene-calibration/calibration.json")));
  EXPECT_EQ(found["met"], true);
  EXPECT_NEAR(found["fitted"]["peak_stress_mean_Pa"].get<double>(), 1.5e6, 0.02 * 1.5e6);
  EXPECT_NEAR(found["fitted"]["peak_strain_mean"].get<double>(), 80e-6, 0.02 * 80e-6);
  EXPECT_EQ(found["parameters"][0]["name"], "tensile_scale");
  EXPECT_EQ(found["parameters"][1]["name"], "young");
  EXPECT_EQ(found["fitted"]["runs"].size(), 2u);
  EXPECT_EQ(found["checked_with_further_seeds"]["runs"].size(), 5u);
  const std::string page = test::read_text("runs/scene-calibration/report.html");
  EXPECT_THAT(page, HasSubstr("<h1>Calibration: scene</h1>"));
  EXPECT_THAT(page, HasSubstr("fitted to a peak of 1.5 MPa at strain 80e-6"));

  app::Console console{out_, err_, false, false, {}};
  ASSERT_EQ(app::run_program({"simulate", "runs/scene-calibration/scene.toml", "-o", "again"}, console),
            Exit::ok);
  const json again = json::parse(test::read_text("again/summary.json"));
  EXPECT_EQ(again["peak_stress_Pa"], found["fitted"]["runs"][0]["peak_stress_Pa"]);
  EXPECT_EQ(again["peak_strain"], found["fitted"]["runs"][0]["peak_strain"]);
}

TEST_F(CalibrateCommand, KeepsTheNearestToATargetOutOfReach) {
  EXPECT_EQ(run({"scene.toml", "--peak-stress", "0.1 MPa", "--seeds", "1", "--free",
                 "tensile_scale=12 MPa..20 MPa", "-o", "near"}),
            Exit::data);
  EXPECT_THAT(err_.str(), HasSubstr("mesopix: calibrate: the target, a peak of 0.1 MPa, was not met; "));
  EXPECT_THAT(err_.str(), HasSubstr("at its lower bound of 12 MPa; what was found is in near\n"));
  EXPECT_EQ(json::parse(test::read_text("near/calibration.json"))["met"], false);
  EXPECT_THAT(test::read_text("near/report.html"), HasSubstr("<h2>Not met</h2>"));
  EXPECT_TRUE(fs::exists("near/scene.toml"));
}

TEST_F(CalibrateCommand, FitsItsOwnCurve) {
  app::Console console{out_, err_, false, false, {}};
  ASSERT_EQ(app::run_program({"simulate", "scene.toml", "-o", "measured", "-q"}, console), Exit::ok);
  ASSERT_EQ(run({"scene.toml", "--target", "measured/curve.csv", "--seeds", "1", "-o", "fit"}), Exit::ok)
      << err_.str();
  const json found = json::parse(test::read_text("fit/calibration.json"));
  EXPECT_LT(found["misfit"].get<double>(), 0.005);  // it begins with what the curve was made with
  EXPECT_EQ(found["parameters"][2]["name"], "weibull_modulus");
  EXPECT_NEAR(found["parameters"][0]["factor"].get<double>(), 1, 0.01);
}

TEST_F(CalibrateCommand, RefusesWhatIsNoTarget) {
  const std::string allowed = "a target is --peak-stress, --peak-strain or both, or --target CURVE.csv";
  expect_refusal({"scene.toml"}, Exit::usage, "--target: no target is given; " + allowed);
  expect_refusal({"scene.toml", "--target", "a.csv", "--peak-strain", "1e-4"}, Exit::usage,
                 "--target: given beside a peak; " + allowed);
  expect_refusal({"scene.toml", "--peak-stress", "1.75"}, Exit::usage,
                 "--peak-stress: 1.75; needs a unit; write e.g. \"20 GPa\"");
  expect_refusal({"scene.toml", "--peak-strain", "75"}, Exit::usage, "--peak-strain: 75; must lie in (0, 1)");
  expect_refusal({"scene.toml", "--target", "a.csv"}, Exit::io,
                 "a.csv: No such file or directory; must be a file that can be read");
}

TEST_F(CalibrateCommand, RefusesWhatItCannotWorkWith) {
  expect_refusal({"scene.toml", "--peak-stress", "1 MPa", "--seeds", "0"}, Exit::usage,
                 "--seeds: 0; must lie in [1, 1000]");
  expect_refusal({"scene.toml", "--peak-stress", "1 MPa", "--free", "mortr.young"}, Exit::usage,
                 "--free: mortr.young; the specimen has aggregate, mortar and itz; did you mean mortar?");
  expect_refusal({"scene.toml", "--peak-stress", "1 MPa", "--direction", "none"}, Exit::usage,
                 "--direction: unknown option; mesopix calibrate --help lists them");
  test::write_text("picture.png", "no scene");
  expect_refusal({"picture.png", "--peak-stress", "1 MPa"}, Exit::usage,
                 "SCENE: picture.png; must be a scene, scene.toml; mesopix simulate INPUT --print-scene "
                 "writes one");
}

TEST_F(CalibrateCommand, RefusesASpecimenThatFlies) {
  test::write_text("flight.toml",
                   "[loading]\ndirection = \"none\"\ninitial_velocity_y = \"-3 m/s\"\nduration = \"1 ms\"\n"
                   "[solver]\nkinematics = \"moving\"\n");
  expect_refusal({"flight.toml", "--peak-stress", "1 MPa"}, Exit::data,
                 "flight.toml:2:13: loading.direction: none; must be tension or compression: a peak is that "
                 "of a stress-strain curve between platens");
}

}  // namespace calibrate_command_test
