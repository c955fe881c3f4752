#include "apps/run/run_remarks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "apps/text/complaint.hpp"

namespace run_remarks_test {

using testing::HasSubstr;
using testing::StartsWith;

app::RunRemarks sample() {
  app::RunRemarks remarks;
  remarks.notes = {"the scale was guessed", "\"rings\"\nwere drawn"};
  remarks.estimate_error = true;
  remarks.tolerated.sources = {{"time step", "CFL 0.25", 1e6 / 3, 1e-4 / 7, 0.01, 0.02, 3.5}};
  remarks.checkpoint_every = 0.1;
  return remarks;
}

TEST(RunRemarks, AreReadBackAsTheyWere) {
  const app::RunRemarks read = app::parse_remarks(app::remarks_text(sample()), "x");
  EXPECT_EQ(read.notes, sample().notes);
  EXPECT_TRUE(read.estimate_error);
  EXPECT_EQ(read.checkpoint_every, 0.1);
  ASSERT_EQ(read.tolerated.sources.size(), 1U);
  const output::ErrorSource& source = read.tolerated.sources.front();
  EXPECT_EQ(source.name, "time step");
  EXPECT_EQ(source.compared, "CFL 0.25");
  EXPECT_EQ(source.peak_stress, 1e6 / 3);
  EXPECT_EQ(source.peak_strain, 1e-4 / 7);
  EXPECT_EQ(source.stress_error, 0.01);
  EXPECT_EQ(source.strain_error, 0.02);
  EXPECT_EQ(source.wall_time, 3.5);
}

TEST(RunRemarks, RefuseWhatIsNone) {
  for (const char* text : {"", "no", "[]", "{}", R"({"notes": 3, "estimate_error": true})"}) {
    try {
      (void)app::parse_remarks(text, "a.checkpoint");
      ADD_FAILURE() << text;
    } catch (const app::Rejected& rejected) {
      EXPECT_EQ(rejected.code, app::Exit::data);
      EXPECT_THAT(rejected.what(), testing::StartsWith("a.checkpoint: "));
    }
  }
}

std::string note_of(const mpm::Scene& scene, double error) {
  mpm::Result result;
  result.energy_error = error;
  return app::energy_note(result, scene);
}

TEST(EnergyNote, IsSilentWithinWhatIsTolerated) {
  mpm::Scene scene;
  EXPECT_EQ(note_of(scene, 0.0099), "");
  EXPECT_THAT(note_of(scene, 0.011), HasSubstr("off by 1.1 % of the platen work; try a smaller solver.cfl"));
  scene.kinematics = mpm::Kinematics::moving;
  EXPECT_EQ(note_of(scene, 0.0099), "");
  EXPECT_THAT(note_of(scene, 0.011), HasSubstr("1.1 % of the platen work was lost to numerical dissipation"));
}

TEST(EnergyNote, NamesTheChoiceThatLosesEnergy) {
  mpm::Scene scene;
  scene.damage.crack_closure = mpm::CrackClosure::clipped;
  EXPECT_THAT(note_of(scene, 0.05), HasSubstr("\"unilateral\" does"));
  scene = {};
  scene.kinematics = mpm::Kinematics::moving;
  scene.motion.transfer = mpm::Transfer::apic;
  EXPECT_THAT(note_of(scene, 0.5), HasSubstr("motion.transfer = \"flip\""));
  scene.motion.transfer = mpm::Transfer::flip;
  scene.motion.scheme = mpm::Scheme::usl;
  EXPECT_THAT(note_of(scene, 0.5), HasSubstr("\"musl\" or \"usf\" loses less"));
  scene.loading.direction = mpm::Direction::none;
  EXPECT_THAT(note_of(scene, 0.5), HasSubstr("the energy of the flight"));
}

/// A row with both reactions [Pa] and shares of motion and damping in a work of 1 J/m.
mpm::HistoryRow row_of(double strain, double top, double bottom, double kinetic = 0, double damped = 0) {
  mpm::HistoryRow row;
  row.strain = strain;
  row.stress_top = top;
  row.stress_bottom = bottom;
  row.stress = 0.5 * (top + bottom);
  row.platen_work = 1;
  row.kinetic = kinetic;
  row.elastic = 1 - kinetic - damped;
  row.damped = damped;
  return row;
}

mpm::Result result_of(const std::vector<mpm::HistoryRow>& rows, std::size_t peak) {
  mpm::Result result;
  result.history = rows;
  result.peak_stress = rows[peak].stress;
  result.peak_strain = rows[peak].strain;
  return result;
}

std::string inertia_of(const std::vector<mpm::HistoryRow>& rows, std::size_t peak) {
  return app::inertia_note(result_of(rows, peak), {});
}

TEST(InertiaNote, IsSilentNearEquilibrium) {
  EXPECT_EQ(inertia_of({row_of(0, 0, 0), row_of(1e-4, 3e6, 2.9e6, 0.04, 0.04), row_of(2e-4, 1e6, 1e6)}, 1),
            "");
}

TEST(InertiaNote, GivesTheFigureOfEachShare) {
  EXPECT_THAT(inertia_of({row_of(1e-4, 3e6, 1e6)}, 0), HasSubstr("50 % of the reactions of the platens"));
  EXPECT_THAT(inertia_of({row_of(1e-4, 3e6, 3e6, 0.25)}, 0),
              HasSubstr("25 % of the work of the platens is motion"));
  const std::string damped = inertia_of({row_of(1e-4, 3e6, 3e6, 0, 0.5)}, 0);
  EXPECT_THAT(damped, HasSubstr("50 % of it went into local damping"));
  EXPECT_THAT(damped, HasSubstr("or solver.local_damping"));
}

TEST(InertiaNote, CallsNoPeakWhatIsNone) {
  EXPECT_THAT(inertia_of({row_of(1e-4, 3e6, 1e6)}, 0), StartsWith("the largest stress is not that"));
  EXPECT_THAT(inertia_of({row_of(1e-4, 3e6, 1e6), row_of(2e-4, 1e5, 1e5)}, 0),
              StartsWith("the peak is not that"));
}

TEST(InertiaNote, TellsAWaveFromThePeak) {
  EXPECT_THAT(
      inertia_of({row_of(1e-6, 20e6, 0), row_of(1e-4, 3e6, 3e6)}, 1),
      HasSubstr("reaches 10 MPa, at strain 1e-6 and 100 % out of balance, which is a wave and no peak"));
}

TEST(InertiaNote, TellsRingingAfterTheBreak) {
  mpm::HistoryRow broken = row_of(2e-4, 0.1e6, 0.1e6, 0.9);
  broken.tension_failures = 3;
  EXPECT_THAT(inertia_of({row_of(1e-4, 3e6, 3e6), broken, row_of(3e-4, 3.2e6, 3.2e6)}, 2),
              HasSubstr("the specimen had broken before the peak: after 3 MPa at strain 100e-6"));
}

TEST(InertiaNote, IsForExplicitTestsBetweenPlatens) {
  const mpm::Result result = result_of({row_of(1e-4, 3e6, 0)}, 0);
  mpm::Scene scene;
  EXPECT_NE(app::inertia_note(result, scene), "");
  scene.method = mpm::SolverMethod::quasi_static;
  EXPECT_EQ(app::inertia_note(result, scene), "");
  scene = {};
  scene.loading.direction = mpm::Direction::none;
  EXPECT_EQ(app::inertia_note(result, scene), "");
}

mpm::Explanation some_explanation() {
  mpm::Explanation explanation;
  explanation.kinematics = "small strain";
  explanation.bytes = 21;
  explanation.time = 2e-9;
  explanation.features = {{"tension test", true, "a phase can fail", 4, std::nullopt},
                          {"crack closure", false, "damage.crack_closure is off", 4, 1.5e-9},
                          {"local damping", false, "solver.local_damping is 0", 0, -1e-12}};
  return explanation;
}

TEST(Explanation, TellsWhatIsInAndWhatIsLeftOutWithItsPrice) {
  const std::string text = app::explanation_text(some_explanation());
  EXPECT_THAT(text, HasSubstr("small strain: 21 bytes a point, 2.00 ns a point and step"));
  EXPECT_LT(text.find("tension test"), text.find("Left out"));
  EXPECT_GT(text.find("crack closure"), text.find("Left out"));
  EXPECT_THAT(text, HasSubstr("1.50  damage.crack_closure is off"));
}

TEST(Explanation, DoesNotShowNoiseAsAFigure) {
  EXPECT_THAT(app::explanation_text(some_explanation()), HasSubstr("< 0.10  solver.local_damping is 0"));
}

TEST(Explanation, IsCompleteAsJson) {
  const nlohmann::ordered_json json = app::explanation_json(some_explanation());
  EXPECT_EQ(json["bytes_per_point"], 21);
  ASSERT_EQ(json["features"].size(), 3U);
  EXPECT_EQ(json["features"][1]["s_per_point_update"], 1.5e-9);
  EXPECT_EQ(json["features"][0]["in"], true);
  EXPECT_FALSE(json["features"][0].contains("s_per_point_update")) << "not measured";
}

}  // namespace run_remarks_test
