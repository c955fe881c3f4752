#include "specimen/teach/taught.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "specimen/body/error.hpp"
#include "specimen/body/mask.hpp"
#include "specimen/convert/strokes.hpp"
#include "tests/specimen/dressed.hpp"

namespace taught_test {

using specimen::PixelFeatures;
using specimen::Raster;
using specimen::TaughtModel;
using specimen::TeachingReport;

PixelFeatures features_of(const specimen_test::KnownTruth& truth) {
  return {specimen::to_lab(specimen_test::dressed(truth.labels, 1)), 4, 1};
}

std::string complaint_of(const Raster<std::uint8_t>& strokes, const std::vector<std::string>& names) {
  TeachingReport report;
  try {
    (void)specimen::teach({Raster<specimen::Lab>(strokes.rows, strokes.cols), 3, 1}, strokes, names, 1,
                          report);
  } catch (const specimen::Error& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(Teach, PixelsAwayFromTheStrokesAreSorted) {
  const auto truth = specimen_test::large_truth();
  const PixelFeatures features = features_of(truth);
  const auto strokes = specimen_test::some_strokes(truth.labels, 6, 9);
  TeachingReport report;
  const TaughtModel model = specimen::teach(features, strokes, specimen::standard_phases(), 2, report);
  EXPECT_EQ(model.phases, (std::vector<std::string>{"void", "aggregate", "mortar"}));
  const auto shares = specimen::ask(model, features, 2);
  double right = 0;
  for (int r = 0; r < truth.rows; ++r)
    for (int c = 0; c < truth.cols; ++c) {
      const std::uint8_t* share = shares.at(r, c);
      right += std::max_element(share, share + 3) - share == truth.labels(r, c);
    }
  EXPECT_GT(right / static_cast<double>(truth.labels.size()), 0.93);
  EXPECT_EQ(shares.data, specimen::ask(model, features, 1).data);
}

TEST(Teach, TellsStrokesAndCellsOfEachPhase) {
  const auto truth = specimen_test::large_truth();
  TeachingReport report;
  (void)specimen::teach(features_of(truth), specimen_test::some_strokes(truth.labels, 5, 8),
                        specimen::standard_phases(), 1, report);
  ASSERT_EQ(report.phases.size(), 3U);
  EXPECT_EQ(report.phases[1].phase, "aggregate");
  EXPECT_EQ(report.phases[1].strokes, 5);
  EXPECT_EQ(report.phases[1].cells, 5 * 8 * 3);
  EXPECT_GT(report.phases[1].right, 0.8);
}

TEST(Teach, TooFewStrokesAreRefused) {
  Raster<std::uint8_t> strokes(30, 30, specimen::no_stroke);
  const auto names = specimen::standard_phases();
  EXPECT_EQ(complaint_of(strokes, names),
            "convert.strokes: no stroke of a phase; at least two phases need a stroke; paint one on each "
            "phase that "
            "the picture shows");
  for (int c = 0; c < 20; ++c) strokes(3, c) = specimen::phase::mortar;
  EXPECT_THAT(complaint_of(strokes, names),
              ::testing::HasSubstr("strokes of mortar only; at least two phases"));
  for (int c = 0; c < 5; ++c) strokes(9, c) = specimen::phase::aggregate;
  EXPECT_EQ(complaint_of(strokes, names),
            "convert.strokes: 5 pixels of the phase aggregate; at least 10 are needed to learn from; paint a "
            "longer "
            "stroke");
  for (int c = 0; c < 15; ++c) strokes(9, c) = specimen::phase::aggregate;
  auto with_fibre = names;
  with_fibre.emplace_back("fibre");
  EXPECT_EQ(complaint_of(strokes, with_fibre),
            "convert.strokes: no stroke of the phase fibre; every phase that is named needs one; paint one, "
            "or leave "
            "the name out");
  EXPECT_EQ(complaint_of(strokes, names), "no complaint");
}

TEST(Ask, TilesAreTheWhole) {
  const auto truth = specimen_test::large_truth();
  const PixelFeatures features = features_of(truth);
  TeachingReport report;
  const TaughtModel model = specimen::teach(features, specimen_test::some_strokes(truth.labels, 6, 9),
                                            specimen::standard_phases(), 1, report);
  const auto whole = specimen::ask(model, features, 1);
  specimen::ClassShares tiles(truth.rows, truth.cols, 3);
  for (int row = 0; row < truth.rows; row += 50)
    for (int col = 0; col < truth.cols; col += 70)
      specimen::ask_tile(model, features, row, col, std::min(50, truth.rows - row),
                         std::min(70, truth.cols - col), tiles);
  EXPECT_EQ(tiles.data, whole.data);
}

}  // namespace taught_test
