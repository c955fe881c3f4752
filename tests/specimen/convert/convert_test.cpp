#include "specimen/convert/convert.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "specimen/body/error.hpp"
#include "specimen/picture/picture.hpp"
#include "tests/specimen/drawn.hpp"
#include "tests/specimen/scratch.hpp"

namespace convert_test {

using specimen::convert_picture;
using specimen::Converted;
using specimen::ConvertOptions;
using specimen::LabelledMask;
using specimen::Raster;
using specimen::Rgb;
using specimen::Segmentation;
using specimen_test::draw_disc;
using specimen_test::Scratch;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Names = std::vector<std::string>;

/// Labels and instances say the same, ids run from 1, and every inclusion has its pixels' area.
void expect_consistent(const Converted& converted) {
  const auto& [mask, instances, inclusions] = converted.segmented;
  ASSERT_EQ(mask.labels.rows, instances.rows);
  ASSERT_EQ(mask.labels.cols, instances.cols);
  std::vector<double> pixels(inclusions.size(), 0);
  for (std::size_t i = 0; i < instances.size(); ++i) {
    ASSERT_EQ(mask.labels.data[i] == specimen::phase::aggregate, instances.data[i] > 0);
    ASSERT_LT(mask.labels.data[i], mask.phases.size());
    ASSERT_LE(instances.data[i], static_cast<int>(inclusions.size()));
    if (instances.data[i] > 0) ++pixels[static_cast<std::size_t>(instances.data[i] - 1)];
  }
  for (std::size_t k = 0; k < inclusions.size(); ++k) {
    EXPECT_EQ(inclusions[k].id, static_cast<int>(k) + 1);
    EXPECT_GT(pixels[k], 0);
    EXPECT_NEAR(inclusions[k].area, pixels[k] * mask.pixel_size * mask.pixel_size,
                1e-12 * inclusions[k].area);
  }
  EXPECT_NE(converted.report.method, Segmentation::automatic);
}

Converted convert(const std::string& path, const ConvertOptions& options) {
  Converted converted = convert_picture(path, options);
  expect_consistent(converted);
  return converted;
}

LabelledMask our_mask() {
  LabelledMask mask;
  mask.pixel_size = 0.5e-3;
  mask.labels = Raster<std::uint8_t>(80, 100, specimen::phase::mortar);
  for (const auto& [row, col] : {std::pair(25.0, 30.0), std::pair(55.0, 70.0)}) {
    draw_disc(mask.labels, row, col, 16, specimen::phase::itz);
    draw_disc(mask.labels, row, col, 15, specimen::phase::aggregate);
  }
  draw_disc(mask.labels, 10, 80, 4, specimen::phase::void_);
  return mask;
}

/// Sorted by colours it is a drawing, and read as a map of labels would be.
TEST(Convert, KeepsThePoresOfADrawing) {
  specimen::Picture picture;
  picture.colour = Raster<Rgb>(240, 240, Rgb{120, 120, 110});
  draw_disc(picture.colour, 60, 70, 30, Rgb{190, 190, 180});
  draw_disc(picture.colour, 150, 160, 30, Rgb{190, 190, 180});
  for (int i = 0; i < 8; ++i) draw_disc(picture.colour, 220, 20 + 25 * i, 5, Rgb{25, 25, 25});
  ConvertOptions options;
  options.width = 0.06;
  options.method = Segmentation::kmeans;
  const Converted converted = convert_picture(picture, options);
  EXPECT_EQ(converted.segmented.inclusions.size(), 2U);
  EXPECT_EQ(converted.segmented.mask.labels(220, 20), specimen::phase::void_);
  EXPECT_EQ(converted.segmented.mask.labels(120, 120), specimen::phase::mortar);
}

TEST(Convert, WarnsOfADrawingThatCanBeReadInTwoWays) {
  specimen::Picture picture;
  picture.colour = Raster<Rgb>(240, 240, Rgb{200, 180, 140});
  for (int r = 0; r < 240; ++r)
    for (int c = 0; c < 120; ++c) picture.colour(r, c) = Rgb{110, 120, 150};
  ConvertOptions options;
  options.width = 0.06;
  options.method = Segmentation::kmeans;
  const Converted converted = convert_picture(picture, options);
  EXPECT_THAT(converted.report.warnings,
              ElementsAre(AllOf(HasSubstr("can be read in two ways"), HasSubstr("class_phases = "))));
}

class OurLabels : public ::testing::TestWithParam<const char*> {};

TEST_P(OurLabels, ComeBackAsTheyWere) {
  const Scratch scratch;
  const std::string path = scratch.file(std::string("labels") + GetParam());
  specimen::write_labels(path, our_mask());
  ConvertOptions options;
  options.source_pixel_size = 0.5e-3;
  const Converted converted = convert(path, options);
  EXPECT_EQ(converted.segmented.mask, our_mask());
  EXPECT_EQ(converted.segmented.inclusions.size(), 2U);
  EXPECT_EQ(converted.report.method, Segmentation::labels);
  EXPECT_THAT(
      converted.report.notes,
      Contains(HasSubstr("as the file says: 0 = void (0.6 %), 1 = aggregate (17.7 %), 2 = mortar (")));
}

INSTANTIATE_TEST_SUITE_P(Convert, OurLabels, ::testing::Values(".png", ".tif", ".bmp", ".pgm"),
                         [](const auto& about) { return std::string(about.param).substr(1); });

TEST(Convert, TakesTheScaleOfTheFileWithANote) {
  const Scratch scratch;
  specimen::write_labels(scratch.file("labels.tif"), our_mask());
  const Converted converted = convert(scratch.file("labels.tif"), {});
  EXPECT_NEAR(converted.segmented.mask.pixel_size, 0.5e-3, 1e-9);
  EXPECT_THAT(converted.report.notes, Contains(HasSubstr("unconfirmed")));
  specimen::write_labels(scratch.file("labels.pgm"), our_mask());
  EXPECT_THROW((void)convert_picture(scratch.file("labels.pgm"), {}), specimen::Error);
}

TEST(Convert, APictureInMemoryIsTheSameAsItsFile) {
  const Scratch scratch;
  const std::string path = scratch.file("labels.png");
  specimen::write_labels(path, our_mask());
  ConvertOptions options;
  options.source_pixel_size = 0.5e-3;
  options.crop = {10, 0, 60, 50};
  const Converted from_file = convert_picture(path, options);
  const Converted from_memory = convert_picture(specimen::read_picture(path), options);
  EXPECT_EQ(from_memory.segmented.mask, from_file.segmented.mask);
  EXPECT_EQ(from_memory.segmented.mask.labels.cols, 60);
  EXPECT_EQ(from_memory.report.notes, from_file.report.notes);
}

TEST(Convert, MapsValuesToPhasesOfTheUser) {
  const Scratch scratch;
  const std::string path = scratch.write("map.pgm", std::string("P2 4 2 255  0 1 2 3  255 2 2 3"));
  ConvertOptions options;
  options.source_pixel_size = 1e-3;
  options.label_phases = {{0, "void"},  {1, "mortar"}, {2, "aggregate"},
                          {3, "fibre"}, {255, "void"}, {9, "unseen"}};
  const Converted converted = convert(path, options);
  EXPECT_EQ(converted.segmented.mask.phases, (Names{"void", "aggregate", "mortar", "itz", "fibre"}));
  EXPECT_EQ(converted.segmented.mask.labels.data, (std::vector<std::uint8_t>{0, 2, 1, 4, 0, 1, 1, 4}));
  options.label_phases.erase(options.label_phases.begin() + 1);
  try {
    (void)convert_picture(path, options);
    FAIL();
  } catch (const specimen::Error& error) {
    EXPECT_STREQ(
        error.what(),
        "convert.label_phases: nothing for value 1; every value of the picture needs a phase; add it, or "
        "leave label_phases out to have all guessed");
  }
}

TEST(Convert, ColoursAreLabelsAndTouchingOnesAreDifferentGrains) {
  const Scratch scratch;
  Raster<Rgb> picture(60, 80, Rgb{204, 204, 204});
  draw_disc(picture, 30, 30, 15, Rgb{255, 128, 255});
  draw_disc(picture, 30, 50, 15, Rgb{192, 192, 255});
  specimen::write_png(scratch.file("map.png"), picture, 1e-3);
  const Converted guessed = convert(scratch.file("map.png"), {});
  EXPECT_EQ(guessed.report.method, Segmentation::labels);
  EXPECT_EQ(guessed.segmented.inclusions.size(), 2U);
  EXPECT_THAT(guessed.report.notes, Contains(HasSubstr("#c0c0ff = aggregate")));
  ConvertOptions options;
  options.label_phases = {{0xcccccc, "mortar"}, {0xff80ff, "aggregate"}, {0xc0c0ff, "steel"}};
  const Converted mapped = convert(scratch.file("map.png"), options);
  EXPECT_EQ(mapped.segmented.inclusions.size(), 1U);
  EXPECT_EQ(mapped.segmented.mask.labels(30, 50), 4);
}

TEST(Convert, EachNumberOfAnInstanceMapIsAGrain) {
  const Scratch scratch;
  Raster<double> ids(60, 120, 0.0);
  const std::vector<int> numbers{3, 40, 41, 900, 65000, 7};
  for (std::size_t i = 0; i < numbers.size(); ++i)  // neighbours touch
    draw_disc(ids, 30, 15 + 18 * static_cast<double>(i), 9.5, static_cast<double>(numbers[i]));
  std::string text = "P2 120 60 65535\n";
  for (const double id : ids.data) text += std::to_string(static_cast<int>(id)) + "\n";
  ConvertOptions options;
  options.width = 0.12;
  const Converted converted = convert(scratch.write("ids.pgm", text), options);
  EXPECT_EQ(converted.report.method, Segmentation::instances);
  ASSERT_EQ(converted.segmented.inclusions.size(), 6U);
  EXPECT_EQ(converted.segmented.instances(30, 15), 1);       // 3 is the lowest
  EXPECT_EQ(converted.segmented.instances(30, 15 + 90), 2);  // then 7
  EXPECT_EQ(converted.segmented.instances(30, 15 + 72), 6);  // 65000
  EXPECT_EQ(converted.segmented.mask.labels(2, 2), specimen::phase::mortar);
}

TEST(Convert, ResamplingKeepsGrainsAndCountsFromOne) {
  const Scratch scratch;
  std::string text = "P2 90 61 9\n";
  for (int r = 0; r < 61; ++r)
    for (int c = 0; c < 90; ++c) text += r == 0 && c == 0 ? "1 " : c < 30 ? "2 " : c < 60 ? "0 " : "3 ";
  ConvertOptions options;
  options.method = Segmentation::instances;
  options.source_pixel_size = 1e-3;
  options.pixels = 30;
  const Converted converted = convert(scratch.write("ids.pgm", text), options);
  EXPECT_EQ(converted.segmented.mask.labels.cols, 30);
  EXPECT_EQ(converted.segmented.mask.labels.rows, 20);  // 20.3 of them
  EXPECT_DOUBLE_EQ(converted.segmented.mask.pixel_size, 3e-3);
  EXPECT_EQ(converted.segmented.inclusions.size(), 2U);  // grain 1 is too small to be seen
  EXPECT_THAT(converted.report.notes, Contains(HasSubstr("omitted 1 pixel row at the bottom")));
  EXPECT_THAT(converted.report.notes, Contains(HasSubstr("to 30 x 20 by majority")));
}

TEST(Convert, ThresholdsCutTheLevelsOfTheUser) {
  const Scratch scratch;
  const std::string path =
      scratch.write("t.pgm", std::string("P2 5 2 1000  0 99 100 499 500  0 99 100 499 500"));
  ConvertOptions options;
  options.source_pixel_size = 1e-3;
  options.thresholds = {100, 500};
  options.class_phases = {"void", "mortar", "aggregate"};
  options.median = options.open = options.close = 0;
  options.drop_islands = 0;
  const Converted converted = convert(path, options);
  EXPECT_EQ(converted.report.method, Segmentation::threshold);
  EXPECT_EQ(converted.report.thresholds, (std::vector<double>{100, 500}));
  EXPECT_EQ(converted.segmented.mask.labels.data, (std::vector<std::uint8_t>{0, 0, 2, 2, 1, 0, 0, 2, 2, 1}));
}

/// Two touching stones, a hole in one of them, a void and sand, noisy.
Raster<Rgb> stones() {
  Raster<Rgb> picture(300, 400, Rgb{150, 130, 100});
  draw_disc(picture, 150, 120, 70, Rgb{90, 95, 100});
  draw_disc(picture, 150, 245, 65, Rgb{90, 95, 100});
  draw_disc(picture, 150, 120, 10, Rgb{150, 130, 100});
  draw_disc(picture, 60, 330, 25, Rgb{15, 12, 10});
  std::mt19937_64 random(2);
  for (int i = 0; i < 150; ++i)
    draw_disc(picture, static_cast<double>(random() % 300), static_cast<double>(random() % 400), 2,
              Rgb{90, 95, 100});
  specimen_test::add_noise(picture, 40);
  return picture;
}

TEST(Convert, AutomaticFindsTheStonesOfAPhotograph) {
  const Scratch scratch;
  specimen::write_png(scratch.file("stones.png"), stones(), 0.5e-3);
  ConvertOptions options;
  options.fill_holes = true;
  options.split_touching = true;
  const Converted converted = convert(scratch.file("stones.png"), options);
  EXPECT_EQ(converted.report.method, Segmentation::kmeans);
  ASSERT_EQ(converted.segmented.inclusions.size(), 2U);
  const auto& labels = converted.segmented.mask.labels;
  EXPECT_EQ(labels(60, 330), specimen::phase::void_);
  EXPECT_EQ(labels(150, 120), specimen::phase::aggregate);  // the hole
  EXPECT_EQ(labels(280, 200), specimen::phase::mortar);
  for (const auto& [index, radius] : {std::pair(0, 70), std::pair(1, 65)}) {
    const double exact = std::numbers::pi * radius * radius * 0.25e-6;
    EXPECT_NEAR(converted.segmented.inclusions[static_cast<std::size_t>(index)].area / exact, 1, 0.06);
  }
  EXPECT_THAT(converted.report.notes, Contains(HasSubstr("split 1 aggregate at their necks into 2")));
  EXPECT_THAT(converted.report.notes, Contains(HasSubstr("filled 1 hole of aggregates")));
}

TEST(Convert, OtsuOnAChannelFindsTheSameStones) {
  const Scratch scratch;
  specimen::write_png(scratch.file("stones.png"), stones(), 0.5e-3);
  ConvertOptions options;
  const Converted automatic = convert(scratch.file("stones.png"), options);
  options.method = Segmentation::multi_otsu;
  options.channel = "b";
  options.classes = 2;
  options.class_phases = {"aggregate", "mortar"};
  const Converted otsu = convert(scratch.file("stones.png"), options);
  ASSERT_EQ(otsu.report.thresholds.size(), 1U);
  const auto iou = specimen::intersection_over_union(otsu.segmented.mask, automatic.segmented.mask);
  EXPECT_GT(iou[specimen::phase::aggregate], 0.8);
}

/// The names in the note on the classes of colours, darkest first.
std::vector<std::string> noted_phases(const Converted& converted) {
  std::vector<std::string> names;
  for (const std::string& note : converted.report.notes) {
    if (note.rfind("phases of the classes", 0) != 0) continue;
    for (std::size_t at = note.find(" = "); at != std::string::npos; at = note.find(" = ", at + 3))
      names.push_back(note.substr(at + 3, note.find(" (", at) - at - 3));
  }
  return names;
}

TEST(Convert, NamesTheClassesOfColoursThatWereTold) {
  const Scratch scratch;
  specimen::write_png(scratch.file("stones.png"), stones(), 0.5e-3);
  ConvertOptions options;
  const Converted first = convert(scratch.file("stones.png"), options);
  options.class_phases = noted_phases(first);
  ASSERT_GE(options.class_phases.size(), 2U);
  EXPECT_EQ(convert(scratch.file("stones.png"), options).segmented.mask.labels.data,
            first.segmented.mask.labels.data)
      << "the same names are the same mask";
  for (std::string& name : options.class_phases) name = name == "mortar" ? "paste" : name;
  const Converted renamed = convert(scratch.file("stones.png"), options);
  EXPECT_EQ(noted_phases(renamed), options.class_phases);
  options.class_phases.push_back("one more");
  try {
    (void)convert(scratch.file("stones.png"), options);
    FAIL() << "a name without a class";
  } catch (const specimen::Error& error) {
    EXPECT_THAT(error.what(), HasSubstr(", told by a conversion without names; name each of them"));
  }
  options.classes = static_cast<int>(options.class_phases.size());
  EXPECT_EQ(noted_phases(convert(scratch.file("stones.png"), options)), options.class_phases);
}

TEST(Convert, KeepsWhatTheMaskCoversOfAPhotograph) {
  const Scratch scratch;
  specimen::write_png(scratch.file("stones.png"), stones(), 0.5e-3);
  ConvertOptions options;
  options.pixels = 150;
  const Converted converted = convert(scratch.file("stones.png"), options);
  ASSERT_EQ(converted.photograph.cols, 600);
  ASSERT_EQ(converted.photograph.rows, 4 * converted.segmented.mask.labels.rows);
  EXPECT_EQ(converted.photograph(599 * 60 / 400, 599 * 330 / 400).r, stones()(59, 329).r);
  const std::string map = scratch.write("t.pgm", std::string("P2 4 2 255  1 1 2 2  1 2 2 2"));
  options.source_pixel_size = 1e-3;
  options.pixels = 0;
  options.label_phases = {{1, "aggregate"}, {2, "mortar"}};
  EXPECT_TRUE(convert(map, options).photograph.empty());
}

TEST(Convert, GivesTheSameMaskEveryTime) {
  const Scratch scratch;
  specimen::write_png(scratch.file("stones.png"), stones(), 0.5e-3);
  ConvertOptions options;
  options.pixels = 150;
  const Converted first = convert(scratch.file("stones.png"), options);
  const Converted second = convert(scratch.file("stones.png"), options);
  EXPECT_EQ(first.segmented.mask, second.segmented.mask);
  EXPECT_EQ(first.report.notes, second.report.notes);
}

TEST(Convert, CropComesBeforeAllElse) {
  const Scratch scratch;
  specimen::write_labels(scratch.file("labels.png"), our_mask());
  ConvertOptions options;
  options.crop = {0, 0, 50, 80};
  options.width = 0.1;
  const Converted converted = convert(scratch.file("labels.png"), options);
  EXPECT_DOUBLE_EQ(converted.segmented.mask.pixel_size, 0.002);
  EXPECT_EQ(converted.segmented.inclusions.size(), 1U);
}

TEST(Convert, SaysWhenAMethodDoesNotFitThePicture) {
  const Scratch scratch;
  specimen::write_png(scratch.file("stones.png"), stones(), 0.5e-3);
  const auto complaint = [&](const std::string& path, const ConvertOptions& options) -> std::string {
    try {
      (void)convert_picture(path, options);
    } catch (const specimen::Error& error) {
      return error.what();
    }
    return "";
  };
  ConvertOptions options;
  options.method = Segmentation::labels;
  EXPECT_THAT(
      complaint(scratch.file("stones.png"), options),
      HasSubstr("convert.method: labels; needs a picture with whole numbers and at most 256 different ones; "
                "this one looks like a photograph: use kmeans or otsu"));
  specimen::write_labels(scratch.file("labels.png"), our_mask());
  options.median = 3;
  EXPECT_THAT(complaint(scratch.file("labels.png"), options),
              HasSubstr("convert.median: 3 px on a map of labels"));
  options = {};
  options.method = Segmentation::otsu;
  options.channel = "hue";
  EXPECT_EQ(complaint(scratch.file("labels.png"), options),
            "convert.channel: hue of a grey picture; it has only the channel gray");
}

TEST(Convert, IntersectionOverUnionPerPhase) {
  LabelledMask a, b;
  a.labels = Raster<std::uint8_t>(1, 4);
  a.labels.data = {1, 1, 2, 2};
  b.labels = Raster<std::uint8_t>(1, 4);
  b.labels.data = {1, 2, 2, 2};
  const auto iou = specimen::intersection_over_union(a, b);
  ASSERT_EQ(iou.size(), 4U);
  EXPECT_TRUE(std::isnan(iou[0]));
  EXPECT_DOUBLE_EQ(iou[1], 0.5);
  EXPECT_DOUBLE_EQ(iou[2], 2.0 / 3);
  b.labels = Raster<std::uint8_t>(4, 1);
  EXPECT_THROW((void)specimen::intersection_over_union(a, b), specimen::Error);
}

}  // namespace convert_test
