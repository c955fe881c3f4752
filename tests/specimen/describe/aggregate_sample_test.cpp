#include "specimen/describe/aggregate_sample.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "specimen/body/raster.hpp"
#include "specimen/pack/packing.hpp"

namespace specimen {
namespace aggregate_sample_test {

constexpr double mm = 1e-3, pi = std::numbers::pi;

Specimen seen(const std::vector<Ellipse>& ellipses, double side, double pixel = 0.5 * mm) {
  return make_specimen(draw_window(ellipses, side, side, pixel), {ItzMode::none, 0, 36}, {});
}

TEST(AggregateSample, CountsWhatTheBorderCuts) {
  const Specimen specimen = seen({{20 * mm, 20 * mm, 8 * mm, 5 * mm, 0.7},
                                  {0, 60 * mm, 5 * mm, 5 * mm, 0},
                                  {60 * mm, 78 * mm, 5 * mm, 5 * mm, 0}},
                                 80 * mm);
  const AggregateSample sample = sample_aggregates(specimen);
  EXPECT_EQ(sample.cut, 2);
  EXPECT_EQ(sample.parts, 0);
  ASSERT_EQ(sample.aggregates.size(), 1u);
  const SampledAggregate& one = sample.aggregates.front();
  EXPECT_NEAR(one.diameter, 2 * std::sqrt(40.0) * mm, 1e-12);
  EXPECT_NEAR(one.aspect, 5.0 / 8, 1e-12);
  EXPECT_NEAR(one.angle, 0.7, 1e-12);
  const Point half = half_extent({0, 0, 8 * mm, 5 * mm, 0.7});
  EXPECT_NEAR(one.weight, 80 * 80 * mm * mm / ((80 * mm - 2 * half.x) * (80 * mm - 2 * half.y)), 1e-9);
  double cut_area = 0;
  for (const Inclusion& inclusion : specimen.inclusions)
    if (is_cut(inclusion, specimen.mask)) cut_area += inclusion.area;
  EXPECT_NEAR(sample.cut_share, cut_area / (cut_area + 40 * pi * mm * mm), 1e-9);
}

TEST(AggregateSample, OfAWalledSpecimenWeighsAllAlike) {
  const AggregateSample sample = sample_aggregates(
      seen({{20 * mm, 20 * mm, 15 * mm, 9 * mm, 0}, {60 * mm, 60 * mm, 3 * mm, 2 * mm, 1}}, 80 * mm));
  EXPECT_EQ(sample.cut, 0);
  EXPECT_EQ(sample.cut_share, 0);
  ASSERT_EQ(sample.aggregates.size(), 2u);
  EXPECT_GT(sample.aggregates[0].diameter, sample.aggregates[1].diameter);
  EXPECT_EQ(sample.aggregates[0].weight, 1);
  EXPECT_EQ(sample.aggregates[1].weight, 1);
}

TEST(AggregateSample, TakesPartsThatAreLargerThanAllWholeOnes) {
  const std::vector<Ellipse> ellipses{{0, 40 * mm, 20 * mm, 20 * mm, 0},
                                      {60 * mm, 40 * mm, 6 * mm, 6 * mm, 0},
                                      {80 * mm, 60 * mm, 6 * mm, 6 * mm, 0}};
  const AggregateSample sample = sample_aggregates(seen(ellipses, 80 * mm));
  EXPECT_EQ(sample.cut, 2);
  EXPECT_EQ(sample.parts, 1);
  ASSERT_EQ(sample.aggregates.size(), 2u);
  EXPECT_NEAR(sample.aggregates.front().diameter, 20 * std::sqrt(2.0) * mm, 0.1 * mm);
  EXPECT_EQ(sample.aggregates.front().weight, 1);
  EXPECT_NEAR(sample.aggregates.back().weight, std::pow(80.0 / 68, 2), 1e-9);
}

TEST(AggregateSample, OfPartsAloneTakesThem) {
  const AggregateSample sample = sample_aggregates(seen({{0, 40 * mm, 20 * mm, 20 * mm, 0}}, 80 * mm));
  EXPECT_EQ(sample.parts, 1);
  EXPECT_EQ(sample.cut_share, 1);
  EXPECT_EQ(sample.aggregates.size(), 1u);
  EXPECT_TRUE(sample_aggregates(seen({}, 80 * mm)).aggregates.empty());
}

// Half of the discs are large. A window keeps one of 30 mm whole at (50 / 80)^2 of the places, one of 6 mm at
// (74 / 80)^2, so that unweighted shares are off, and weighted ones are not.
TEST(AggregateSample, TakesTheBiasOfTheWindowOff) {
  Random random(1);
  double large = 0, small = 0, large_seen = 0, small_seen = 0;
  for (int window = 0; window < 3000; ++window) {
    const double radius = window % 2 == 0 ? 15 * mm : 3 * mm;
    // A window in a plane of sparse discs: the disc touches it, and lies anywhere there.
    const double x = random.uniform(-15 * mm, 95 * mm), y = random.uniform(-15 * mm, 95 * mm);
    const bool whole = std::min({x, y, 80 * mm - x, 80 * mm - y}) > radius;
    if (!whole) continue;
    std::vector<Ellipse> ellipses{{x, y, radius, radius, 0}, {0, 0, 0.8 * mm, 0.8 * mm, 0}};
    const AggregateSample sample = sample_aggregates(seen(ellipses, 80 * mm, 1 * mm));
    ASSERT_EQ(sample.aggregates.size(), 1u);
    (radius > 10 * mm ? large : small) += sample.aggregates.front().weight;
    (radius > 10 * mm ? large_seen : small_seen) += 1;
  }
  EXPECT_LT(large_seen / small_seen, 0.55);
  EXPECT_NEAR(large / small, 1, 0.1);
}

TEST(AggregateSample, HasItsSizesByWeightedArea) {
  AggregateSample sample;
  sample.aggregates = {{4, 1, 0, 1}, {2, 1, 0, 3}};
  const std::vector<WeightedValue> sizes = sizes_by_area(sample);
  ASSERT_EQ(sizes.size(), 2u);
  EXPECT_EQ(sizes[1].value, 2);
  EXPECT_DOUBLE_EQ(sizes[0].weight, 4 * pi);
  EXPECT_DOUBLE_EQ(sizes[1].weight, 3 * pi);
}

TEST(Distribution, RisesByTheWeightsOfItsValues) {
  const Distribution distribution = distribution_of({{4, 1}, {2, 0.75}, {2, 0.25}});
  ASSERT_EQ(distribution.value, (std::vector<double>{2, 4}));
  EXPECT_DOUBLE_EQ(distribution.below[0], 0.5);
  EXPECT_DOUBLE_EQ(distribution.below[1], 1);
  EXPECT_EQ(share_up_to(distribution, 1.9), 0);
  EXPECT_DOUBLE_EQ(share_up_to(distribution, 2), 0.5);
  EXPECT_DOUBLE_EQ(share_up_to(distribution, 3.9), 0.5);
  EXPECT_EQ(share_up_to(distribution, 5), 1);
  EXPECT_EQ(quantile(distribution, 0.4), 2);
  EXPECT_EQ(quantile(distribution, 0.6), 4);
  EXPECT_EQ(quantile(distribution, 1), 4);
  EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
  EXPECT_EQ(share_up_to({}, 1), 0);
}

TEST(Distribution, OfSeveralSamplesGivesEachTheSameSay) {
  const PooledDistribution pool({{{2, 1}}, {{4, 1}, {4, 7}}, {}});
  ASSERT_EQ(pool.all().value, (std::vector<double>{2, 4}));
  EXPECT_DOUBLE_EQ(pool.all().below[0], 0.5);
  EXPECT_DOUBLE_EQ(pool.without(2).below[0], 0.5);
  EXPECT_EQ(pool.without(0).value, (std::vector<double>{4}));
  EXPECT_TRUE(PooledDistribution({{{2, 1}}}).without(0).value.empty());
}

TEST(Distribution, LiesApartByTheLargestAndTheMeanDifference) {
  const Distribution first{{1, 2}, {0.4, 1}}, second{{1, 3}, {0.1, 1}};
  const DistributionDistance distance = distance_between(first, second);
  EXPECT_DOUBLE_EQ(distance.largest, 0.9);
  EXPECT_DOUBLE_EQ(distance.mean, 0.3 + 0.9);
  EXPECT_EQ(distance_between(first, first).largest, 0);
  EXPECT_EQ(distance_between(first, first).mean, 0);
  EXPECT_TRUE(std::isnan(distance_between(first, {}).largest));
}

}  // namespace aggregate_sample_test
}  // namespace specimen
