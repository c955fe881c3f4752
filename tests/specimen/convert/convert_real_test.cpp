/// Real pictures: they are not part of the project, so these tests are skipped where they are not at hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "specimen/convert/convert.hpp"

namespace convert_real_test {

using specimen::convert_picture;
using specimen::Converted;
using specimen::ConvertOptions;
using specimen::Segmentation;

/// Folder of the real pictures: MESOPIX_PICTURES, or shared/images in or beside the source tree.
std::string folder() {
  if (const char* given = std::getenv("MESOPIX_PICTURES")) return given;
  for (const char* place : {"shared/images", "../shared/images"}) {
    const auto path = std::filesystem::path(MESOPIX_SOURCE_DIR) / place;
    if (std::filesystem::is_directory(path)) return path.string();
  }
  return "";
}

class RealPictures : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::is_directory(folder()))
      GTEST_SKIP() << "the real pictures are not at hand; MESOPIX_PICTURES names their folder";
  }
  static Converted convert(const std::string& name, const ConvertOptions& options) {
    return convert_picture(folder() + "/" + name, options);
  }
  static double share(const Converted& converted, std::uint8_t label) {
    return static_cast<double>(specimen::count_labels(converted.segmented.mask)[label]) /
           static_cast<double>(converted.segmented.mask.labels.size());
  }
  /// Label at a place of the picture, both coordinates as shares of its size, from the top left.
  static int label_at(const Converted& converted, double x, double y) {
    const auto& labels = converted.segmented.mask.labels;
    return labels(static_cast<int>(y * labels.rows), static_cast<int>(x * labels.cols));
  }
};

constexpr int void_ = specimen::phase::void_, aggregate = specimen::phase::aggregate,
              mortar = specimen::phase::mortar;

TEST_F(RealPictures, TwoAggregatesInPinkMortar) {
  ConvertOptions options;
  options.pixels = 300;
  const Converted cut = convert("concrete_cut_two_aggregates.jpg", options);
  EXPECT_EQ(cut.segmented.mask.labels.cols, 300);
  EXPECT_EQ(cut.segmented.mask.labels.rows, 324);
  EXPECT_NEAR(cut.segmented.mask.width(), 22.3e-3, 0.1e-3);
  EXPECT_NEAR(share(cut, specimen::phase::aggregate), 0.47, 0.03);
  int large = 0;
  for (const auto& inclusion : cut.segmented.inclusions) large += inclusion.equivalent_diameter > 5e-3;
  EXPECT_EQ(large, 2);
  EXPECT_LE(cut.segmented.inclusions.size(), 5U);
  for (const double y : {0.15, 0.3, 0.5, 0.7}) EXPECT_EQ(label_at(cut, 0.3, y), aggregate);
  for (const double y : {0.3, 0.5, 0.65}) EXPECT_EQ(label_at(cut, 0.9, y), aggregate);
  for (const double y : {0.1, 0.3, 0.6, 0.9}) EXPECT_EQ(label_at(cut, 0.6, y), mortar);
  EXPECT_EQ(label_at(cut, 0.315, 0.885), void_);
}

TEST_F(RealPictures, VoidsAmongAggregates) {
  ConvertOptions options;
  options.pixels = 300;
  const Converted cut = convert("concrete_cut_voids.jpg", options);
  EXPECT_NEAR(share(cut, specimen::phase::aggregate), 0.51, 0.03);
  EXPECT_NEAR(share(cut, specimen::phase::void_), 0.04, 0.015);
  EXPECT_EQ(label_at(cut, 0.95, 0.6), void_);
  EXPECT_EQ(label_at(cut, 0.40, 0.55), void_);
  EXPECT_EQ(label_at(cut, 0.77, 0.05), void_);
  EXPECT_EQ(label_at(cut, 0.50, 0.15), aggregate);
  EXPECT_EQ(label_at(cut, 0.20, 0.40), aggregate);
  EXPECT_EQ(label_at(cut, 0.25, 0.85), aggregate);
  EXPECT_EQ(label_at(cut, 0.95, 0.15), aggregate);
  EXPECT_EQ(label_at(cut, 0.60, 0.45), mortar);
  EXPECT_EQ(label_at(cut, 0.75, 0.85), mortar);
}

TEST_F(RealPictures, GravelAgainstItsHandMadeInstances) {
  ConvertOptions options;
  options.source_pixel_size = 0.39e-3;
  const Converted reference = convert("conglomerate_instances.tif", options);
  EXPECT_EQ(reference.report.method, Segmentation::instances);
  EXPECT_EQ(reference.segmented.inclusions.size(), 45U);
  const Converted found = convert("conglomerate.jpg", options);
  const auto iou = specimen::intersection_over_union(found.segmented.mask, reference.segmented.mask);
  RecordProperty("iou_aggregate", std::to_string(iou[specimen::phase::aggregate]));
  EXPECT_GT(iou[specimen::phase::aggregate], 0.6);
  EXPECT_GT(iou[specimen::phase::mortar], 0.85);
}

TEST_F(RealPictures, FivePhasesOfFibreConcrete) {
  ConvertOptions options;
  options.width = 0.1;
  options.label_phases = {{0, "void"}, {1, "mortar"}, {2, "aggregate"}, {3, "fibre"}, {255, "void"}};
  options.drop_islands = 1e-6;
  const Converted disc = convert("fibre_concrete_labels.png", options);
  EXPECT_EQ(disc.segmented.mask.phases.back(), "fibre");
  EXPECT_NEAR(share(disc, 4), 0.021, 0.003);
  EXPECT_EQ(label_at(disc, 0.01, 0.01), void_);
  EXPECT_LT(disc.segmented.inclusions.size(), 80U);  // 651 with its specks
  options.label_phases.clear();
  const Converted guessed = convert("fibre_concrete_labels.png", options);
  EXPECT_EQ(label_at(guessed, 0.01, 0.01), void_);
  EXPECT_EQ(guessed.report.method, Segmentation::labels);
}

TEST_F(RealPictures, CrackedMortarAsLabelsAndAsPhotograph) {
  ConvertOptions options;
  options.width = 0.1;
  options.label_phases = {{0, "void"}, {1, "mortar"}, {2, "crack"}, {3, "void"}};
  const Converted labels = convert("cracked_mortar_labels.tiff", options);
  EXPECT_NEAR(share(labels, specimen::phase::mortar), 0.78, 0.01);
  EXPECT_TRUE(labels.segmented.inclusions.empty());
  options.label_phases.clear();
  const Converted photograph = convert("cracked_mortar.png", options);
  EXPECT_EQ(label_at(photograph, 0.5, 0.95), void_);
  EXPECT_EQ(label_at(photograph, 0.477, 0.72), void_);  // the crack
  EXPECT_EQ(label_at(photograph, 0.2, 0.5), mortar);
}

TEST_F(RealPictures, OverlappingEllipsesCleanAndNoisy) {
  for (const char* name : {"ellipses.png", "ellipses-noise.png"}) {
    ConvertOptions options;
    options.width = 0.1;
    const Converted ellipses = convert(name, options);
    EXPECT_EQ(ellipses.segmented.inclusions.size(), 5U) << name;
    EXPECT_NEAR(share(ellipses, specimen::phase::mortar), 0.52, 0.005) << name;
  }
}

}  // namespace convert_real_test
