#include <gtest/gtest.h>

#include "specimen/picture/picture.hpp"
#include "tests/specimen/picture_checks.hpp"

namespace picture_pnm_test {

using specimen::Picture;
using specimen::Rgb;
using specimen_test::expect_refused;
using specimen_test::FileBytes;
using specimen_test::Scratch;
using namespace std::string_literals;

TEST(PicturePnm, ReadsTextWithComments) {
  const Scratch scratch;
  const Picture gray =
      specimen::read_picture(scratch.write("t.pgm", "P2 # made by hand\n# twice\n3 1\n# max\n9\n0 5\n9"s));
  EXPECT_EQ(gray.gray.data.doubles(), (std::vector<double>{0, 5, 9}));
  const Picture colour = specimen::read_picture(scratch.write("t.ppm", "P3\n2 1 15\n15 0 0  0 15 3\n"s));
  EXPECT_EQ(colour.colour.data, (std::vector<Rgb>{{255, 0, 0}, {0, 255, 51}}));
}

TEST(PicturePnm, ReadsBytesOfEightAndSixteenBits) {
  const Scratch scratch;
  const Picture gray = specimen::read_picture(scratch.write("b.pgm", "P5\n2 1\n255\n\x07\xff"s));
  EXPECT_EQ(gray.gray.data.doubles(), (std::vector<double>{7, 255}));
  const Picture deep = specimen::read_picture(scratch.write("d.pgm", "P5 2 1 65535\n\x01\x00\xff\xff"s));
  EXPECT_EQ(deep.gray.data.doubles(), (std::vector<double>{256, 65535}));
  EXPECT_EQ(deep.bits, 16);
  const Picture colour = specimen::read_picture(scratch.write("b.ppm", "P6 1 1 255 \x01\x02\x03"s));
  EXPECT_EQ(colour.colour(0, 0), (Rgb{1, 2, 3}));
}

TEST(PicturePnm, GreyAsColoursIsGreyAsItStands) {
  const Scratch scratch;
  const Picture labels = specimen::read_picture(scratch.write("g.ppm", "P3 2 1 65535 1 1 1 2 2 2"s));
  EXPECT_EQ(labels.gray.data.doubles(), (std::vector<double>{1, 2}));
}

TEST(PicturePnm, RefusesSeveralPictures) {
  const Scratch scratch;
  const std::string several =
      "is a PNM of several pictures; must hold one picture; save the right one as a separate file";
  expect_refused(scratch.write("two.pgm", "P5 2 1 255\nabP5 2 1 255\nab"), several);
  expect_refused(scratch.write("two.ppm", "P3 1 1 9 1 2 3\n\nP3 1 1 9 1 2 3\n"), several);
  (void)specimen::read_picture(scratch.write("rest.pgm", "P5 2 1 255\nab\nPixels of mine"));
}

TEST(PicturePnm, RefusesWhatTheHeaderForbids) {
  const Scratch scratch;
  const auto refused = [&](const std::string& content, const std::string& text) {
    expect_refused(scratch.write("bad.pgm", content), text);
  };
  refused("P2 1 1 9 10", "pixel value 10; the header allows at most 9");
  refused("P2 1 1 70000 0", "largest value 70000; 1 to 65535 is allowed");
  refused("P4 8 1 \x01", "is a PNM of kind P4; grey P2, P5 and colour P3, P6 are read");
  refused("P2 x 1 9 0", "is a damaged PNM: a number was expected");
  refused("P2 99999999999 1 9 0", "is a damaged PNM: a number is too large");
  refused("P5 30000 30000 255\n", "at most 200000000 pixels are allowed");
  refused("P5 9000 9000 255\n", "is truncated: 17 bytes cannot hold 9000 x 9000 pixels");
  refused("P5 0 4 255\n", "holds 0 x 4 pixels");
}

TEST(PicturePnm, RefusesBeginningsAndSurvivesDamage) {
  const Scratch scratch;
  for (const std::string content : {"P2 2 2 255 1 20 30 4", "P6 1 2 255\nabcdef"}) {
    const FileBytes whole(content.begin(), content.end());
    EXPECT_EQ(specimen_test::read_all_beginnings(scratch, whole), 0);
    specimen_test::survive_damage(scratch, whole);
  }
}

}  // namespace picture_pnm_test
