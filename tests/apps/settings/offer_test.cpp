#include "apps/settings/offer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/text/complaint.hpp"

namespace offer_test {

using app::key_named;
using testing::StrEq;

std::string refusal(const app::Offer& offer, const std::string& name) {
  try {
    return "the key " + key_named(offer, name);
  } catch (const app::Rejected& rejected) {
    EXPECT_EQ(rejected.code, app::Exit::usage);
    return rejected.what();
  }
}

TEST(Offer, KnowsASettingByEachOfItsNames) {
  const app::Offer& simulate = app::offer_of_simulate();
  EXPECT_EQ(key_named(simulate, "velocity"), "loading.velocity");
  EXPECT_EQ(key_named(simulate, "stop_drop"), "loading.stop_drop");
  EXPECT_EQ(key_named(simulate, "stop-drop"), "loading.stop_drop");
  EXPECT_EQ(key_named(simulate, "handover_strain"), "handover.strain");
  EXPECT_EQ(key_named(simulate, "loading.velocity"), "loading.velocity");
  EXPECT_EQ(key_named(simulate, "mortar.tensile_scale"), "phases.mortar.tensile_scale");
  EXPECT_EQ(key_named(simulate, "phases.my-own.young"), "phases.my-own.young");
  EXPECT_EQ(key_named(simulate, "generate.width"), "generate.width");
}

TEST(Offer, TellsCommandsApart) {
  EXPECT_EQ(key_named(app::offer_of_generate(), "seed"), "generate.seed");
  EXPECT_EQ(key_named(app::offer_of_simulate(), "seed"), "damage.seed");
  EXPECT_EQ(key_named(app::offer_of_generate(), "itz_mode"), "itz.mode");
  EXPECT_EQ(key_named(app::offer_of_convert(), "width"), "convert.width");
  EXPECT_EQ(key_named(app::offer_of_calibrate(), "loading.velocity"), "loading.velocity");
}

TEST(Offer, RefusesWhatItHasNot) {
  EXPECT_THAT(refusal(app::offer_of_simulate(), "velocty"),
              StrEq("velocty: unknown option; did you mean velocity?"));
  EXPECT_THAT(refusal(app::offer_of_simulate(), "width"),
              StrEq("width: unknown option; did you mean generate.width?"));
  EXPECT_THAT(refusal(app::offer_of_simulate(), "loading.velocty"),
              StrEq("loading.velocty: unknown option; did you mean loading.velocity?"));
  EXPECT_THAT(refusal(app::offer_of_generate(), "xyzzy"), StrEq("xyzzy: unknown option"));
  EXPECT_THAT(refusal(app::offer_of_generate(), "specimen.file"),
              StrEq("specimen.file: has no effect here; remove it"));
  EXPECT_THAT(refusal(app::offer_of_generate(), "loading.velocity"),
              StrEq("loading.velocity: has no effect here; remove it"));
}

}  // namespace offer_test
