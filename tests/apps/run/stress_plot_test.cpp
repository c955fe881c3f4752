#include "apps/run/stress_plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "apps/run/frame_folder.hpp"
#include "apps/text/complaint.hpp"
#include "libmpm/files/frame_file.hpp"
#include "tests/apps/drawn.hpp"
#include "tests/apps/fake_run.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace stress_plot_test {

using app::Exit;
using testing::HasSubstr;

/// What is refused, and how.
template <class Act>
std::string refusal(Exit code, Act act) {
  try {
    act();
  } catch (const app::Rejected& rejected) {
    EXPECT_EQ(rejected.code, code);
    return text(rejected.complaints.front());
  }
  return "nothing";
}

TEST(ReadRange, TakesOneUnitOrTwo) {
  const auto expect = [](const std::string& text, double low, double high) {
    const output::ColourScale range = app::read_range(text);
    EXPECT_DOUBLE_EQ(range.low, low) << text;
    EXPECT_DOUBLE_EQ(range.high, high) << text;
  };
  expect("-5:5 MPa", -5, 5);
  expect("-5e0:5MPa", -5, 5);
  expect("-800 kPa : 0.5 MPa", -0.8, 0.5);
  expect("0:1e6 Pa", 0, 1);
  expect("1:2 N/mm2", 1, 2);
}

TEST(ReadRange, RefusesWhatIsNoRange) {
  const auto said = [](const std::string& text) {
    return refusal(Exit::usage, [&] { (void)app::read_range(text); });
  };
  EXPECT_EQ(said("5 MPa"), "--range: 5 MPa; must be two pressures, like \"-5:5 MPa\"");
  EXPECT_EQ(said("5:-5 MPa"), "--range: 5:-5 MPa; the second must be larger than the first");
  EXPECT_THAT(said("5:5 MPa"), HasSubstr("must be larger"));
  for (const char* wrong : {"0:5", "0:5 mm", ":5 MPa", "0: MPa", "0:nan MPa", "0:1:2 MPa", ":", "a:b"})
    EXPECT_THAT(said(wrong), HasSubstr("--range: ")) << wrong;
}

/// A run of four pixels with its peak at a strain of 1e-4, and frames at 0, 6e-5 and 12e-5 (and extra ones).
class StressPlot : public testing::Test {
 protected:
  StressPlot() {
    const FakeRun fake = still_run({"22", "20"});
    run_.specimen = fake.specimen;
    run_.scene = fake.scene;
    run_.scene.phases.resize(4);
    run_.result = fake.result;
    run_.result.peak_strain = 1e-4;
    run_.result.peak_stress = 1e6;
    run_.result.history = {{}, {.strain = 1e-4, .stress = 1e6}, {.strain = 1.2e-4, .stress = 5e5}};
  }
  void write(const std::vector<mpm::Frame>& frames) {
    app::FrameFolder folder(run_folder_, run_.scene);
    for (const mpm::Frame& frame : frames) folder.add(frame);
  }
  static mpm::Frame frame_at(double strain, std::int64_t row = 0) {
    mpm::Frame frame{.strain = strain, .row = row, .points = {}};
    for (std::uint32_t id = 0; id < 3; ++id) frame.points.push_back({.id = id, .syy = 1e6 * strain});
    return frame;
  }
  [[nodiscard]] app::StressPlot plot(double strain) const {
    return app::stress_plot(run_, run_folder_, strain, output::StressComponent::yy, {});
  }
  [[nodiscard]] std::string refused() const {
    return refusal(Exit::data, [this] { (void)plot(0); });
  }

  app::ReadRun run_;
  test::TemporaryFolder folder_;
  std::filesystem::path run_folder_ = folder_ / "";
};

TEST_F(StressPlot, TakesTheFrameThatIsNearestAndSaysItsStrain) {
  write({frame_at(0), frame_at(6e-5, 1), frame_at(12e-5, 2)});
  EXPECT_THAT(plot(0).words, HasSubstr("p_000000.hdf, at 0 microstrain"));
  EXPECT_EQ(plot(6.1e-5).words, "p_000001.hdf, at 60.0 microstrain, 60.0\u00A0% of the peak strain");
  EXPECT_THAT(plot(8.9e-5).words, HasSubstr("p_000001.hdf"));
  EXPECT_THAT(plot(9.1e-5).words, HasSubstr("p_000002.hdf"));
  EXPECT_TRUE(test::says(plot(1e-4).drawing, "120 microstrain, 120.0\u00A0% of the peak strain"));
}

TEST_F(StressPlot, DrawsPointsInTheirPixelsUntilTheyMove) {
  mpm::Frame frame = frame_at(0, 1);
  for (mpm::FramePoint& point : frame.points) point.x = point.y = 0.5e-3;  // all of them over each other
  write({frame});
  const auto name_of_white = [this] { return test::drawn<output::Words>(plot(0).drawing).back().text; };
  EXPECT_EQ(name_of_white(), "void");
  run_.result.history[1].moving_points = 3;
  EXPECT_EQ(name_of_white(), "no material");
}

TEST_F(StressPlot, NamesTheStressAfterTheLoading) {
  write({frame_at(0)});
  EXPECT_THAT(plot(0).drawing.title, HasSubstr("direction of loading"));
  run_.scene.loading.direction = mpm::Direction::none;
  EXPECT_THAT(plot(0).drawing.title, HasSubstr("vertical stress"));
}

TEST_F(StressPlot, AsksForFramesWhereThereAreNone) {
  EXPECT_EQ(refused(), "RUN: " + run_folder_.string() +
                           "; has no frames, which hold the stress; run it again with --frames 40");
}

TEST_F(StressPlot, RefusesFramesOfOtherRuns) {
  const std::string file = (run_folder_ / "frames" / "p_000000.hdf").string();
  for (const std::int64_t row : {-1, 3}) {
    write({frame_at(0, row)});
    EXPECT_THAT(refused(), HasSubstr(file + ": is no frame of this run"));
  }
  mpm::Frame frame = frame_at(0);
  frame.points.back().id = 4;
  write({frame});
  EXPECT_THAT(refused(), HasSubstr("is no frame of this run"));
  run_.scene.extra_points.resize(1);
  EXPECT_EQ(refused(), "nothing");
}

TEST_F(StressPlot, RefusesStressesThatAreNoNumbers) {
  mpm::Frame frame = frame_at(0);
  frame.points.back().sxy = std::numeric_limits<double>::quiet_NaN();
  write({frame});
  EXPECT_THAT(refused(), HasSubstr("holds a stress that is no number"));
}

}  // namespace stress_plot_test
