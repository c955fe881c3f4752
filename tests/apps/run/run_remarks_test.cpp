#include "apps/run/run_remarks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "apps/text/complaint.hpp"

namespace run_remarks_test {

using testing::HasSubstr;

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
  EXPECT_EQ(note_of(scene, 0.099), "");
  EXPECT_THAT(note_of(scene, 0.11), HasSubstr("11 % of the platen work was lost to numerical dissipation"));
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
