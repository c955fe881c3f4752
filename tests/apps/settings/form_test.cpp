#include "apps/settings/form.hpp"

#include <gtest/gtest.h>

#include "apps/settings/schema.hpp"

namespace form_test {

std::string allowed(const char* key) { return text(app::find_field(key)->form); }

TEST(Form, SaysWhatIsAllowed) {
  EXPECT_EQ(allowed("generate.width"), "length > 0");
  EXPECT_EQ(allowed("generate.fraction"), "number in [0, 1)");
  EXPECT_EQ(allowed("loading.initial_velocity_x"), "velocity");
  EXPECT_EQ(allowed("loading.direction"), "tension, compression or none");
  EXPECT_EQ(allowed("loading.stop_drop"), "number in (0, 1), or none");
  EXPECT_EQ(allowed("loading.separation"), "true or false");
  EXPECT_EQ(allowed("solver.threads"), "whole number in [1, 1024], or auto");
  EXPECT_EQ(allowed("generate.seed"), "whole number >= 0");
  EXPECT_EQ(allowed("convert.crop"), "[x, y, width, height]");
  EXPECT_EQ(allowed("convert.thresholds"), "list of numbers");
  EXPECT_EQ(allowed("generate.classes"), "list of texts");
  EXPECT_EQ(allowed("specimen.picture"), "name of a file");
  EXPECT_EQ(allowed("output.title"), "text");
  EXPECT_EQ(allowed("phases.fibre.friction_angle"), "angle in [0, 90 deg)");
}

TEST(Bounds, SayTheirRange) {
  EXPECT_EQ(app::above(0).range(app::Dimension::length), "> 0");
  EXPECT_EQ(app::up_to(0, 1).range(app::Dimension::ratio), "in (0, 1]");
  EXPECT_EQ(app::Bounds().range(app::Dimension::ratio), "");
  EXPECT_EQ(app::up_to(0, 1).text(app::Dimension::ratio), "must lie in (0, 1]");
}

}  // namespace form_test
