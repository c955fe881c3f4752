#include <gtest/gtest.h>

#include "apps/settings/codec.hpp"
#include "tests/apps/complaint_about.hpp"

namespace codec_list_test {

using app::complaint_about;
using app::Value;
using List = Value::List;

Value text(const std::string& words) { return {words}; }

TEST(Texts, AreNamesWithoutAnEmptyOne) {
  const Value value{List{text("void"), text("my-phase")}};
  EXPECT_EQ(app::TextsCodec().read(value), (std::vector<std::string>{"void", "my-phase"}));
  EXPECT_EQ(app::TextsCodec().write(app::TextsCodec().read(value)), value);
  const std::string form = "must be a list of names, e.g. [\"void\", \"mortar\", \"aggregate\"]";
  EXPECT_EQ(complaint_about(app::TextsCodec(), {List{text("void"), text("")}}), form);
  EXPECT_EQ(complaint_about(app::TextsCodec(), text("void")), form);
}

TEST(Numbers, AreReadWithoutUnits) {
  EXPECT_EQ(app::NumbersCodec().read({List{{80.5}, {std::int64_t{160}}}}), (std::vector<double>{80.5, 160}));
  EXPECT_EQ(complaint_about(app::NumbersCodec(), {80.5}), "must be a list of numbers, e.g. [80, 160]");
  EXPECT_EQ(complaint_about(app::NumbersCodec(), {List{{true}}}), "must be a number, e.g. 0.45");
}

TEST(Rectangle, TakesFourWholeNumbers) {
  const app::RectangleCodec crop;
  const Value four{List{{std::int64_t{1}}, {std::int64_t{2}}, {std::int64_t{3}}, {std::int64_t{4}}}};
  EXPECT_EQ(crop.read(four).height, 4);
  EXPECT_EQ(crop.write(crop.read(four)), four);
  EXPECT_EQ(crop.write({}), Value{List{}});
  const std::string form = "must be x, y, width and height in pixels, e.g. [10, 20, 400, 300]";
  EXPECT_EQ(complaint_about(crop, {List{{std::int64_t{1}}}}), form);
  EXPECT_EQ(complaint_about(crop, text("all")), form);
  List items{{std::int64_t{1}}, {std::int64_t{-2}}, {std::int64_t{3}}, {std::int64_t{4}}};
  EXPECT_EQ(complaint_about(crop, {items}), form);
  items[1] = {std::int64_t{2}};
  items.push_back({std::int64_t{5}});
  EXPECT_EQ(complaint_about(crop, {items}), form);
  const Value empty{List{{std::int64_t{1}}, {std::int64_t{2}}, {std::int64_t{0}}, {std::int64_t{4}}}};
  EXPECT_EQ(complaint_about(crop, empty), "width and height must be > 0");
}

TEST(LabelNames, PairLabelsAndPhases) {
  const Value value{List{text("0:void"), text("255 : my-phase")}};
  const auto names = app::LabelNamesCodec().read(value);
  ASSERT_EQ(names.size(), 2u);
  EXPECT_EQ(names[1], (std::pair<std::int64_t, std::string>(255, "my-phase")));
  EXPECT_EQ(complaint_about(app::LabelNamesCodec(), {List{text("x:void")}}),
            "\"x:void\" does not fit; write each label as \"1: mortar\"");
  EXPECT_EQ(complaint_about(app::LabelNamesCodec(), {List{text("0")}}),
            "\"0\" does not fit; write each label as \"1: mortar\"");
}

TEST(LabelNames, TakeColoursAsNotesWriteThem) {
  const auto names = app::LabelNamesCodec().read({List{text("#ff8000: void"), text("16711680: mortar")}});
  ASSERT_EQ(names.size(), 2U);
  EXPECT_EQ(names[0].first, 0xff8000);
  EXPECT_EQ(names[0].second, "void");
  EXPECT_EQ(names[1].first, 0xff0000);
  EXPECT_NE(complaint_about(app::LabelNamesCodec(), {List{text("#ff80: void")}}), "");
}

TEST(LabelNames, NeedANameToEachLabel) {
  EXPECT_EQ(complaint_about(app::LabelNamesCodec(), {List{text("0:")}}),
            "\"0:\" does not fit; write each label as \"1: mortar\"");
}

TEST(SizeClasses, AreSortedAndMustAddUp) {
  const Value value{List{text("5 mm .. 10 mm: 40 %"), text("10mm..20mm:0.6")}};
  const auto classes = app::SizeClassesCodec().read(value);
  ASSERT_EQ(classes.size(), 2u);
  EXPECT_EQ(classes[0].d_max, 20e-3);
  EXPECT_EQ(classes[1].share, 0.4);
  EXPECT_EQ(app::SizeClassesCodec().write(classes),
            (Value{List{text("10 mm .. 20 mm: 0.6"), text("5 mm .. 10 mm: 0.4")}}));
  const app::SizeClassesCodec codec;
  EXPECT_EQ(complaint_about(codec, {List{text("5 mm .. 10 mm: 40 %")}}),
            "the shares add up to 40 %; make them add up to 100 %");
  EXPECT_EQ(complaint_about(codec, {List{text("10 mm .. 5 mm: 1")}}),
            "\"10 mm .. 5 mm\" is no range; write the smaller diameter first, both > 0");
  EXPECT_EQ(complaint_about(codec, {List{text("5 mm .. 10 mm: 140 %")}}), "a share must lie in (0, 1]");
  EXPECT_EQ(complaint_about(codec, {List{text("5 .. 10 mm: 1")}}), "needs a unit; write e.g. \"0.5 mm\"");
  EXPECT_EQ(complaint_about(codec, {List{text("5 mm: 1")}}),
            "\"5 mm\" does not fit; write each class as \"5 mm .. 10 mm: 40 %\"");
}

}  // namespace codec_list_test
