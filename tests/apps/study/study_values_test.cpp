#include "apps/study/study_values.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "apps/study/study_file.hpp"

namespace study_values_test {

using namespace app;
using testing::ElementsAre;

/// The one parameter of a sampled study.
StudyParameter parameter(const std::string& line) {
  return parse_study("scene = \"a.toml\"\nsampling = \"sobol\"\nsamples = 1\n[vary]\n" + line, "s.toml")
      .parameters.front();
}

Value words(const char* text) { return {std::string(text)}; }

TEST(StudyValues, NamesHoldOneKeyOrSeveral) {
  EXPECT_THAT(keys_of("solver.cfl"), ElementsAre("solver.cfl"));
  EXPECT_THAT(keys_of("generate.width + generate.height"), ElementsAre("generate.width", "generate.height"));
}

TEST(StudyValues, RangesGiveFiveDigitsWithinTheirEnds) {
  const StudyParameter range =
      parameter("\"loading.velocity\" = {low = \"0.123454 m/s\", high = \"0.2 m/s\"}");
  EXPECT_EQ(value_at_place(range, 0), words("0.123454 m/s"));  // five digits of it are out of the range
  EXPECT_EQ(value_at_place(range, 1.0 / 3), words("0.14897 m/s"));
  EXPECT_EQ(unit_of(range), "m/s");
  EXPECT_TRUE(is_number(range));
}

TEST(StudyValues, LevelsShareThePlaces) {
  const StudyParameter levels = parameter("\"generate.seed\" = [1, 2, 3]");
  EXPECT_EQ(value_at_place(levels, 0.33), Value{std::int64_t{1}});
  EXPECT_EQ(value_at_place(levels, 0.34), Value{std::int64_t{2}});
  EXPECT_EQ(value_at_place(levels, 0.999), Value{std::int64_t{3}});
  EXPECT_EQ(number_of(levels, levels.levels[2]), 3);
  EXPECT_EQ(unit_of(levels), "1");
}

TEST(StudyValues, StepsReachBothEndsAndMayFall) {
  const StudyParameter steps = parameter("\"generate.seed\" = {from = 9, to = 1, steps = 5}");
  EXPECT_THAT(steps.levels,
              ElementsAre(Value{std::int64_t{9}}, Value{std::int64_t{7}}, Value{std::int64_t{5}},
                          Value{std::int64_t{3}}, Value{std::int64_t{1}}));
}

TEST(StudyValues, WordsAreNoNumbers) {
  const StudyParameter mixed = parameter("\"phases.mortar.fracture_energy\" = [\"brittle\", \"60 J/m2\"]");
  EXPECT_TRUE(std::isnan(number_of(mixed, mixed.levels[0])));
  EXPECT_EQ(number_of(mixed, mixed.levels[1]), 60);
  EXPECT_FALSE(is_number(mixed));
  EXPECT_FALSE(is_number(parameter("\"loading.platen\" = [\"rough\", \"smooth\"]")));
}

TEST(StudyValues, ShowThemselvesAsWritten) {
  const StudyPlan plan = parse_study(
      "scene = \"a.toml\"\n[vary]\n\"specimen.file\" = [\"cuts/a.h5\", \"../b.h5\"]\n\"solver.cfl\" = "
      "[0.5]\n",
      "there/study.toml");
  const StudyParameter& file = plan.parameters[0];
  EXPECT_EQ(file.levels[0], words("there/cuts/a.h5"));
  EXPECT_EQ(text_of(file, file.levels[0]), "cuts/a.h5");
  EXPECT_EQ(text_of(file, file.levels[1]), "../b.h5");
  EXPECT_EQ(text_of(plan.parameters[1], plan.parameters[1].levels[0]), "0.5");
}

TEST(StudyValues, HaveUnitsThatPeopleRead) {
  const StudyParameter stress = parameter("\"phases.itz.cohesion\" = [\"90 MPa\"]");
  EXPECT_EQ(readable_unit(stress).name, "MPa");
  EXPECT_DOUBLE_EQ(readable_unit(stress).per_si * number_of(stress, stress.levels[0]), 90);
  const StudyParameter angle = parameter("\"phases.itz.friction_angle\" = [\"36 deg\"]");
  EXPECT_DOUBLE_EQ(readable_unit(angle).per_si * number_of(angle, angle.levels[0]), 36);
  EXPECT_EQ(readable_unit(parameter("\"solver.cfl\" = [0.5]")).name, "");
}

}  // namespace study_values_test
