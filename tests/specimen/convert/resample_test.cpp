#include "specimen/convert/resample.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "specimen/body/error.hpp"
#include "tests/specimen/drawn.hpp"

namespace resample_test {

using specimen::Cell;
using specimen::choose_mask_size;
using specimen::Raster;
using specimen::resampled;
using specimen::Resampling;
using specimen_test::cells_of;
using specimen_test::text_of;
using Rows = std::vector<std::string>;

TEST(Resample, CellsComeBackToThePixelsThatTheyWereMadeOf) {
  Raster<specimen::Cell> cells(2, 3);
  cells.data = {0, 1, 2, 1, 2, 0};
  const Raster<specimen::Cell> whole = specimen::at_centres(cells, {3, 5, 2, 3, 5});
  EXPECT_EQ(whole.data, (std::vector<specimen::Cell>{0, 0, 1, 1, 2, 0, 0, 1, 1, 2, 1, 1, 2, 2, 0}));
}

TEST(Resample, TheSameSizeChangesNothing) {
  const auto cells = cells_of({"12.", "1 .", "...", "333"});
  EXPECT_EQ(resampled(cells, choose_mask_size(4, 3, 1, 3)), cells);
}

TEST(Resample, PhasesVoteBeforeGrains) {
  const auto cells = cells_of({"1.", ".2", "1.", ".."});
  const auto mask = resampled(cells, Resampling{4, 2, 1, 2, 1});
  EXPECT_EQ(text_of(mask), (Rows{"1", "."}));  // 2 : 2 in the upper half goes to the lower label
  // Aggregate has 5 of 9 pixels, though mortar has more of them than either grain.
  EXPECT_EQ(text_of(resampled(cells_of({"112", "2..", "1.."}), Resampling{3, 3, 1, 1, 1})), (Rows{"1"}));
}

TEST(Resample, AVoteCountsPartsOfPixels) {
  // Three columns onto two: the middle one gives half of itself to each side.
  const auto cells = cells_of({"a..", "a..", "a..", "a.."});
  const Resampling to = choose_mask_size(4, 3, 1, 2);
  EXPECT_EQ(to.rows, 2);
  EXPECT_EQ(text_of(resampled(cells, to)), (Rows{"a.", "a."}));
}

TEST(Resample, AreasAreKeptOnAverage) {
  Raster<Cell> cells(700, 700, specimen::phase::mortar);
  specimen_test::draw_disc(cells, 333, 381, 200, Cell{specimen::phase::aggregate});
  const auto mask = resampled(cells, choose_mask_size(700, 700, 1, 151));
  std::int64_t before = 0, after = 0;
  for (const Cell cell : cells.data) before += cell == specimen::phase::aggregate;
  for (const Cell cell : mask.data) after += cell == specimen::phase::aggregate;
  const double scale = (700.0 / 151) * (700.0 / 151);
  EXPECT_NEAR(static_cast<double>(after) * scale / static_cast<double>(before), 1, 0.005);
}

/// Discs of aggregate in mortar, each with a ring of ITZ.
Raster<Cell> discs_with_itz(int size, double thickness) {
  Raster<Cell> cells(size, size, specimen::phase::mortar);
  for (const auto& [x, y, radius] : {std::tuple{0.3, 0.3, 0.19}, {0.7, 0.65, 0.2}, {0.25, 0.75, 0.12}}) {
    specimen_test::draw_disc(cells, y * size, x * size, radius * size + thickness,
                             Cell{specimen::phase::itz});
    specimen_test::draw_disc(cells, y * size, x * size, radius * size, Cell{specimen::phase::aggregate});
  }
  return cells;
}

double share_of(const Raster<Cell>& cells, std::uint8_t phase) {
  double count = 0;
  for (const Cell cell : cells.data) count += specimen::phase_of(cell) == phase ? 1 : 0;
  return count / static_cast<double>(cells.size());
}

TEST(Resample, AnItzThinnerThanAPixelStaysARing) {
  const Raster<Cell> cells = discs_with_itz(400, 1.2);
  const double aggregate = share_of(cells, specimen::phase::aggregate);
  for (const int pixels : {300, 200, 100, 50}) {
    const Raster<Cell> mask = resampled(cells, choose_mask_size(400, 400, 1, pixels));
    EXPECT_NEAR(share_of(mask, specimen::phase::aggregate), aggregate, 0.001) << pixels;
    int open = 0;  // edges between aggregate and mortar
    for (int r = 0; r < mask.rows; ++r)
      for (int c = 0; c + 1 < mask.cols; ++c)
        open += specimen::is_aggregate(mask(r, c)) && mask(r, c + 1) == specimen::phase::mortar;
    EXPECT_EQ(open, 0) << pixels;
    EXPECT_GT(share_of(mask, specimen::phase::itz), share_of(cells, specimen::phase::itz)) << pixels;
  }
}

TEST(Resample, AThickItzKeepsItsArea) {
  const Raster<Cell> cells = discs_with_itz(400, 16);
  const Raster<Cell> mask = resampled(cells, choose_mask_size(400, 400, 1, 200));
  EXPECT_NEAR(share_of(mask, specimen::phase::itz), share_of(cells, specimen::phase::itz), 0.01);
}

TEST(Resample, DrawsNoItzWhereThePictureHadNone) {
  Raster<Cell> cells = discs_with_itz(400, 1.2);
  for (int r = 0; r < 200; ++r)
    for (int c = 0; c < 400; ++c)
      if (cells(r, c) == specimen::phase::itz) cells(r, c) = specimen::phase::mortar;
  const Raster<Cell> mask = resampled(cells, choose_mask_size(400, 400, 1, 100));
  for (int r = 0; r < 48; ++r)
    for (int c = 0; c < 100; ++c) EXPECT_NE(mask(r, c), specimen::phase::itz);
}

TEST(Resample, BlocksOfAveragedPixelsStandWhereTheyWere) {
  // 7 x 8 picture pixels in cells of 3: the last column of cells is one pixel wide, the last row two.
  Raster<Cell> cells(3, 3, specimen::phase::mortar);
  for (int r = 0; r < 3; ++r) cells(r, 2) = specimen::phase::aggregate;
  const auto mask = resampled(cells, Resampling{8, 7, 3, 8, 7});
  for (int r = 0; r < 8; ++r)
    for (int c = 0; c < 7; ++c)
      EXPECT_EQ(mask(r, c), c == 6 ? Cell{specimen::phase::aggregate} : Cell{specimen::phase::mortar});
}

TEST(Resample, MorePixelsThanThePictureTakeTheNearest) {
  const auto cells = cells_of({"1.", " 2"});
  EXPECT_EQ(text_of(resampled(cells, choose_mask_size(2, 2, 1, 4))), (Rows{"11..", "11..", "  22", "  22"}));
}

TEST(Resample, RowsAreEvenAndHaveHalfOfTheirPixels) {
  for (int rows = 10; rows < 400; ++rows)
    for (const int pixels : {7, 30, 64, 100}) {
      const double have = rows * pixels / 100.0;
      if (have < 1.5) continue;
      const Resampling to = choose_mask_size(rows, 100, 1, pixels);
      EXPECT_EQ(to.rows % 2, 0);
      EXPECT_LE(to.rows, have + 0.5 + 1e-9);
      EXPECT_GT(to.rows, have - 1.5 - 1e-9);
    }
}

TEST(Resample, RefusesAPictureThatIsTooFlat) {
  try {
    (void)choose_mask_size(10, 1000, 1, 100);
    FAIL();
  } catch (const specimen::Error& error) {
    EXPECT_EQ(error.field, "convert.pixels");
    EXPECT_THAT(error.what(), ::testing::HasSubstr("two are needed; ask for more columns"));
  }
}

}  // namespace resample_test
