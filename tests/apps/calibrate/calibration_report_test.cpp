#include "apps/calibrate/calibration_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "apps/calibrate/calibration_folder.hpp"

namespace calibration_report_test {

using app::Calibration;
using app::CalibrationTask;
using app::SeedRun;

class CalibrationWords : public testing::Test {
 protected:
  CalibrationWords() {
    mpm::Scene scene;
    for (const mpm::Phase& phase : app::Settings().phases) scene.phases.emplace_back(phase);
    task_.parameters = app::parse_free("tensile_scale", {}, scene);
    found_.history = {{{1}, 0.7, {3.5e6, 1.5e-4}, app::Figures::Zero(1), false},
                      {{0.5}, 0.004, {1.75e6, 75e-6}, app::Figures::Zero(1), false}};
    found_.best = 1;
    found_.misfit = 0.004;
    found_.run_count = 8;
    found_.wall_time = 1.25;
    found_.runs = {run(1, 1.7e6), run(2, 1.8e6)};
  }

  static SeedRun run(std::uint64_t seed, double stress) { return {seed, stress, 75e-6, {{0, 1e-4}, {0, 1}}}; }

  specimen::Specimen specimen_;
  CalibrationTask task_{{}, specimen_, {1.75e6, {}, {}}, {}};
  Calibration found_;
};

TEST_F(CalibrationWords, TellWhatWasFound) {
  const auto lines = app::outcome_lines(task_, found_);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0],
            "tensile_scale x 0.5: phases.mortar.tensile_scale = 7.5 MPa and phases.itz.tensile_scale = 4.5 "
            "MPa");
  EXPECT_EQ(lines[1],
            "peak 1.75 MPa at strain 75e-6 (seeds 1 to 2; standard deviation 0.07071 MPa and 0e-6)");
  EXPECT_EQ(lines[2], "misfit 0.4 % after 2 evaluations and 8 runs in 1.2 s: the misfit came below 0.5 %");
}

TEST_F(CalibrationWords, TellHowFarTheSearchIs) {
  found_.history.push_back({{0.6}, 0.1, {}, {}, false});
  EXPECT_EQ(app::evaluation_text(task_, found_),
            "evaluation 3   misfit 10.00 %   best 0.40 %   tensile_scale x 0.600");
}

TEST_F(CalibrationWords, NameTheTarget) {
  EXPECT_EQ(app::target_text({1.75e6, {}, {}}), "a peak of 1.75 MPa");
  EXPECT_EQ(app::target_text({{}, 75e-6, {}}), "a peak at strain 75e-6");
  EXPECT_EQ(app::target_text({1.75e6, 75e-6, {}}), "a peak of 1.75 MPa at strain 75e-6");
  EXPECT_EQ(app::target_text({{}, {}, {{0, 1e-4, 2e-4}, {0, 1e6, 0}}}),
            "a curve to strain 200e-6 with its peak of 1 MPa at strain 100e-6");
  EXPECT_EQ(app::target_text({{}, {}, {{0, 1e-4, 2e-4}, {0, 1e6, 2e6}}}),
            "a curve to strain 200e-6 without a peak, largest stress 2 MPa at strain 200e-6");
}

TEST_F(CalibrationWords, DoubtACurveThatEndsBeforeItsPeak) {
  EXPECT_EQ(app::doubt_of({1.75e6, {}, {}}), "");
  EXPECT_EQ(app::doubt_of({{}, {}, {{0, 1e-4, 2e-4}, {0, 1e6, 0}}}), "");
  EXPECT_EQ(
      app::doubt_of({{}, {}, {{0, 1e-4, 2e-4}, {0, 1e6, 2e6}}}),
      "the measured curve has no peak: its stress has not fallen again at its end, 200e-6; what is fitted "
      "is the rise alone, and strengths beyond those found fit it as well");
}

TEST_F(CalibrationWords, WarnOfASpecimenThatIsNoConcrete) {
  const std::string warning = "there is no aggregate";
  specimen_.provenance.source = "photo.png";
  EXPECT_THAT(app::calibration_json(task_, found_)["warnings"].dump(), testing::HasSubstr(warning));
  EXPECT_THAT(app::calibration_html(task_, found_, "", ""), testing::HasSubstr(warning));
  specimen_.provenance.source = "generated";
  EXPECT_TRUE(app::calibration_json(task_, found_)["warnings"].empty());
  EXPECT_THAT(app::calibration_html(task_, found_, "", ""), testing::Not(testing::HasSubstr("Warnings")));
}

TEST_F(CalibrationWords, CountNoRunWithoutAPeak) {
  found_.runs[1].peak_reached = false;
  EXPECT_EQ(app::outcome_lines(task_, found_)[1],
            "peak 1.7 MPa at strain 75e-6 (seeds 1 to 2; without 1 that reached no peak)");
  task_.target.peak_stress = 1.7e6;
  EXPECT_EQ(app::why_not_met(task_, found_), "");
  found_.runs[0].peak_reached = false;
  EXPECT_EQ(
      app::why_not_met(task_, found_),
      "the target, a peak of 1.7 MPa, was not met; the nearest is no peak at all; these parameters alone "
      "do not reach it; free others");
  const auto json = app::calibration_json(task_, found_);
  EXPECT_TRUE(json["fitted"]["runs"][1]["peak_stress_Pa"].is_null());
  EXPECT_EQ(json["fitted"]["runs"][1]["largest_stress_Pa"], 1.8e6);
}

TEST_F(CalibrationWords, ATargetWithinTheScatterOfItsMeanIsMet) {
  EXPECT_EQ(app::why_not_met(task_, found_), "");
  task_.target.peak_stress = 1.85e6;
  EXPECT_EQ(app::why_not_met(task_, found_),
            "the target, a peak of 1.85 MPa, was not met; the nearest is a peak of 1.75 MPa at strain 75e-6; "
            "these parameters alone do not reach it; free others");
  found_.history[1].factors = {0.0501};
  EXPECT_EQ(app::why_not_met(task_, found_),
            "the target, a peak of 1.85 MPa, was not met; the nearest is a peak of 1.75 MPa at strain 75e-6; "
            "phases.mortar.tensile_scale at its lower bound of 0.75 MPa");
}

}  // namespace calibration_report_test
