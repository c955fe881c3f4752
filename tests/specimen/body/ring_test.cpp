#include "specimen/body/ring.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "specimen/body/error.hpp"
#include "specimen/body/mask.hpp"
#include "specimen/body/raster.hpp"
#include "specimen/body/specimen.hpp"
#include "specimen/pack/packing.hpp"

namespace specimen {
namespace ring_test {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

constexpr double pi = std::numbers::pi, mm = 1e-3;

// Number of pairs of an aggregate pixel and a mortar pixel that share an edge.
int leaks(const LabelledMask& mask) {
  int count = 0;
  const auto leak = [&](int row, int col, int row2, int col2) {
    if (!mask.labels.contains(row2, col2)) return;
    const int both = mask.labels(row, col) + mask.labels(row2, col2);
    count += both == phase::aggregate + phase::mortar && mask.labels(row, col) != phase::itz &&
             mask.labels(row, col) != phase::void_;
  };
  for (int row = 0; row < mask.labels.rows; ++row) {
    for (int col = 0; col < mask.labels.cols; ++col) {
      leak(row, col, row + 1, col);
      leak(row, col, row, col + 1);
    }
  }
  return count;
}

double distance_to_segment(Point p, Point from, Point to) {
  const Point along = to - from;
  const double t = dot(along, along) > 0 ? std::clamp(dot(p - from, along) / dot(along, along), 0.0, 1.0) : 0;
  return length(p - (from + t * along));
}

double distance_to_ring(Point p, const Ring& ring) {
  double least = infinite;
  for (std::size_t i = 0; i < ring.vertices.size(); ++i)
    least = std::min(least,
                     distance_to_segment(p, ring.vertices[i], ring.vertices[(i + 1) % ring.vertices.size()]));
  return least;
}

double signed_area(const std::vector<Point>& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sum += cross(polygon[i], polygon[(i + 1) % polygon.size()]) / 2;
  return sum;
}

Inclusion with_contour(std::vector<Point> contour) {
  Inclusion inclusion;
  inclusion.id = 1;
  inclusion.contour = std::move(contour);
  return inclusion;
}

Ring make_ring(const Inclusion& inclusion, int segments) { return make_rings(inclusion, segments).front(); }

TEST(Ring, FollowsALongContourUnlessToldOtherwise) {
  std::vector<Point> contour;
  for (int i = 0; i < 600; ++i) contour.push_back({std::cos(2 * pi * i / 600), std::sin(2 * pi * i / 600)});
  EXPECT_EQ(make_ring(with_contour(contour), 0).vertices.size(), 200u);
  EXPECT_EQ(make_ring(with_contour(contour), 36).vertices.size(), 36u);
  contour.resize(60);
  EXPECT_EQ(make_ring(with_contour(contour), 0).vertices.size(), 36u);
  EXPECT_EQ(make_ring(make_inclusion(1, {0, 0, 2, 1, 0}), 0).vertices.size(), 36u);
}

TEST(Ring, OfAGrainInPiecesWithAHoleAreThree) {
  const std::vector<Point> outer{{0, 0}, {6, 0}, {6, 6}, {0, 6}}, hole{{2, 2}, {2, 4}, {4, 4}, {4, 2}},
      piece{{9, 0}, {10, 0}, {10, 1}, {9, 1}};
  const std::vector<Ring> rings = make_rings(with_contour(contour_of({outer, piece, hole})), 8);
  ASSERT_EQ(rings.size(), 3u);
  EXPECT_NEAR(signed_area(rings[0].vertices), 36, 1e-9);
  EXPECT_NEAR(signed_area(rings[1].vertices), 1, 1e-9);
  EXPECT_NEAR(signed_area(rings[2].vertices), -4, 1e-9);
  for (const Ring& ring : rings) EXPECT_EQ(ring.inclusion, 1);
}

TEST(Ring, OfAnEllipseHas36CornersAtEqualSteps) {
  const Ellipse e{0.05, 0.04, 0.02, 0.01, 0.6};
  const Ring ring = make_ring(make_inclusion(3, e), 36);
  EXPECT_EQ(ring.inclusion, 3);
  ASSERT_EQ(ring.vertices.size(), 36u);
  for (int k = 0; k < 36; ++k) {
    const double t = 2 * pi * k / 36;
    EXPECT_NEAR(ring.vertices[k].x,
                0.05 + 0.02 * std::cos(t) * std::cos(0.6) - 0.01 * std::sin(t) * std::sin(0.6), 1e-16);
    EXPECT_NEAR(ring.vertices[k].y,
                0.04 + 0.02 * std::cos(t) * std::sin(0.6) + 0.01 * std::sin(t) * std::cos(0.6), 1e-16);
  }
  // A regular 36-gon in the circle the ellipse is the picture of; counter-clockwise.
  EXPECT_NEAR(signed_area(ring.vertices), 18 * std::sin(pi / 18) * e.a * e.b, 1e-17);
}

TEST(Ring, OfAContourIsCutAtEqualArcLength) {
  const Ring ring = make_ring(with_contour({{0, 0}, {8, 0}, {8, 1}, {0, 1}}), 36);  // 18 long: steps of 0.5
  ASSERT_EQ(ring.vertices.size(), 36u);
  EXPECT_EQ(ring.vertices[0], (Point{0, 0}));
  EXPECT_EQ(ring.vertices[5], (Point{2.5, 0}));
  EXPECT_EQ(ring.vertices[17], (Point{8, 0.5}));
  EXPECT_EQ(ring.vertices[19], (Point{7.5, 1}));
  EXPECT_EQ(ring.vertices[35], (Point{0, 0.5}));
  EXPECT_NEAR(signed_area(ring.vertices), 8, 1e-14);
}

TEST(Ring, OfAnyContourHasItsCornersOnIt) {
  Random random(1);
  for (const int count : {1, 2, 3, 7, 500}) {
    for (const int segments : {3, 36, 101}) {
      std::vector<Point> contour;
      double whole = 0;
      for (int i = 0; i < count; ++i) contour.push_back({random.uniform(), random.uniform()});
      for (int i = 0; i < count; ++i) whole += length(contour[(i + 1) % count] - contour[i]);
      const Ring ring = make_ring(with_contour(contour), segments);
      ASSERT_EQ(static_cast<int>(ring.vertices.size()), segments);
      for (std::size_t k = 0; k < ring.vertices.size(); ++k) {
        EXPECT_LT(distance_to_ring(ring.vertices[k], {0, contour}), 1e-12);
        const Point next = ring.vertices[(k + 1) % ring.vertices.size()];
        EXPECT_LT(length(next - ring.vertices[k]), whole / segments + 1e-12);  // a chord is shorter
      }
    }
  }
}

TEST(Ring, RefusesFewerThanThreeSegments) {
  try {
    (void)make_ring(make_inclusion(1, {0, 0, 1, 1, 0}), 2);
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "itz.segments: 2; must be between 3 and 100000; the paper's rings have 36");
  }
}

class RingsOfAPacking : public testing::Test {
 protected:
  static Segmented packed(double pixel_size) {
    PackingOptions options;
    options.width = options.height = 0.06;
    options.fraction = 0.5;
    return draw_ellipses(pack(options).ellipses, 0.06, 0.06, pixel_size);
  }
};

TEST_F(RingsOfAPacking, AreClosedAtAnyThickness) {
  for (const double pixel_size : {1 * mm, 0.5 * mm, 0.1 * mm}) {
    for (const double thickness : {0.001 * mm, 0.1 * mm, 0.5 * mm, 2 * mm}) {
      const Segmented before = packed(pixel_size);
      EXPECT_GT(leaks(before.mask), 0);
      LabelledMask mask = before.mask;
      for (const Inclusion& inclusion : before.inclusions)
        draw_ring(mask, before.instances, make_ring(inclusion, 36), thickness);
      EXPECT_EQ(leaks(mask), 0) << pixel_size << " " << thickness;
    }
  }
}

TEST_F(RingsOfAPacking, TakeJustTheMortarThatTheDefinitionSays) {
  const Segmented before = packed(0.5 * mm);
  for (const double thickness : {0.5 * mm, 1.7 * mm}) {
    LabelledMask mask = before.mask;
    const Inclusion& inclusion = before.inclusions[4];
    const Ring ring = make_ring(inclusion, 36);
    draw_ring(mask, before.instances, ring, thickness);
    for (int row = 0; row < mask.labels.rows; ++row) {
      for (int col = 0; col < mask.labels.cols; ++col) {
        bool touches = false;
        for (const auto& [r, c] : {std::pair{row - 1, col}, {row + 1, col}, {row, col - 1}, {row, col + 1}})
          touches = touches || (mask.labels.contains(r, c) && before.instances(r, c) == inclusion.id);
        const double distance = distance_to_ring(mask.centre(row, col), ring);
        if (std::abs(distance - thickness) < 1e-12) continue;
        const bool taken = before.mask.labels(row, col) == phase::mortar && (touches || distance < thickness);
        ASSERT_EQ(mask.labels(row, col), taken ? phase::itz : before.mask.labels(row, col))
            << row << " " << col;
      }
    }
  }
}

TEST_F(RingsOfAPacking, DrawnTogetherAreThoseDrawnOneByOne) {
  const Segmented before = packed(0.25 * mm);
  LabelledMask together = before.mask, one_by_one = before.mask;
  std::vector<Ring> rings;
  for (const Inclusion& inclusion : before.inclusions) rings.push_back(make_ring(inclusion, 36));
  draw_rings(together, before.instances, rings, 0.5 * mm);
  for (auto ring = rings.rbegin(); ring != rings.rend(); ++ring)
    draw_ring(one_by_one, before.instances, *ring, 0.5 * mm);
  EXPECT_EQ(together, one_by_one);
}

// Steiner: the collar of thickness t outside a convex polygon has the area P t + pi t^2. The polygon lies
// inside the ellipse; what is between the two is aggregate.
TEST(Ring, HasTheAreaOfItsThickness) {
  const Ellipse e{0.05, 0.05, 0.025, 0.015, 0.4};
  for (const int segments : {6, 36, 360}) {
    for (const double thickness : {1 * mm, 3 * mm, 8 * mm}) {
      Segmented drawn = draw_ellipses({e}, 0.1, 0.1, 0.1 * mm);
      const Ring ring = make_ring(drawn.inclusions[0], segments);
      draw_ring(drawn.mask, drawn.instances, ring, thickness);
      const double itz = static_cast<double>(count_labels(drawn.mask)[phase::itz]) * 0.1 * mm * 0.1 * mm;
      double around = 0;
      for (std::size_t i = 0; i < ring.vertices.size(); ++i)
        around += length(ring.vertices[(i + 1) % ring.vertices.size()] - ring.vertices[i]);
      if (segments == 6 && thickness < 3 * mm) continue;  // the ellipse bulges through so thin a ring
      const double collar = around * thickness + pi * thickness * thickness;
      EXPECT_NEAR(itz / (collar - (area(e) - signed_area(ring.vertices))), 1, 0.01)
          << segments << " " << thickness;
      if (segments == 360) {
        EXPECT_NEAR(itz / (perimeter(e) * thickness + pi * thickness * thickness), 1, 0.01);
      }
    }
  }
}

TEST(Ring, ChangesMortarAlone) {
  Segmented drawn = draw_ellipses({{0.05, 0.05, 0.02, 0.02, 0}}, 0.1, 0.1, 1 * mm);
  const std::uint8_t fibre = label_of(drawn.mask.phases, "fibre");
  for (int k = 0; k < 100; ++k) {
    drawn.mask.labels(28, k) = fibre;
    drawn.mask.labels(k, 71) = phase::void_;
  }
  const LabelledMask before = drawn.mask;
  draw_ring(drawn.mask, drawn.instances, make_ring(drawn.inclusions[0], 36), 4 * mm);
  EXPECT_GT(count_labels(drawn.mask)[phase::itz], 300);
  for (std::size_t i = 0; i < before.labels.size(); ++i) {
    if (before.labels.data[i] != phase::mortar) {
      EXPECT_EQ(drawn.mask.labels.data[i], before.labels.data[i]);
    }
  }
}

// Two square grains that share an edge, as in a picture: both have a ring, and one of them gives the pixels
// along their edge to it.
TEST(Ring, OfTouchingGrainsAreTwo) {
  Segmented drawn;
  drawn.mask = {{20, 30, phase::mortar}, 1, standard_phases()};
  drawn.instances = {20, 30, 0};
  for (int row = 5; row < 15; ++row) {
    for (int col = 5; col < 25; ++col) {
      drawn.mask.labels(row, col) = phase::aggregate;
      drawn.instances(row, col) = col < 15 ? 1 : 2;
    }
  }
  drawn.inclusions = {with_contour({{5, 5}, {15, 5}, {15, 15}, {5, 15}}),
                      with_contour({{15, 5}, {25, 5}, {25, 15}, {15, 15}})};
  drawn.inclusions[1].id = 2;

  LabelledMask only_first = drawn.mask;
  draw_ring(only_first, drawn.instances, make_ring(drawn.inclusions[0], 36), 0.1);
  EXPECT_EQ(only_first.labels(10, 4), phase::itz);
  EXPECT_EQ(only_first.labels(10, 25), phase::mortar);
  EXPECT_EQ(count_labels(only_first)[phase::itz], 30);

  const Specimen specimen = make_specimen(drawn, {ItzMode::ring, 0.1, 36}, {});
  EXPECT_EQ(specimen.rings.size(), 2u);
  EXPECT_EQ(count_labels(specimen.mask)[phase::itz], 60 + 10);
  EXPECT_EQ(count_labels(specimen.mask)[phase::aggregate], 200 - 10);
  for (int row = 5; row < 15; ++row) EXPECT_EQ(specimen.mask.labels(row, 15), phase::itz);
  EXPECT_EQ(leaks(specimen.mask), 0);
}

// A polygon of three corners passes far from the grain; the ring is closed all the same, also in its hole.
TEST(Ring, IsClosedRoundAGrainThatThePolygonMisses) {
  Segmented drawn;
  drawn.mask = {{30, 30, phase::mortar}, 1, standard_phases()};
  drawn.instances = {30, 30, 0};
  for (int k = 2; k < 28; ++k) {
    for (const auto& [row, col] : {std::pair{2, k}, {27, k}, {k, 2}, {k, 27}}) {
      drawn.mask.labels(row, col) = phase::aggregate;
      drawn.instances(row, col) = 1;
    }
  }
  draw_ring(drawn.mask, drawn.instances, make_ring(with_contour({{2, 2}, {28, 2}, {28, 28}, {2, 28}}), 3),
            0.5);
  EXPECT_EQ(leaks(drawn.mask), 0);
}

TEST(Ring, StaysInsideTheSpecimen) {
  Segmented drawn = draw_ellipses({{0.01, 0.01, 0.01, 0.01, 0}}, 0.02, 0.02, 1 * mm);
  draw_ring(drawn.mask, drawn.instances, make_ring(drawn.inclusions[0], 36), 1.0);  // thicker than it all
  EXPECT_EQ(count_labels(drawn.mask)[phase::mortar], 0);
}

TEST(Ring, RefusesAThicknessOrAShapeThatDoesNotFit) {
  Segmented drawn = draw_ellipses({{0.01, 0.01, 0.005, 0.005, 0}}, 0.02, 0.02, 1 * mm);
  const Ring ring = make_ring(drawn.inclusions[0], 36);
  const auto refusal = [&](const Raster<std::int32_t>& instances, double thickness) -> std::string {
    try {
      draw_ring(drawn.mask, instances, ring, thickness);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal(drawn.instances, 0), "itz.thickness: 0 mm; must be > 0");
  EXPECT_EQ(refusal(drawn.instances, not_a_number), "itz.thickness: nan mm; must be > 0");
  EXPECT_EQ(refusal({10, 20, 0}, 1 * mm),
            "instances: 20 x 10 pixels; must have the shape of the mask, 20 x 20 pixels");
}

}  // namespace ring_test
}  // namespace specimen
