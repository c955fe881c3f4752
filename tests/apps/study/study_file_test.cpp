#include "apps/study/study_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "apps/study/study_values.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace study_file_test {

using namespace app;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr const char* seeded = "scene = \"a.toml\"\nseeds = 2\n";

/// Every complaint about a study, a line each.
std::string complaints(const std::string& text) {
  try {
    (void)parse_study(text, "study.toml");
  } catch (const Rejected& rejected) {
    EXPECT_EQ(rejected.code, Exit::data);
    std::string lines;
    for (const Complaint& one : rejected.complaints) lines += app::text(one) + "\n";
    return lines;
  }
  return "";
}

TEST(StudyFile, SaysWhatVaries) {
  const StudyPlan plan = parse_study(
      "title = \"Mine\"\nscene = \"sub/a.toml\"\nseeds = 3\nseed_of = [\"damage\"]\nsampling = \"sobol\"\n"
      "samples = 8\n[vary]\n\"loading.velocity\" = [\"0.1 m/s\", \"0.2 m/s\"]\n"
      "\"generate.width+generate.height\" = {low = \"50 mm\", high = \"100 mm\"}\n"
      "phases.mortar.weibull_modulus = {from = 1, to = 2, steps = 3}\n",
      "folder/study.toml");
  EXPECT_EQ(plan.title, "Mine");
  EXPECT_EQ(plan.scene, "folder/sub/a.toml");
  EXPECT_EQ(plan.sampling, Sampling::sobol);
  EXPECT_EQ(plan.samples, 8);
  EXPECT_THAT(plan.seeds, ElementsAre(1, 2, 3));
  EXPECT_THAT(plan.seed_of, ElementsAre("damage"));
  ASSERT_EQ(plan.parameters.size(), 3U);  // in the order of the file
  EXPECT_EQ(plan.parameters[0].name, "loading.velocity");
  EXPECT_THAT(plan.parameters[0].levels,
              ElementsAre(Value{std::string("0.1 m/s")}, Value{std::string("0.2 m/s")}));
  ASSERT_EQ(plan.parameters[1].fields.size(), 2U);
  EXPECT_TRUE(plan.parameters[1].is_range());
  EXPECT_EQ(plan.parameters[1].low, 0.05);
  EXPECT_EQ(plan.parameters[1].high, 0.1);
  EXPECT_EQ(plan.parameters[2].name, "phases.mortar.weibull_modulus");  // without quotes too
  EXPECT_EQ(number_of(plan.parameters[2], plan.parameters[2].levels[1]), 1.5);
}

TEST(StudyFile, APlanIsWrittenAsItWasRead) {
  for (const char* text :
       {"scene = \"sub/a.toml\"\nseeds = 3\n",
        "title = \"Mine\"\nscene = \"a.toml\"\nsampling = \"latin_hypercube\"\nsamples = 8\n"
        "sampling_seed = 4\nseeds = [7, 2]\nseed_of = [\"damage\"]\n\n[vary]\n"
        "\"generate.width + generate.height\" = {low = \"50 mm\", high = \"80 mm\"}\n"
        "\"motion.flip_ratio\" = [1, 0.9]\n\"loading.platen\" = [\"rough\", \"smooth\"]\n"})
    EXPECT_EQ(plan_text(parse_study(text, "folder/study.toml"), "folder"), text);
  const StudyPlan steps = parse_study(
      "scene = \"a.toml\"\n[vary]\n\"loading.velocity\" = {from = \"0.1 m/s\", to = \"0.3 m/s\", steps = "
      "2}\n",
      "study.toml");
  EXPECT_EQ(plan_text(steps, ""),
            "scene = \"a.toml\"\n\n[vary]\n\"loading.velocity\" = [\"0.1 m/s\", \"0.3 m/s\"]\n");
}

TEST(StudyFile, TakesAListOfSeeds) {
  EXPECT_THAT(parse_study("scene = \"a.toml\"\nseeds = [4, 9]\n", "s.toml").seeds, ElementsAre(4, 9));
}

TEST(StudyFile, RefusesWhatItDoesNotKnow) {
  EXPECT_EQ(complaints(std::string(seeded) + "sampels = 3\n"),
            "study.toml:3:1: sampels: unknown key; did you mean samples?\n");
  EXPECT_EQ(complaints(std::string(seeded) + "[loading]\nvelocity = 1\n"),
            "study.toml:3:2: loading: unknown key; is of the scene; what varies of it stands in [vary]\n");
  EXPECT_EQ(complaints(std::string(seeded) + "[vary]\n\"loading.velocty\" = [1]\n"),
            "study.toml:4:1: vary.loading.velocty: loading.velocty is no key of a scene; did you mean "
            "loading.velocity?\n");
  EXPECT_EQ(complaints(std::string(seeded) + "[vary]\n\"loading.velocty\" = {low = 1, high = 2}\n"),
            "study.toml:4:1: vary.loading.velocty: loading.velocty is no key of a scene; did you mean "
            "loading.velocity?\n");
  EXPECT_EQ(
      complaints(std::string(seeded) + "[vary]\n\"loading.velocity\" = {from = 1, too = 2, steps = 3}\n"),
      "study.toml:4:22: vary.loading.velocity: unknown key too; did you mean to?\n");
  EXPECT_EQ(complaints("scene = \"a.toml\"\nseeds = 2\nseed_of = [\"packing\"]\n"),
            "study.toml:3:11: seed_of: [\"packing\"]; must be damage or generate\n");
}

