#include "specimen/body/specimen.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "specimen/body/error.hpp"
#include "specimen/pack/packing.hpp"
#include "tests/specimen/sample_specimen.hpp"

namespace specimen {
namespace specimen_test {

using specimen::Specimen;

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

/// What validate says of the sample after one change.
std::string verdict(const std::function<void(Specimen&)>& change) {
  Specimen s = test::sample_specimen();
  change(s);
  try {
    specimen::validate(s);
  } catch (const specimen::Error& error) {
    return error.what();
  }
  return "valid";
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Validate, TakesASoundSpecimen) {
  EXPECT_EQ(verdict([](Specimen&) {}), "valid");
  EXPECT_EQ(verdict([](Specimen& s) {
              s.inclusions.clear();
              s.rings.clear();
              s.itz = {specimen::ItzMode::none, 0, 3};
            }),
            "valid");
}

TEST(Validate, ChecksTheMask) {
  EXPECT_EQ(verdict([](Specimen& s) { s.mask.labels = {}; }), "labels: 0 x 0 pixels; must be at least 1 x 1");
  EXPECT_EQ(verdict([](Specimen& s) { s.mask.labels.rows = s.mask.labels.cols = 20'000; }),
            "labels: 20000 x 20000 pixels; must be at most 200000000");
  EXPECT_EQ(verdict([](Specimen& s) { s.mask.labels.data.pop_back(); }),
            "labels: 47 values; must be one for each of 6 x 8 pixels");
  EXPECT_EQ(verdict([](Specimen& s) { s.mask.labels(4, 7) = 6; }),
            "labels: 6 at row 4, column 7; must be below 6, the number of phases");
  EXPECT_EQ(verdict([](Specimen& s) { s.mask.pixel_size = 0; }), "pixel_size: 0.000000 m; must be > 0");
  EXPECT_EQ(verdict([](Specimen& s) { s.mask.pixel_size = nan; }), "pixel_size: nan m; must be > 0");
}

TEST(Validate, ChecksThePhaseNames) {
  EXPECT_EQ(verdict([](Specimen& s) { s.mask.phases.clear(); }), "phases: 0 names; must be 1 to 256");
  EXPECT_EQ(verdict([](Specimen& s) { s.mask.phases.resize(257, "x"); }),
            "phases: 257 names; must be 1 to 256");
  EXPECT_EQ(verdict([](Specimen& s) { s.mask.phases[4] = ""; }),
            "phases: an empty name; every phase needs a name");
  EXPECT_EQ(verdict([](Specimen& s) { s.mask.phases[4] = "itz"; }),
            "phases: 'itz' twice; every phase needs a unique name");
}

TEST(Validate, ChecksTheInclusions) {
  EXPECT_EQ(verdict([](Specimen& s) { s.inclusions[1].id = 0; }), "inclusions[1].id: 0; must be >= 1");
  EXPECT_EQ(verdict([](Specimen& s) { s.inclusions[1].id = 7; }),
            "inclusions[1].id: 7 was used before; must be a unique id");
  EXPECT_EQ(verdict([](Specimen& s) { s.inclusions[0].ellipse.x = nan; }),
            "inclusions[0].x: nan; must be a finite number");
  EXPECT_EQ(verdict([](Specimen& s) { s.inclusions[0].ellipse.b = 0; }),
            "inclusions[0].b: 0.000000; must be > 0");
  EXPECT_EQ(verdict([](Specimen& s) { s.inclusions[0].area = -1; }),
            "inclusions[0].area: -1.000000; must be > 0");
  EXPECT_EQ(verdict([](Specimen& s) { s.inclusions[1].contour[2].y = nan; }),
            "inclusions[1].contour: not a number; must be finite numbers");
}

TEST(Validate, ChecksTheRings) {
  EXPECT_EQ(verdict([](Specimen& s) { s.itz.segments = 2; }),
            "itz.segments: 2; must be >= 3, or 0 = automatic");
  EXPECT_EQ(verdict([](Specimen& s) { s.itz.thickness = -1; }),
            "itz.thickness: -1.000000 m; must be >= 0 (0 = one pixel)");
  EXPECT_EQ(verdict([](Specimen& s) { s.rings[0].inclusion = 1; }),
            "rings[0].inclusion: 1; must be the id of an inclusion");
  EXPECT_EQ(verdict([](Specimen& s) { s.rings[1].vertices.pop_back(); }),
            "rings[1].vertices: 2 corners; must be >= 3");
  EXPECT_EQ(verdict([](Specimen& s) { s.rings[1].vertices[0].x = nan; }),
            "rings[1].vertices: not a number; must be finite numbers");
}

}  // namespace specimen_test
}  // namespace specimen
