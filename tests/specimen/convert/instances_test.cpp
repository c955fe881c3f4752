#include "specimen/convert/instances.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/specimen/known_truth.hpp"

namespace instances_test {

using specimen::GrainMap;
using specimen::Raster;
using specimen::understand_grains;
using specimen::ValueMap;
using specimen_test::known_truth;
using specimen_test::picture_of;

/// The stones numbered, the rest another value.
Raster<double> numbered(double background, double factor = 1, double shift = 0) {
  const auto truth = known_truth();
  Raster<double> gray(truth.rows, truth.cols);
  for (std::size_t i = 0; i < gray.size(); ++i)
    gray.data[i] = truth.instances.data[i] == 0 ? background : shift + factor * truth.instances.data[i];
  return gray;
}

ValueMap map_of(const Raster<double>& gray) {
  return *distinct_values(picture_of(gray), specimen::most_grains);
}

TEST(Instances, TheBackgroundIsWhatLiesBetweenWhateverItsNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double background : {0.0, 1.0, -1.0, 255.0, 70'000'000.0, nan}) {
    const ValueMap map = map_of(numbered(background, 70001, 1000));
    EXPECT_TRUE(looks_like_grains(map)) << background;
    const GrainMap grains = understand_grains(map);
    ASSERT_GE(grains.matrix, 0);
    const std::int64_t value = map.values[static_cast<std::size_t>(grains.matrix)];
    EXPECT_EQ(value, std::isnan(background) ? specimen::no_number : static_cast<std::int64_t>(background));
    EXPECT_EQ(grains.line, -1);
    EXPECT_TRUE(grains.voids.empty());
  }
}

// As cv2.watershed leaves it: 1 between the grains, -1 round each of them and along the border of the
// picture.
TEST(Instances, LinesBetweenRegionsAreNoMatrix) {
  Raster<double> gray = numbered(1, 1, 1);
  const Raster<double> before = gray;
  for (int r = 0; r < gray.rows; ++r)
    for (int c = 0; c < gray.cols; ++c) {
      bool edge = r == 0 || c == 0 || r + 1 == gray.rows || c + 1 == gray.cols;
      for (const auto& [dr, dc] : {std::pair(1, 0), {0, 1}, {1, 1}, {-1, 0}, {0, -1}})
        edge = edge || (before.contains(r + dr, c + dc) && before(r + dr, c + dc) > 1 && before(r, c) == 1);
      if (edge) gray(r, c) = -1;
    }
  ValueMap map = map_of(gray);
  EXPECT_TRUE(looks_like_grains(map));
  const GrainMap grains = understand_grains(map);
  EXPECT_EQ(map.values[static_cast<std::size_t>(grains.matrix)], 1);
  ASSERT_GE(grains.line, 0);
  EXPECT_EQ(map.values[static_cast<std::size_t>(grains.line)], -1);
  dissolve_line(map, grains);
  for (const std::int32_t code : map.code.data) ASSERT_NE(code, grains.line);
  for (std::size_t i = 0; i < gray.size(); ++i) {
    if (before.data[i] != 1) continue;
    ASSERT_EQ(map.code.data[i], grains.matrix);
  }
}

TEST(Instances, FewGrainsOrManyPiecesAreNone) {
  Raster<double> gray = numbered(0);
  for (double& v : gray.data) v = v > 0 ? std::fmod(v, 3) + 1 : 0;
  EXPECT_FALSE(looks_like_grains(map_of(gray))) << "three kinds of stones";
}

TEST(Instances, DotsWithoutNumbersAreVoid) {
  Raster<double> gray = numbered(1, 1, 1);
  const auto truth = known_truth();
  for (std::size_t i = 0; i < gray.size(); ++i)
    if (truth.labels.data[i] == 0) gray.data[i] = 0;
  const GrainMap grains = understand_grains(map_of(gray));
  EXPECT_EQ(grains.matrix, 1);
  EXPECT_EQ(grains.voids, (std::vector<std::int32_t>{0}));
}

}  // namespace instances_test
