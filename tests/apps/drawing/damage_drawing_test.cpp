#include "apps/drawing/damage_picture.hpp"

#include <gtest/gtest.h>

#include "tests/apps/drawn.hpp"
#include "tests/apps/fake_run.hpp"

namespace damage_drawing_test {

using output::Drawing;
using output::Words;
using test::says;

Drawing drawing_of(const FakeRun& run, double strain) {
  return output::damage_drawing(run.specimen.mask, run.result, strain, output::grey_palette(),
                                "at some strain");
}

TEST(DamageDrawing, NamesWhatIsInIt) {
  const FakeRun run = tension_run(60);
  const Drawing before = drawing_of(run, 0);
  EXPECT_FALSE(says(before, "failed in tension"));
  EXPECT_TRUE(says(before, "mortar"));
  EXPECT_TRUE(says(before, "at some strain"));
  const Drawing after = drawing_of(run, run.result.history.back().strain);
  EXPECT_TRUE(says(after, "failed in tension"));
  EXPECT_EQ(says(after, "failed in shear"), (run.result.failure_mode == std::uint8_t{2}).any());
}

TEST(DamageDrawing, TheScaleBarIsAsLongAsItSays) {
  const FakeRun run = tension_run(60);  // 150 mm on 480 px
  const Drawing drawing = drawing_of(run, 0);
  ASSERT_TRUE(says(drawing, "20 mm"));
  for (const output::Shape& shape : drawing.shapes) {
    const auto* stroke = std::get_if<output::Stroke>(&shape);
    if (stroke == nullptr || stroke->places.size() != 2) continue;
    EXPECT_NEAR(stroke->places[1].x - stroke->places[0].x, 480 * 20.0 / 150, 1e-9);
  }
}

TEST(DamageDrawing, HoldsAllThatItDraws) {
  const Drawing drawing = drawing_of(compression_run(60), 0);
  for (const output::Shape& shape : drawing.shapes)
    if (const Words* words = std::get_if<Words>(&shape)) {
      EXPECT_LE(words->at.y, drawing.height);
      EXPECT_LE(words->at.x, drawing.width);
    }
}

}  // namespace damage_drawing_test