TEST(StudyFile, RefusesValuesThatTheSceneRefuses) {
  EXPECT_EQ(complaints(std::string(seeded) + "[vary]\n\"loading.velocity\" = [\"0.1 m/s\", \"-2 m/s\"]\n"),
            "study.toml:4:22: vary.loading.velocity: \"-2 m/s\": must be > 0\n");
  EXPECT_EQ(complaints(std::string(seeded) + "[vary]\n\"loading.velocity\" = [0.1]\n"),
            "study.toml:4:22: vary.loading.velocity: 0.1: needs a unit; write e.g. \"0.05 m/s\"\n");
  EXPECT_EQ(complaints(std::string(seeded) + "[vary]\n\"solver.cfl\" = {from = 0.5, to = 2, steps = 3}\n"),
            "study.toml:4:16: vary.solver.cfl: to: 2: must lie in (0, 1]\n");
  EXPECT_EQ(complaints(std::string(seeded) + "[vary]\n\"solver.plane\" = {from = 1, to = 2, steps = 2}\n"),
            "study.toml:4:18: vary.solver.plane: steps and ranges are for numbers; list the values\n");
  EXPECT_EQ(complaints(std::string(seeded) + "[vary]\n\"solver.cfl\" = [0.5, 0.5]\n"),
            "study.toml:4:16: vary.solver.cfl: 0.5 stands there twice; remove one\n");
}

TEST(StudyFile, EndsAtAHundredMistakes) {
  std::string unknown = seeded, values = std::string(seeded) + "[vary]\n";
  for (int i = 0; i < 2000; ++i) {
    unknown += "sampl" + std::to_string(i) + " = 1\n";
    values += "\"loading.velocity" + std::to_string(i) + "\" = [1]\n";
  }
  for (const std::string& text : {unknown, values}) {
    const std::string lines = complaints(text);
    EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), most_complaints);
  }
}

/// Comparing each with all the others would take a minute.
TEST(StudyFile, ReadsAHundredThousandValues) {
  std::string seeds = "scene = \"a.toml\"\nseeds = [0",
              levels = std::string(seeded) + "[vary]\nphases.mortar.weibull_modulus = [1";
  for (int i = 1; i < 100'000; ++i) {
    seeds += "," + std::to_string(i);
    levels += "," + std::to_string(i + 1);
  }
  EXPECT_EQ(parse_study(seeds + "]\n", "study.toml").seeds.size(), 100'000U);
  EXPECT_EQ(parse_study(levels + "]\n", "study.toml").parameters.front().levels.size(), 100'000U);
  EXPECT_NE(complaints(levels + ",7]\n"), "");
}

TEST(StudyFile, RefusesWhatDoesNotGoTogether) {
  EXPECT_EQ(complaints("scene = \"a.toml\"\n"),
            "study.toml: seeds: nothing varies; a study needs seeds, or keys in [vary]; write seeds = 20\n");
  EXPECT_EQ(complaints("seeds = 2\n"),
            "study.toml: scene: missing; must be a scene file; write scene = \"scene.toml\"\n");
  EXPECT_EQ(complaints(std::string(seeded) + "samples = 3\n"),
            "study.toml:3:11: samples: has no effect on a grid; remove it, or choose sampling = \"sobol\"\n");
  EXPECT_EQ(
      complaints(std::string(seeded) + "[vary]\n\"solver.cfl\" = {low = 0.5, high = 0.8}\n"),
      "study.toml:4:16: vary.solver.cfl: a range; a grid needs levels; write {from, to, steps}, or choose "
      "sampling = \"sobol\"\n");
  EXPECT_EQ(complaints("scene = \"a.toml\"\nsampling = \"sobol\"\n[vary]\n\"solver.cfl\" = [0.5]\n"),
            "study.toml:2:12: samples: missing; must be the number of points; write samples = 64\n");
  EXPECT_EQ(complaints(std::string(seeded) + "[vary]\n\"damage.seed\" = [1, 2]\n"),
            "study.toml:4:17: vary.damage.seed: given beside seeds; give one of the two; seed_of says which "
            "tables take the seeds\n");
  EXPECT_EQ(complaints(std::string(seeded) +
                       "[vary]\n\"solver.cfl\" = [0.5]\n\"solver.cfl + handover.strain\" = [0.3]\n"),
            "study.toml:5:1: vary.solver.cfl + handover.strain: solver.cfl varies already; name it once\n");
}

TEST(StudyFile, SeedsAreThoseOfBothRandomFieldsWhereTheSceneHasBoth) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "scene.toml", "[loading]\nvelocity = \"0.1 m/s\"\n");
  test::write_text(folder / "study.toml", "scene = \"scene.toml\"\nseeds = 2\n");
  const Study study = read_study(folder / "study.toml");
  EXPECT_THAT(study.plan.seed_of, ElementsAre("generate", "damage"));
  EXPECT_EQ(study.plan.title, "study");
  test::write_text(folder / "scene.toml",
                   "ellipses = [{x = \"20 mm\", y = \"20 mm\", a = \"5 mm\", b = \"5 mm\"}]\n");
  EXPECT_THAT(read_study(folder / "study.toml").plan.seed_of, ElementsAre("damage"));
}

TEST(StudyFile, RefusesASceneThatIsNotValid) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "scene.toml", "[loading]\nvelocty = \"0.1 m/s\"\n");
  test::write_text(folder / "study.toml", "scene = \"scene.toml\"\nseeds = 2\n");
  EXPECT_THROW((void)read_study(folder / "study.toml"), Rejected);
}

}  // namespace study_file_test
