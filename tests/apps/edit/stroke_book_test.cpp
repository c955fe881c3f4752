#include "apps/edit/stroke_book.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

#include "apps/scene/stroke_list.hpp"
#include "specimen/body/error.hpp"
#include "tests/apps/refusal.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace stroke_book_test {

namespace fs = std::filesystem;
using app::StrokeBook;
using specimen::StrokeLine;
using ::testing::HasSubstr;

const StrokeLine stone{"aggregate", 5, {{1, 2}, {30, 20}}};
const StrokeLine paste{"mortar", 3, {{40, 40}}};

class Book : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<std::string> phases_on_disk() const {
    std::vector<std::string> phases;
    if (fs::exists(file_))
      for (const StrokeLine& line : app::read_stroke_list(file_)) phases.push_back(line.phase);
    return phases;
  }
  test::TemporaryFolder folder_;
  std::string file_ = folder_ / "photo.strokes.csv";
  StrokeBook book_{file_, {}, 50, 60};
};

using Phases = std::vector<std::string>;

TEST_F(Book, EveryChangeIsOnTheDisk) {
  book_.add(stone);
  EXPECT_EQ(phases_on_disk(), (Phases{"aggregate"}));
  book_.add(paste);
  EXPECT_EQ(phases_on_disk(), (Phases{"aggregate", "mortar"}));
  book_.remove({0});
  EXPECT_EQ(phases_on_disk(), (Phases{"mortar"}));
  book_.undo();
  EXPECT_EQ(phases_on_disk(), (Phases{"aggregate", "mortar"}));
  book_.undo();
  book_.undo();
  EXPECT_FALSE(fs::exists(file_)) << "no strokes, no file";
  book_.redo();
  EXPECT_EQ(phases_on_disk(), (Phases{"aggregate"}));
  EXPECT_EQ(book_.lines()[0].points, stone.points);
}

TEST_F(Book, UndoAndRedoEndWhereThereIsNoMore) {
  EXPECT_FALSE(book_.can_undo());
  book_.undo();
  book_.add(stone);
  book_.undo();
  EXPECT_TRUE(book_.can_redo());
  book_.add(paste);
  EXPECT_FALSE(book_.can_redo()) << "what was undone is gone with a new stroke";
  book_.redo();
  EXPECT_EQ(book_.lines().size(), 1U);
}

TEST_F(Book, VersionsGrow) {
  const std::int64_t first = book_.version();
  book_.undo();
  EXPECT_EQ(book_.version(), first) << "nothing has changed";
  book_.add(stone);
  book_.undo();
  EXPECT_EQ(book_.version(), first + 2);
}

TEST_F(Book, RefusesWhatIsNoStrokeOnThePicture) {
  const auto about = [&](StrokeLine line) { return test::refusal([&] { book_.add(line); }); };
  EXPECT_EQ(about({"mortar", 3, {{60.1, 2}}}),
            "points: x = 60.1, y = 2 px; must lie on the picture of 60 x 50 px");
  EXPECT_EQ(about({"mortar", 3, {{-1, 2}}}),
            "points: x = -1, y = 2 px; must lie on the picture of 60 x 50 px");
  EXPECT_EQ(about({"mortar", 3, {}}), "points: 0; must be 1 to 100000");
  EXPECT_EQ(about({"mortar", 0.5, {{1, 2}}}), "width: 0.5 px; must be 1 to 1000 px");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(about({"mortar", nan, {{1, 2}}}), HasSubstr("must be 1 to 1000 px"));
  EXPECT_THAT(about({"mortar", 3, {{nan, 2}}}), HasSubstr("must lie on the picture"));
  EXPECT_THAT(about({"a,b\n", 3, {{1, 2}}}), HasSubstr("must be the name of a phase"));
  EXPECT_THAT(about({std::string(61, 'a'), 3, {{1, 2}}}), HasSubstr("must be the name of a phase"));
  EXPECT_EQ(test::refusal([&] { book_.remove({0}); }), "stroke: 0; must be one of the 0 strokes");
  EXPECT_TRUE(book_.lines().empty());
  EXPECT_FALSE(fs::exists(file_));
}

TEST_F(Book, KeepsWhatItHadWhereTheDiskFails) {
  StrokeBook book((folder_ / "no folder/s.csv"), {stone}, 50, 60);
  EXPECT_THROW(book.add(paste), specimen::Error);
  EXPECT_EQ(book.lines().size(), 1U);
  EXPECT_FALSE(book.can_undo());
}

TEST(LinesOf, CoverThePixelsThatWerePainted) {
  specimen::Strokes painted;
  painted.labels = specimen::Raster<std::uint8_t>(6, 9, specimen::no_stroke);
  painted.joins = specimen::Raster<std::uint8_t>(6, 9, 0);
  painted.phases.resize(6);
  painted.phases[5] = "fibre";
  for (const int c : {0, 1, 2, 5, 8}) painted.labels(1, c) = specimen::phase::mortar;
  for (int r = 2; r < 6; ++r) painted.labels(r, 4) = painted.labels(r, 8) = 5;
  painted.labels(0, 8) = specimen::cut_stroke;
  painted.joins(1, 5) = painted.joins(2, 5) = 1;
  const specimen::Strokes again = specimen::strokes_along(app::lines_of(painted), 6, 9);
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 9; ++c) {
      const std::uint8_t was = painted.labels(r, c), is = again.labels(r, c);
      EXPECT_EQ(is == 4 ? 5 : is, was) << r << " " << c << ": a phase of one's own has the next free label";
    }
  EXPECT_EQ(again.joins, painted.joins);
  EXPECT_EQ(again.painted_over, 0);
}

}  // namespace stroke_book_test
