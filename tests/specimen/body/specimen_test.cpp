#include "specimen/body/specimen.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "specimen/body/error.hpp"
#include "specimen/pack/packing.hpp"

namespace specimen {
namespace specimen_test {

Segmented packed() {
  const PackingOptions options;
  return draw_ellipses(pack(options).ellipses, options.width, options.height, 0.5e-3);
}

TEST(Specimen, HasARingRoundEveryInclusion) {
  const Segmented segmented = packed();
  const Provenance provenance{"generated", "", "[generate]", 1, "0"};
  const Specimen specimen = make_specimen(segmented, {}, provenance);
  EXPECT_EQ(specimen.provenance, provenance);
  EXPECT_EQ(specimen.itz, ItzOptions{});
  ASSERT_EQ(specimen.inclusions.size(), segmented.inclusions.size());
  ASSERT_EQ(specimen.rings.size(), segmented.inclusions.size());
  double ring_area = 0;
  for (std::size_t i = 0; i < specimen.rings.size(); ++i) {
    EXPECT_EQ(specimen.rings[i].inclusion, specimen.inclusions[i].id);
    EXPECT_EQ(specimen.rings[i].vertices.size(), 36u);
    ring_area += specimen.inclusions[i].perimeter * 0.5e-3;
  }
  // One pixel thick; rings of near neighbours share pixels, so there are somewhat fewer.
  const double itz = static_cast<double>(count_labels(specimen.mask)[phase::itz]) * 0.25e-6;
  EXPECT_GT(itz, 0.7 * ring_area);
  EXPECT_LT(itz, 1.1 * ring_area);
}

TEST(Specimen, ThicknessNoughtMeansOnePixel) {
  const Segmented segmented = packed();
  const Specimen nought = make_specimen(segmented, {ItzMode::ring, 0, 36}, {});
  EXPECT_EQ(nought.mask, make_specimen(segmented, {ItzMode::ring, 0.5e-3, 36}, {}).mask);
  EXPECT_NE(nought.mask, make_specimen(segmented, {ItzMode::ring, 1e-3, 36}, {}).mask);
}

TEST(Specimen, PointsLeaveTheMaskAlone) {
  const Segmented segmented = packed();
  const Specimen specimen = make_specimen(segmented, {ItzMode::points, 0, 12}, {});
  EXPECT_EQ(specimen.mask, segmented.mask);
  ASSERT_EQ(specimen.rings.size(), segmented.inclusions.size());
  EXPECT_EQ(specimen.rings[0].vertices.size(), 12u);
}

TEST(Specimen, WithoutItzHasNoRings) {
  const Segmented segmented = packed();
  const Specimen specimen = make_specimen(segmented, {ItzMode::none, 0, 36}, {});
  EXPECT_EQ(specimen.mask, segmented.mask);
  EXPECT_TRUE(specimen.rings.empty());
}

TEST(Specimen, RefusesANegativeThickness) {
  for (const double thickness : {-1e-3, std::nan("")}) {
    EXPECT_THROW((void)make_specimen(packed(), {ItzMode::ring, thickness, 36}, {}), Error);
  }
  EXPECT_THROW((void)make_specimen(packed(), {ItzMode::points, 0, 2}, {}), Error);
}

}  // namespace specimen_test
}  // namespace specimen
