#include "apps/report/fixture_drawing.hpp"

#include <gtest/gtest.h>

#include <variant>
#include <vector>

#include "tests/libmpm/sample_scenes.hpp"

namespace fixture_drawing_test {

using mpm::Side;
using mpm::Way;

/// 40 x 10 pixels of 1 mm on two supports, loaded from above.
mpm::Scene beam(double from, double to) {
  mpm::Scene scene = samples::mortar_block(10, 40, 1e-3);
  scene.points_per_cell = 1;
  scene.fixture.supports = {{{Side::bottom, 5e-3, 5e-3}, true, true},
                            {{Side::bottom, 35e-3, 35e-3}, false, true}};
  scene.fixture.loads = {{.at = {Side::top, from, to}, .way = Way::down, .leads = true}};
  return scene;
}

/// Where the strokes of an ink begin.
std::vector<output::Place> strokes_in(output::Ink ink, const mpm::Scene& scene) {
  specimen::LabelledMask mask;
  mask.pixel_size = 1e-3;
  mask.labels = specimen::Raster<std::uint8_t>(10, 40, specimen::phase::mortar);
  std::vector<output::Place> places;
  for (const output::Shape& shape : output::fixture_drawing(mask, scene).shapes)
    if (const auto* stroke = std::get_if<output::Stroke>(&shape); stroke != nullptr && stroke->ink == ink)
      places.push_back(stroke->places.front());
  return places;
}

TEST(FixtureDrawing, AShortLoadIsOneArrowAtItsMiddle) {
  const std::vector<output::Place> arrow = strokes_in(output::Ink::first, beam(20e-3, 21e-3));
  ASSERT_EQ(arrow.size(), 2u) << "a shaft and a tip";
  EXPECT_DOUBLE_EQ(arrow[0].x, 44 + 20.5 * 11);
}

TEST(FixtureDrawing, ALongLoadHasArrowsFromEndToEnd) {
  const std::vector<output::Place> arrows = strokes_in(output::Ink::first, beam(10e-3, 30e-3));
  ASSERT_EQ(arrows.size(), 2u * 14);
  EXPECT_DOUBLE_EQ(arrows.front().x, 44 + 10 * 11);
  EXPECT_DOUBLE_EQ(arrows[arrows.size() - 2].x, 44 + 30 * 11);
}

TEST(FixtureDrawing, ASupportThatSlidesHasALineBelow) {
  EXPECT_EQ(strokes_in(output::Ink::second, beam(20e-3, 20e-3)).size(), 3u);
}

}  // namespace fixture_drawing_test
