#include "specimen/convert/fringes.hpp"

#include <gtest/gtest.h>

#include "specimen/convert/convert.hpp"
#include "tests/specimen/drawn.hpp"
#include "tests/specimen/known_truth.hpp"

namespace fringes_test {

using specimen::dissolve_fringes;
using specimen::distinct_values;
using specimen::Raster;
using specimen::ValueMap;
using specimen_test::coded;
using specimen_test::drawn_softly;
using specimen_test::known_truth;
using specimen_test::KnownTruth;
using specimen_test::picture_of;

// Void 0 and mortar 2, resized: a rim of 1, and 1 is aggregate.
TEST(Fringes, OfResizedLabelNumbersAreNoAggregates) {
  const KnownTruth truth = known_truth();
  for (const std::array<double, 3>& codes : {std::array{0.0, 1.0, 2.0}, std::array{1.0, 2.0, 3.0}}) {
    specimen::ConvertOptions options;
    options.width = 0.16;
    const specimen::Converted converted = convert_picture(picture_of(drawn_softly(truth, codes)), options);
    EXPECT_LT(specimen_test::share_wrong(converted.segmented.mask.labels, truth.labels), 0.02);
    EXPECT_EQ(converted.segmented.inclusions.size(), truth.stones.size());
  }
}

TEST(Fringes, AMapWithSharpEdgesHasNone) {
  ValueMap map = *distinct_values(picture_of(coded(known_truth().labels, std::array{0.0, 1.0, 2.0})), 9);
  const Raster<std::int32_t> before = map.code;
  EXPECT_EQ(dissolve_fringes(map), 0);
  EXPECT_EQ(map.code, before);
}

// A phase that is nothing but a rim: ITZ.
TEST(Fringes, ARimThatIsAPhaseStays) {
  Raster<double> gray(60, 60, 0.0);
  specimen_test::draw_disc(gray, 30, 30, 16, 1.0);
  specimen_test::draw_disc(gray, 30, 30, 15, 2.0);
  ValueMap map = *distinct_values(picture_of(gray), 9);
  EXPECT_EQ(dissolve_fringes(map), 0);
}

}  // namespace fringes_test
