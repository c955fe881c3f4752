#include "apps/calibrate/free_parameters.hpp"

#include <gtest/gtest.h>

#include "apps/text/complaint.hpp"

namespace free_parameters_test {

using app::FreeParameter;
using app::Settings;

/// A scene that holds aggregate, mortar and ITZ, as far as names go.
mpm::Scene scene_of(const Settings& settings) {
  mpm::Scene scene;
  scene.phases.emplace_back();  // void
  for (const mpm::Phase& phase : settings.phases) scene.phases.emplace_back(phase);
  return scene;
}

std::vector<FreeParameter> parse(const std::string& text, const Settings& settings = {}) {
  return app::parse_free(text, settings, scene_of(settings));
}

std::vector<std::string> keys(const FreeParameter& parameter) {
  std::vector<std::string> result;
  for (const app::ScaledSetting& setting : parameter.settings) result.push_back(setting.field.key);
  return result;
}

std::string complaint_about(const std::string& text) {
  try {
    (void)parse(text);
    return "accepted";
  } catch (const app::Rejected& rejected) {
    EXPECT_EQ(rejected.code, app::Exit::usage);
    return rejected.what();
  }
}

TEST(FreeParameters, AreKeysWithOrWithoutTheirTable) {
  const auto parameters = parse("mortar.tensile-scale, phases.itz.young,loading.velocity");
  ASSERT_EQ(parameters.size(), 3u);
  EXPECT_EQ(keys(parameters[0]), std::vector<std::string>{"phases.mortar.tensile_scale"});
  EXPECT_EQ(keys(parameters[1]), std::vector<std::string>{"phases.itz.young"});
  EXPECT_EQ(keys(parameters[2]), std::vector<std::string>{"loading.velocity"});
  EXPECT_EQ(parameters[0].settings[0].start, 15e6);
  EXPECT_DOUBLE_EQ(parameters[0].low, 0.05);
  EXPECT_DOUBLE_EQ(parameters[0].high, 20);
}

TEST(FreeParameters, APropertyAloneIsThatOfEveryPhaseWhereItMatters) {
  const auto parameters = parse("tensile_scale,weibull_modulus,young");
  ASSERT_EQ(parameters.size(), 3u);
  EXPECT_EQ(keys(parameters[0]),
            (std::vector<std::string>{"phases.mortar.tensile_scale", "phases.itz.tensile_scale"}));
  EXPECT_EQ(keys(parameters[1]),
            (std::vector<std::string>{"phases.mortar.weibull_modulus", "phases.itz.weibull_modulus"}));
  EXPECT_EQ(parameters[2].settings.size(), 3u);
}

TEST(FreeParameters, ScaleTogetherAndKeepTheirRatios) {
  Settings settings;
  const auto parameters = parse("mortar.tensile_scale+itz.tensile_scale", settings);
  ASSERT_EQ(parameters.size(), 1u);
  app::scale(settings, parameters, {0.5});
  EXPECT_EQ(app::phase_named(settings, "mortar").tensile_scale, 7.5e6);
  EXPECT_EQ(app::phase_named(settings, "itz").tensile_scale, 4.5e6);
}

TEST(FreeParameters, AreSetToTheFiveDigitsThatAreWritten) {
  Settings settings;
  const auto parameters = parse("mortar.young", settings);
  app::scale(settings, parameters, {1.0 / 3});
  EXPECT_EQ(app::phase_named(settings, "mortar").young, 6.6667e9);
  EXPECT_EQ(parameters[0].settings[0].text(1.0 / 3), "6.6667 GPa");
}

TEST(FreeParameters, HaveBoundsThatTheUserAndTheSettingAllow) {
  const auto given = parse("mortar.young+itz.young=10 GPa..30 GPa");
  EXPECT_DOUBLE_EQ(given[0].low, 0.5);
  EXPECT_DOUBLE_EQ(given[0].high, 1.5);
  const auto poisson = parse("mortar.poisson");
  EXPECT_LT(poisson[0].settings[0].value(poisson[0].high), 0.5);
  EXPECT_GT(poisson[0].settings[0].value(poisson[0].high), 0.499);
}

TEST(FreeParameters, TellWhenTheyAreAtABound) {
  const FreeParameter parameter = parse("mortar.young=10 GPa..30 GPa")[0];
  EXPECT_TRUE(app::is_at_low_bound(parameter, 0.502));
  EXPECT_FALSE(app::is_at_low_bound(parameter, 0.6));
  EXPECT_TRUE(app::is_at_high_bound(parameter, 1.49));
  EXPECT_FALSE(app::is_at_high_bound(parameter, 1.4));
}

TEST(FreeParameters, RefuseMisspeltNames) {
  EXPECT_EQ(complaint_about("mortar.tensile_scal"),
            "--free: mortar.tensile_scal; unknown key; did you mean phases.mortar.tensile_scale?");
  EXPECT_EQ(complaint_about("mortr.young"),
            "--free: mortr.young; the specimen has aggregate, mortar and itz; did you mean mortar?");
  EXPECT_EQ(complaint_about("yuong"), "--free: yuong; unknown key; did you mean young?");
  EXPECT_EQ(complaint_about("loading.velocty"),
            "--free: loading.velocty; unknown key; did you mean loading.velocity?");
  EXPECT_EQ(complaint_about("young,"),
            "--free: must be a key, or several with commas between them; write e.g. "
            "tensile_scale,mortar.young");
}

TEST(FreeParameters, RefuseWhatCannotBeScaled) {
  EXPECT_EQ(complaint_about("damage.seed"), "--free: damage.seed; is no quantity that can be scaled");
  const std::string allowed = "; no property of the model; must be a quantity of phases, loading or damage";
  EXPECT_EQ(complaint_about("solver.cfl"), "--free: solver.cfl" + allowed);
  EXPECT_EQ(complaint_about("generate.width"), "--free: generate.width" + allowed);
  EXPECT_EQ(complaint_about("loading.stop_strain"), "--free: loading.stop_strain" + allowed);
  EXPECT_EQ(complaint_about("aggregate.tensile_scale"),
            "--free: aggregate.tensile_scale; is unbreakable in the scene; must be a number > 0, as it is "
            "scaled; give a value in the scene to begin with");
  EXPECT_EQ(complaint_about("young,mortar.young"),
            "--free: phases.mortar.young; is free twice; name it once");
}

TEST(FreeParameters, RefuseBoundsThatAreNone) {
  EXPECT_EQ(complaint_about("mortar.young=10..30"),
            "--free: mortar.young=10..30; bounds: needs a unit; write e.g. mortar.young=10 GPa..40 GPa");
  EXPECT_EQ(complaint_about("mortar.young=10 GPa"),
            "--free: mortar.young=10 GPa; bounds: must be a pressure, e.g. \"20 GPa\"; write e.g. "
            "mortar.young=10 GPa..40 GPa");
  EXPECT_EQ(complaint_about("mortar.young=30 GPa..10 GPa"),
            "--free: mortar.young=30 GPa..10 GPa; bounds must be > 0 and rise; the lower one comes first");
  EXPECT_EQ(complaint_about("mortar.poisson=3..4"),
            "--free: mortar.poisson=3..4; leaves no room for phases.mortar.poisson; give it other bounds "
            "with =LOW..HIGH");
}

}  // namespace free_parameters_test
