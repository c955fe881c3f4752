#include "specimen/describe/doubts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "specimen/body/measure.hpp"
#include "tests/specimen/drawn.hpp"

namespace doubts_test {

using specimen::doubts_of;
using specimen::Specimen;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// 100 x 100 pixels of 1 mm with one stone.
Specimen with_stone(double radius) {
  specimen::Raster<std::int32_t> instances(100, 100, 0);
  if (radius > 0) specimen_test::draw_disc(instances, 50, 50, radius, 1);
  Specimen made;
  made.mask.pixel_size = 1e-3;
  made.mask.labels = {100, 100, specimen::phase::mortar};
  for (std::size_t i = 0; i < instances.size(); ++i)
    if (instances.data[i] != 0) made.mask.labels.data[i] = specimen::phase::aggregate;
  made.inclusions = specimen::measure_inclusions(instances, 1e-3);
  made.provenance.source = "photo.png";
  return made;
}

TEST(Doubts, AConcreteIsNotDoubted) { EXPECT_THAT(doubts_of(with_stone(30)), IsEmpty()); }

TEST(Doubts, EachKindIsNamed) {
  EXPECT_THAT(doubts_of(with_stone(0)), ElementsAre(HasSubstr("there is no aggregate")));
  EXPECT_THAT(doubts_of(with_stone(45)), ElementsAre(HasSubstr("one aggregate takes 63.")));
  EXPECT_THAT(doubts_of(with_stone(70)),
              ElementsAre(HasSubstr("of the area is aggregate"), HasSubstr("one aggregate")));
  Specimen holes = with_stone(20);
  for (std::size_t i = 0; i < 3100; ++i) holes.mask.labels.data[i] = specimen::phase::void_;
  EXPECT_THAT(doubts_of(holes), ElementsAre(HasSubstr("31.0 % of the area is void")));
  Specimen tiny = with_stone(20);
  tiny.mask.pixel_size = 1e-6;
  for (auto& inclusion : tiny.inclusions) inclusion.area *= 1e-6;
  EXPECT_THAT(doubts_of(tiny), ElementsAre(HasSubstr("the specimen is 0.1 mm wide")));
  Specimen specks = with_stone(20);
  specks.inclusions.insert(specks.inclusions.end(), 2001, specks.inclusions.front());
  for (std::size_t i = 1; i < specks.inclusions.size(); ++i) specks.inclusions[i].area = 4e-6;
  EXPECT_THAT(doubts_of(specks), ElementsAre(HasSubstr("2,001 aggregates have at most nine pixels each")));
}

TEST(Doubts, WhatTheConversionWarnedOfComesFirst) {
  Specimen made = with_stone(0);
  made.provenance.warnings = {"the picture can be read in two ways"};
  EXPECT_THAT(doubts_of(made),
              ElementsAre(HasSubstr("two ways; look at the specimen"), HasSubstr("no aggregate")));
}

TEST(Doubts, WhatWasAskedForIsNotDoubted) {
  Specimen generated = with_stone(0);
  generated.provenance.source = "generated";
  EXPECT_THAT(doubts_of(generated), IsEmpty());
}

}  // namespace doubts_test
