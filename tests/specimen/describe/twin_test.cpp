#include "specimen/describe/twin.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "specimen/body/error.hpp"
#include "specimen/describe/misfit.hpp"
#include "specimen/pack/packing.hpp"

namespace specimen {
namespace twin_test {

constexpr double mm = 1e-3;
constexpr ItzOptions no_itz{ItzMode::none, 0, 36};

PackingOptions small_options() {
  PackingOptions options;
  options.width = options.height = 0.1;
  options.grading = named_grading("fuller", 4 * mm, 16 * mm);
  return options;
}

Descriptors packed(const PackingOptions& options) {
  return describe(make_specimen(
      draw_ellipses(pack(options).ellipses, options.width, options.height, 0.5 * mm), no_itz, {}));
}

// A square cut out of a packing, whose border cuts aggregates.
Descriptors cut_out(double side) {
  PackingOptions options = small_options();
  options.width = options.height = 2 * side;
  std::vector<Ellipse> ellipses = pack(options).ellipses;
  for (Ellipse& e : ellipses) {
    e.x -= side / 2;
    e.y -= side / 2;
  }
  return describe(make_specimen(draw_window(ellipses, side, side, 0.5 * mm), no_itz, {}));
}

std::vector<Descriptors> twins_of(const TwinPlan& plan, int count) {
  std::vector<Descriptors> twins;
  for (int n = 1; n <= count; ++n)
    twins.push_back(
        describe(make_specimen(draw_twin(plan, static_cast<std::uint64_t>(n)).segmented, no_itz, {})));
  return twins;
}

std::string refusal(const Descriptors& original, const TwinOptions& options = {}) {
  try {
    (void)draw_twin(plan_twins(original, options), 1);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

// An original is to lie as far from the mean of its twins as a twin does from that of the others. So it does
// over some originals; S2 of a single one, of some sixty aggregates, is off by chance.
TEST(Twin, OfAWalledSpecimenMatchesIt) {
  double off = 0, scatter = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    PackingOptions options = small_options();
    options.seed = seed;
    const Descriptors original = packed(options);
    const TwinPlan plan = plan_twins(original, {});
    EXPECT_FALSE(plan.cut);
    EXPECT_FALSE(plan.oriented);
    EXPECT_GE(plan.gap, 0.5 * mm);
    EXPECT_LE(plan.gap, 0.65 * mm);
    const Misfit misfit = compare(original, twins_of(plan, 6));
    EXPECT_NEAR(misfit.fraction.mean, original.fraction, 0.002);
    EXPECT_NEAR(misfit.median_diameter.mean, original.median_diameter, 0.5 * mm);
    EXPECT_LT(misfit.sizes.original, 0.06);
    EXPECT_NEAR(misfit.mean_aspect.mean, original.mean_aspect, 0.02);
    EXPECT_NEAR(misfit.mean_gap.mean / original.mean_gap, 1, 0.15);
    EXPECT_NEAR(misfit.specific_perimeter.mean / original.specific_perimeter, 1, 0.03);
    off += misfit.s2_rms.original;
    scatter += misfit.s2_rms.mean;
  }
  EXPECT_NEAR(off / scatter, 1, 0.3);
}

TEST(Twin, OfAWindowIsCutAndMatchesIt) {
  const Descriptors original = cut_out(0.1);
  ASSERT_GT(original.sample.cut, 10);
  const TwinPlan plan = plan_twins(original, {});
  EXPECT_TRUE(plan.cut);
  const std::vector<Descriptors> twins = twins_of(plan, 8);
  const Misfit misfit = compare(original, twins);
  EXPECT_NEAR(misfit.fraction.mean, original.fraction, 0.002);
  EXPECT_LT(misfit.sizes.original, 0.12);
  EXPECT_TRUE(misfit.s2_rms.within()) << misfit.s2_rms.original << ' ' << misfit.s2_rms.largest;
  for (const Descriptors& twin : twins) EXPECT_GT(twin.sample.cut, 10);
}

// Walls keep aggregates off, so that there is more of them in the middle; a cut border does not.
TEST(Twin, HasNoWallsWhereTheBorderCuts) {
  const Descriptors original = cut_out(0.08);
  const auto share_in_the_middle = [&](Border border) {
    TwinOptions options;
    options.border = border;
    const TwinPlan plan = plan_twins(original, options);
    double sum = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      const LabelledMask mask = draw_twin(plan, seed).segmented.mask;
      for (int row = 20; row < 140; ++row)
        for (int col = 20; col < 140; ++col) sum += mask.labels(row, col) == phase::aggregate;
    }
    return sum / (6 * 120 * 120);
  };
  EXPECT_NEAR(share_in_the_middle(Border::cut), original.fraction, 0.02);
  EXPECT_GT(share_in_the_middle(Border::whole), original.fraction + 0.04);
}

TEST(Twin, KeepsTheDirectionsOfItsOriginal) {
  std::vector<Ellipse> ellipses;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      ellipses.push_back({(15 + 30 * i) * mm, (15 + 30 * j) * mm, 12 * mm, 7 * mm, 0.5 + 0.02 * i});
  const Descriptors original =
      describe(make_specimen(draw_ellipses(ellipses, 0.12, 0.12, 0.5 * mm), no_itz, {}));
  const TwinPlan plan = plan_twins(original, {});
  ASSERT_TRUE(plan.oriented);
  EXPECT_LT(plan.gap, usual_gap(original));  // which only such an order can keep
  EXPECT_GT(plan.gap, 0);
  for (const Descriptors& twin : twins_of(plan, 3)) {
    EXPECT_NEAR(twin.orientation.direction, original.orientation.direction, 0.02);
    EXPECT_NEAR(twin.orientation.strength, 1, 0.01);
    EXPECT_NEAR(twin.mean_aspect, 7.0 / 12, 1e-9);
  }
}

TEST(Twin, OfTheSameSeedIsTheSame) {
  const TwinPlan plan = plan_twins(cut_out(0.06), {});
  const Segmented one = draw_twin(plan, 7).segmented, again = draw_twin(plan, 7).segmented;
  EXPECT_EQ(one.mask, again.mask);
  EXPECT_EQ(one.instances, again.instances);
  EXPECT_NE(one.mask, draw_twin(plan, 8).segmented.mask);
}

TEST(Twin, ReachesSixtyFivePerCent) {
  PackingOptions options = small_options();
  options.fraction = 0.65;
  options.gap = 0.2 * mm;
  const Descriptors original = packed(options);
  for (const Border border : {Border::cut, Border::whole}) {
    TwinOptions twin;
    twin.border = border;
    const Twin drawn = draw_twin(plan_twins(original, twin), 1);
    EXPECT_TRUE(drawn.relaxed);
    EXPECT_NEAR(fractions(drawn.segmented.mask)[phase::aggregate], original.fraction, 0.003);
  }
}

TEST(Twin, MayHaveAnotherSizeAndPixel) {
  TwinOptions options;
  options.width = 0.15;
  options.height = 0.09;
  options.pixel_size = 1 * mm;
  const Descriptors original = packed(small_options());
  const Twin twin = draw_twin(plan_twins(original, options), 1);
  EXPECT_EQ(twin.segmented.mask.labels.cols, 150);
  EXPECT_EQ(twin.segmented.mask.labels.rows, 90);
  EXPECT_NEAR(fractions(twin.segmented.mask)[phase::aggregate], original.fraction, 0.01);
  options = {};
  options.pixel_size = 0.7 * mm;  // of which 100 mm are no whole number
  EXPECT_EQ(draw_twin(plan_twins(original, options), 1).segmented.mask.labels.cols, 143);
}

TEST(Twin, CountsAggregatesThatFallBetweenPixels) {
  TwinOptions options;
  options.pixel_size = 5 * mm;
  const Twin twin = draw_twin(plan_twins(packed(small_options()), options), 1);
  EXPECT_GT(twin.lost, 5);
  EXPECT_EQ(draw_twin(plan_twins(packed(small_options()), {}), 1).lost, 0);
}

TEST(Twin, OfOneAggregateHasOne) {
  const Descriptors original = describe(make_specimen(
      draw_ellipses({{20 * mm, 20 * mm, 8 * mm, 6 * mm, 1}}, 0.05, 0.05, 0.5 * mm), no_itz, {}));
  EXPECT_EQ(usual_gap(original), 0);
  const Twin twin = draw_twin(plan_twins(original, {}), 1);
  ASSERT_EQ(twin.segmented.inclusions.size(), 1u);
  EXPECT_NEAR(twin.segmented.inclusions.front().ellipse.a, 8 * mm, 0.05 * mm);
}

TEST(Twin, NeedsAnOriginalWithAggregatesAndMortar) {
  EXPECT_EQ(refusal(describe(make_specimen(draw_ellipses({}, 0.05, 0.05, mm), no_itz, {}))),
            "original: no aggregate; twins need aggregates to match; check how the phases are separated");
  EXPECT_EQ(refusal(describe(
                make_specimen(draw_window({{0.02, 0.02, 0.04, 0.04, 0}}, 0.04, 0.04, mm), no_itz, {}))),
            "original: 100 % of aggregate; must be at most 90 %; check how the phases are separated");
}

TEST(Twin, RefusesWhatDoesNotFit) {
  const Descriptors original = cut_out(0.08);
  TwinOptions options;
  options.width = options.height = 0.003;
  EXPECT_THAT(refusal(original, options), testing::HasSubstr(" mm^2 of aggregate; holds not even one of "));
  options.width = 0.1;
  for (const Border border : {Border::cut, Border::whole}) {
    options.border = border;
    EXPECT_THAT(refusal(original, options), testing::HasSubstr("does not fit into 100 x 3 mm with a gap of"));
    EXPECT_THAT(refusal(original, options), testing::EndsWith("take a larger twin"));
  }
  options = {};
  options.gap = 8 * mm;
  EXPECT_THAT(refusal(original, options),
              testing::EndsWith("could not be packed with a gap of 8 mm; lower the gap"));
  options = {};
  options.width = 0.0503;
  EXPECT_EQ(refusal(original, options),
            "twin.width: 50.3 mm; must be a whole number of pixels of 0.5 mm; take 50 mm or 50.5 mm");
}

TEST(Twin, HasTheAreaOfItsFractionExactly) {
  const Descriptors original = packed(small_options());
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    double area = 0;
    for (const Inclusion& inclusion : draw_twin(plan_twins(original, {}), seed).segmented.inclusions)
      area += inclusion.area;
    EXPECT_NEAR(area / (0.1 * 0.1), original.fraction, 1e-12);
  }
}

}  // namespace twin_test
}  // namespace specimen
