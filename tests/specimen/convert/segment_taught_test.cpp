#include "specimen/convert/segment_taught.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "specimen/body/error.hpp"
#include "tests/specimen/dressed.hpp"
#include "tests/specimen/scratch.hpp"

namespace segment_taught_test {

using specimen::Converted;
using specimen::ConvertOptions;
using specimen::no_stroke;
using specimen::Picture;
using specimen::Raster;
using ::testing::Contains;
using ::testing::HasSubstr;

namespace phase = specimen::phase;

Picture photo_of(const specimen_test::KnownTruth& truth, std::uint64_t seed = 1, double fall = 0) {
  Picture picture;
  picture.colour = specimen_test::dressed(truth.labels, seed, fall);
  return picture;
}

/// Strokes pixel by pixel.
std::vector<specimen::StrokeLine> lines_of(const Raster<std::uint8_t>& strokes) {
  std::vector<specimen::StrokeLine> lines;
  for (int r = 0; r < strokes.rows; ++r)
    for (int c = 0; c < strokes.cols; ++c)
      if (strokes(r, c) != no_stroke)
        lines.push_back({specimen::standard_phases()[strokes(r, c)], 1, {{c + 0.5, r + 0.5}}, "s"});
  return lines;
}

class SegmentTaught : public ::testing::Test {
 protected:
  void SetUp() override {
    options_.source_pixel_size = 1e-4;
    options_.strokes = scratch_.write("s.png", specimen_test::stroke_layer(strokes_));
  }
  std::string complaint_of(const ConvertOptions& options) {
    try {
      (void)specimen::convert_picture(photo_of(truth_), options);
    } catch (const specimen::Error& error) {
      return error.what();
    }
    return "no complaint";
  }
  specimen_test::Scratch scratch_;
  specimen_test::KnownTruth truth_ = specimen_test::large_truth();
  Raster<std::uint8_t> strokes_ = specimen_test::some_strokes(truth_.labels, 6, 9);
  ConvertOptions options_;
};

double iou_of(const Converted& found, const specimen_test::KnownTruth& truth, std::uint8_t label) {
  specimen::LabelledMask mask;
  mask.labels = truth.labels;
  return specimen::intersection_over_union(found.segmented.mask, mask)[label];
}

TEST_F(SegmentTaught, StonesAndPoresComeOutAsTheyAre) {
  const Converted found = specimen::convert_picture(photo_of(truth_), options_);
  EXPECT_EQ(found.report.method, specimen::Segmentation::taught);
  EXPECT_GT(iou_of(found, truth_, phase::aggregate), 0.9);
  EXPECT_GT(iou_of(found, truth_, phase::mortar), 0.93);
  EXPECT_EQ(found.segmented.inclusions.size(), truth_.stones.size());
  EXPECT_LT(found.report.uncertain, 0.1);
  EXPECT_EQ(found.uncertain.rows, found.photograph.rows);
  EXPECT_EQ(found.uncertain.cols, found.photograph.cols);
  EXPECT_THAT(found.report.notes, Contains(HasSubstr("taught void by 3 strokes of 81 pixels")));
  EXPECT_THAT(found.report.notes, Contains(HasSubstr("of the area is uncertain")));
}

TEST_F(SegmentTaught, LabelsOfLinesAreThoseOfThePaintedStrokes) {
  ConvertOptions lines = options_;
  lines.strokes.clear();
  lines.stroke_lines = lines_of(strokes_);
  EXPECT_EQ(specimen::convert_picture(photo_of(truth_), lines).segmented.mask.labels,
            specimen::convert_picture(photo_of(truth_), options_).segmented.mask.labels);
}

TEST_F(SegmentTaught, ModelSortsThePictureAsItsStrokesDidAndAnotherOneToo) {
  const Converted taught = specimen::convert_picture(photo_of(truth_), options_);
  ConvertOptions by_model;
  by_model.source_pixel_size = 1e-4;
  by_model.model = scratch_.write("m.mesomodel", taught.model);
  const Converted again = specimen::convert_picture(photo_of(truth_), by_model);
  EXPECT_EQ(again.segmented.mask.labels, taught.segmented.mask.labels);
  EXPECT_TRUE(again.model.empty());
  EXPECT_GT(iou_of(specimen::convert_picture(photo_of(truth_, 2), by_model), truth_, phase::aggregate), 0.88);
  by_model.source_pixel_size = 3e-4;
  EXPECT_THAT(specimen::convert_picture(photo_of(truth_), by_model).report.notes,
              Contains(HasSubstr("the model was taught with pixels of 0.1 mm, this picture has 0.3 mm")));
}

TEST_F(SegmentTaught, CropKeepsTheStrokesOverThePicture) {
  options_.crop = {30, 60, 420, 270};
  const Converted part = specimen::convert_picture(photo_of(truth_), options_);
  int right = 0;
  for (int r = 0; r < 270; ++r)
    for (int c = 0; c < 420; ++c) right += part.segmented.mask.labels(r, c) == truth_.labels(r + 60, c + 30);
  EXPECT_GT(right, 0.96 * 420 * 270);
}

TEST_F(SegmentTaught, LightThatFallsOffIsEvenedOutIfAskedFor) {
  options_.even_light = true;
  const Converted even = specimen::convert_picture(photo_of(truth_, 1, 0.6), options_);
  EXPECT_THAT(even.report.notes, Contains(HasSubstr("evened out the light")));
  EXPECT_GT(iou_of(even, truth_, phase::aggregate), 0.8);
}

TEST_F(SegmentTaught, CutStrokePartsAStoneInTwo) {
  const auto& stone = *std::max_element(truth_.stones.begin(), truth_.stones.end(),
                                        [](const auto& a, const auto& b) { return a.radius < b.radius; });
  for (int r = static_cast<int>(stone.row - stone.radius) - 2; r < stone.row + stone.radius + 2; ++r)
    for (int wide = 0; wide < 2; ++wide)
      strokes_(r, static_cast<int>(stone.col) + wide) = specimen::cut_stroke;
  options_.strokes = scratch_.write("s.png", specimen_test::stroke_layer(strokes_));
  const Converted found = specimen::convert_picture(photo_of(truth_), options_);
  EXPECT_EQ(found.segmented.inclusions.size(), truth_.stones.size() + 1);
  EXPECT_THAT(found.report.notes, Contains(HasSubstr("aggregates along strokes into")));
  const auto row = static_cast<int>(stone.row), col = static_cast<int>(stone.col);
  EXPECT_NE(found.segmented.instances(row, col - 3), found.segmented.instances(row, col + 3));
  EXPECT_EQ(found.segmented.mask.labels(row, col), phase::aggregate);
}

TEST_F(SegmentTaught, OneGrainStrokeMakesOneStoneOfTwoAndUndoesACut) {
  const auto& stones = truth_.stones;
  ConvertOptions lines = options_;
  lines.strokes.clear();
  lines.stroke_lines = lines_of(strokes_);
  const auto count = specimen::convert_picture(photo_of(truth_), lines).segmented.inclusions.size();
  const auto line_through = [](const char* phase, const auto& a, const auto& b) {
    return specimen::StrokeLine{phase, 2, {{a.col, a.row}, {b.col, b.row}}, "s"};
  };
  const auto& first = stones.front();
  specimen::StrokeLine cut = line_through("cut", first, first);
  cut.points = {{first.col, first.row - first.radius - 3}, {first.col, first.row + first.radius + 3}};
  lines.stroke_lines.push_back(cut);
  EXPECT_EQ(specimen::convert_picture(photo_of(truth_), lines).segmented.inclusions.size(), count + 1);
  lines.stroke_lines.push_back(
      {"one-grain", 2, {{first.col - 6, first.row}, {first.col + 6, first.row}}, "s"});
  EXPECT_EQ(specimen::convert_picture(photo_of(truth_), lines).segmented.inclusions.size(), count);
  lines.stroke_lines.push_back(line_through("one-grain", first, stones.back()));
  const Converted found = specimen::convert_picture(photo_of(truth_), lines);
  EXPECT_LT(found.segmented.inclusions.size(), count);
  const auto grain_at = [&](const auto& stone) {
    return found.segmented.instances(static_cast<int>(stone.row), static_cast<int>(stone.col));
  };
  EXPECT_EQ(grain_at(first), grain_at(stones.back()));
  EXPECT_THAT(found.report.notes, Contains(HasSubstr("along strokes into")));
  lines.crop = {0, 0, truth_.cols, truth_.rows - 60};  // the marks are cut as the strokes are
  EXPECT_NO_THROW((void)specimen::convert_picture(photo_of(truth_), lines));
}

TEST_F(SegmentTaught, StrokesOfAnotherSizeAreRefused) {
  options_.strokes =
      scratch_.write("t.png", specimen_test::stroke_layer(Raster<std::uint8_t>(40, 50, no_stroke)));
  EXPECT_EQ(complaint_of(options_),
            options_.strokes +
                ": 50 x 40 px; strokes must have the size of the whole picture, 480 x 360 px; paint "
                "them on a layer over the picture itself, and save this layer without trimming it");
}

TEST_F(SegmentTaught, GreyPictureIsSortedByItsTexture) {
  Picture grey;
  Raster<std::uint8_t> values(truth_.rows, truth_.cols);
  const auto colour = specimen_test::dressed(truth_.labels, 1);
  for (std::size_t i = 0; i < values.size(); ++i) values.data[i] = colour.data[i].g;
  grey.gray = specimen::GreyLevels(std::move(values));
  EXPECT_GT(iou_of(specimen::convert_picture(std::move(grey), options_), truth_, phase::aggregate), 0.8);
}

}  // namespace segment_taught_test
