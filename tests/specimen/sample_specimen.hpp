/// A small specimen in which every member has a value of its own.
#pragma once

#include <gtest/gtest.h>

#include "specimen/body/specimen.hpp"

namespace test {

inline specimen::Specimen sample_specimen() {
  specimen::Specimen s;
  s.mask.pixel_size = 0.5e-3;
  s.mask.labels = specimen::Raster<std::uint8_t>(6, 8, specimen::phase::mortar);
  s.mask.phases = {"void", "aggregate", "mortar", "itz", "fibre", "Zement\u00e4hnlich"};
  for (int i = 0; i < 6; ++i) s.mask.labels(i, i) = static_cast<std::uint8_t>(i);
  s.inclusions = {
      {7, {1e-3, 1.5e-3, 0.8e-3, 0.5e-3, 0.3}, {}, 1.2566e-6, 4.1e-3, 1.2649e-3, 0.3},
      {3,
       {3e-3, 2e-3, 0.4e-3, 0.4e-3, 0},
       {{2.6e-3, 2e-3}, {3.4e-3, 1.6e-3}, {3e-3, 2.4e-3}},
       5e-7,
       2.5e-3,
       8e-4,
       3.1},
  };
  s.itz = {specimen::ItzMode::points, 0.25e-3, 4};
  s.rings = {{3, {{2.6e-3, 2e-3}, {3e-3, 1.6e-3}, {3.4e-3, 2e-3}, {3e-3, 2.4e-3}}},
             {7, {{1.0 / 3, 0}, {0, 1e-300}, {-0.0, 5}}}};
  s.provenance = {"slice.png",
                  std::string(64, 'a'),
                  "[convert]\nname = \"\u00e4\"\n\n",
                  0xFFFFFFFFFFFFFFFFULL,
                  "0.1.0",
                  {"it can be read in two ways", "pores were lost"}};
  return s;
}

inline void expect_equal(const specimen::Specimen& a, const specimen::Specimen& b) {
  EXPECT_EQ(a.mask, b.mask);
  EXPECT_EQ(a.itz, b.itz);
  EXPECT_EQ(a.provenance, b.provenance);
  ASSERT_EQ(a.inclusions.size(), b.inclusions.size());
  for (std::size_t i = 0; i < a.inclusions.size(); ++i) {
    const specimen::Inclusion& p = a.inclusions[i];
    const specimen::Inclusion& q = b.inclusions[i];
    EXPECT_EQ(p.id, q.id);
    EXPECT_EQ(p.ellipse, q.ellipse);
    EXPECT_EQ(p.contour, q.contour);
    EXPECT_EQ(p.area, q.area);
    EXPECT_EQ(p.perimeter, q.perimeter);
    EXPECT_EQ(p.equivalent_diameter, q.equivalent_diameter);
    EXPECT_EQ(p.orientation, q.orientation);
  }
  ASSERT_EQ(a.rings.size(), b.rings.size());
  for (std::size_t i = 0; i < a.rings.size(); ++i) {
    EXPECT_EQ(a.rings[i].inclusion, b.rings[i].inclusion);
    EXPECT_EQ(a.rings[i].vertices, b.rings[i].vertices);
  }
}

}  // namespace test
