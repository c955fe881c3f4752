#include "apps/settings/codec.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/apps/complaint_about.hpp"

namespace codec_test {

using app::complaint_about;
using app::Value;
using List = Value::List;

Value text(const std::string& words) { return {words}; }

TEST(Bounds, SayWhatIsAllowed) {
  EXPECT_EQ(app::above(0).text(app::Dimension::pressure), "must be > 0");
  EXPECT_EQ(app::at_least(0).text(app::Dimension::ratio), "must be >= 0");
  EXPECT_EQ(app::up_to(0, 1).text(app::Dimension::ratio), "must lie in (0, 1]");
  EXPECT_EQ(app::below(0, 1).text(app::Dimension::ratio), "must lie in [0, 1)");
  EXPECT_EQ(app::between(0.5e-3, 2).text(app::Dimension::length), "must lie in [0.5 mm, 2 m]");
  EXPECT_EQ(app::between(-app::unlimited, 2).text(app::Dimension::length), "must be <= 2 m");
  EXPECT_EQ(app::below(-app::unlimited, 2).text(app::Dimension::length), "must be < 2 m");
}

TEST(Bounds, OpenEndsExcludeTheLimit) {
  EXPECT_FALSE(app::above(0).contains(0));
  EXPECT_TRUE(app::at_least(0).contains(0));
  EXPECT_TRUE(app::up_to(0, 1).contains(1));
  EXPECT_FALSE(app::below(0, 1).contains(1));
  EXPECT_FALSE(app::inside(0, 1).contains(0));
  EXPECT_FALSE(app::between(0, 1).contains(std::nan("")));
}

TEST(Quantity, TakesOnlyTextsWhereAUnitIsNeeded) {
  const app::QuantityCodec velocity{app::Dimension::velocity, app::above(0), {}};
  EXPECT_EQ(velocity.read(text("0.05 m/s")), 0.05);
  EXPECT_EQ(complaint_about(velocity, {0.05}), "needs a unit; write e.g. \"0.05 m/s\"");
  EXPECT_EQ(complaint_about(velocity, {std::int64_t{1}}), "needs a unit; write e.g. \"0.05 m/s\"");
  EXPECT_EQ(complaint_about(velocity, {std::nan("")}), "must be a finite number");
  EXPECT_EQ(complaint_about(velocity, {true}), "must be a velocity, e.g. \"0.05 m/s\"");
  EXPECT_EQ(complaint_about(velocity, text("0 m/s")), "must be > 0");
}

TEST(Quantity, RatiosAreNumbersOrPercentages) {
  const app::QuantityCodec share{app::Dimension::ratio, app::up_to(0, 1), {}};
  EXPECT_EQ(share.read({std::int64_t{1}}), 1);
  EXPECT_EQ(share.read({0.45}), 0.45);
  EXPECT_EQ(share.read(text("45 %")), 0.45);
  EXPECT_EQ(complaint_about(share, {HUGE_VAL}), "must be a finite number");
  EXPECT_EQ(complaint_about(share, {false}), "must be a number, e.g. 0.45");
  EXPECT_EQ(complaint_about(share, {1.5}), "must lie in (0, 1]");
}

TEST(Quantity, AWordStandsForItsNumber) {
  const app::QuantityCodec thickness{app::Dimension::length, app::above(0), app::Word{"auto", 0}};
  EXPECT_EQ(thickness.read(text("auto")), 0);
  EXPECT_EQ(thickness.write(0), text("auto"));
  EXPECT_EQ(thickness.write(1e-3), text("1 mm"));
  EXPECT_EQ(complaint_about(thickness, text("0 mm")), "must be > 0, or \"auto\"");
  EXPECT_EQ(complaint_about(thickness, text("thin")), "must be a length, e.g. \"0.5 mm\", or \"auto\"");
}

TEST(OptionalQuantity, TheWordMeansAbsent) {
  const app::OptionalQuantityCodec drop{{app::Dimension::ratio, app::inside(0, 1), {}}, "none"};
  EXPECT_EQ(drop.read(text("none")), std::nullopt);
  EXPECT_EQ(drop.read({0.2}), 0.2);
  EXPECT_EQ(drop.write(std::nullopt), text("none"));
  EXPECT_EQ(complaint_about(drop, {1.0}), "must lie in (0, 1), or \"none\"");
}

TEST(Integer, TakesWholeNumbersInBounds) {
  const app::IntegerCodec<> threads{app::between(1, 8)};
  EXPECT_EQ(threads.read({std::int64_t{8}}), 8);
  EXPECT_EQ(complaint_about(threads, {std::int64_t{0}}), "must lie in [1, 8]");
  EXPECT_EQ(complaint_about(threads, {2.0}), "must be a whole number");
  EXPECT_EQ(complaint_about(threads, text("2")), "must be a whole number");
  const app::IntegerCodec<> pixels{app::between(0, 9), app::Word{"auto", -1}};
  EXPECT_EQ(pixels.read(text("auto")), -1);
  EXPECT_EQ(complaint_about(pixels, {std::int64_t{-1}}), "must lie in [0, 9], or \"auto\"");
}

TEST(Boolean, TakesTrueAndFalseOnly) {
  EXPECT_TRUE(app::BooleanCodec().read({true}));
  EXPECT_EQ(complaint_about(app::BooleanCodec(), {std::int64_t{1}}), "must be true or false");
  EXPECT_EQ(complaint_about(app::BooleanCodec(), text("true")), "must be true or false");
}

TEST(Name, SuggestsTheWordThatWasMeant) {
  const app::WordCodec plane{{"strain", "stress"}};
  EXPECT_EQ(plane.read(text("stress")), "stress");
  EXPECT_EQ(complaint_about(plane, text("stres")), "must be strain or stress; did you mean stress?");
  EXPECT_EQ(complaint_about(plane, text("shell")), "must be strain or stress");
  EXPECT_EQ(complaint_about(plane, {true}), "must be strain or stress");
}

TEST(Text, TakesTextInUtf8Only) {
  EXPECT_EQ(app::TextCodec().read(text("Größe")), "Größe");
  EXPECT_EQ(complaint_about(app::TextCodec(), text("Gr\xf6\xdf"
                                                   "e")),
            "must be text in UTF-8");
  EXPECT_EQ(complaint_about(app::TextCodec(), {1.5}), "must be a text in quotes");
}

TEST(FromCommandLine, GuessesNothingButTheKind) {
  EXPECT_EQ(app::from_command_line(app::Kind::integer, "7"), Value{std::int64_t{7}});
  EXPECT_EQ(app::from_command_line(app::Kind::integer, "7.5"), text("7.5"));
  EXPECT_EQ(app::from_command_line(app::Kind::boolean, "false"), Value{false});
  EXPECT_EQ(app::from_command_line(app::Kind::text, "7"), text("7"));
  EXPECT_EQ(app::from_command_line(app::Kind::quantity, "0.5 mm"), text("0.5 mm"));
  EXPECT_EQ(app::from_command_line(app::Kind::list, "80, 160.5 ,a"),
            (Value{List{{std::int64_t{80}}, {160.5}, text("a")}}));
  EXPECT_EQ(app::from_command_line(app::Kind::list, ""), Value{List{}});
}

}  // namespace codec_test
