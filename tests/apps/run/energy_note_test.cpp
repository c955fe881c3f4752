#include "apps/run/run_remarks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace energy_note_test {

using testing::HasSubstr;

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

}  // namespace energy_note_test
