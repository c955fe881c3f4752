#include "specimen/convert/guess.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/specimen/drawn.hpp"

namespace guess_test {

using specimen::distinct_values;
using specimen::guess_class_phases;
using specimen::guess_method;
using specimen::Picture;
using specimen::Raster;
using specimen::Segmentation;
using specimen_test::draw_disc;
using Names = std::vector<std::string>;

Raster<double> discs(const std::vector<double>& values, double background) {
  Raster<double> picture(60, 20 * static_cast<int>(values.size()), background);
  for (std::size_t i = 0; i < values.size(); ++i)
    draw_disc(picture, 30, 20 * static_cast<double>(i) + 10, 8, values[i]);
  return picture;
}

Segmentation method_of(const Raster<double>& gray) {
  Picture picture;
  picture.gray = gray;
  return guess_method(distinct_values(picture, specimen::most_grains));
}

TEST(Guess, OnePieceAValueIsAMapOfGrains) {
  EXPECT_EQ(method_of(discs({1, 2, 3, 4, 5}, 0)), Segmentation::instances);
  EXPECT_EQ(method_of(discs({10, 20, 30, 4000, 50, 60}, 0)), Segmentation::instances);
}

TEST(Guess, FewValuesAreLabels) {
  EXPECT_EQ(method_of(discs({1, 2, 3, 4}, 0)), Segmentation::labels);                    // too few for grains
  EXPECT_EQ(method_of(discs({1, 1, 2, 2, 3, 3, 4, 4, 5, 5}, 0)), Segmentation::labels);  // many pieces each
  EXPECT_EQ(method_of(discs({2, 3, 4, 5, 6}, 1)), Segmentation::instances);              // in a matrix of 1
}

TEST(Guess, ManyValuesOrNoiseAreAPhotograph) {
  EXPECT_EQ(guess_method(std::nullopt), Segmentation::kmeans);
  Raster<double> noise(50, 50);
  for (std::size_t i = 0; i < noise.size(); ++i) noise.data[i] = static_cast<double>(i * i % 31);
  EXPECT_EQ(method_of(noise), Segmentation::kmeans);
}

TEST(Guess, ClassesOfAPhotograph) {
  Raster<std::uint8_t> classes(40, 80, 1);
  draw_disc(classes, 20, 20, 8, std::uint8_t{0});
  draw_disc(classes, 20, 60, 12, std::uint8_t{2});
  EXPECT_EQ(guess_class_phases(classes, 3, true), (Names{"void", "mortar", "aggregate"}));
  EXPECT_EQ(guess_class_phases(classes, 3, false), (Names{"aggregate", "mortar", "aggregate"}));
  for (std::uint8_t& k : classes.data) k = k == 0 ? 0 : 1;
  EXPECT_EQ(guess_class_phases(classes, 2, true), (Names{"aggregate", "mortar"}));
}

Picture gray(int cols, std::vector<double> values) {
  Picture picture;
  picture.gray = Raster<double>(static_cast<int>(values.size()) / cols, cols);
  picture.gray.data = std::move(values);
  return picture;
}

TEST(Values, AreListedInRisingOrderWithACodePerPixel) {
  const auto map = distinct_values(gray(3, {255, -4, 70000, 255, 255, -4}), 10);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->values, (std::vector<std::int64_t>{-4, 255, 70000}));
  EXPECT_EQ(map->code.data, (std::vector<std::int32_t>{1, 0, 2, 1, 1, 0}));
  EXPECT_EQ(specimen::value_text(*map, 0), "-4");
}

TEST(Values, AreNoneWhereTheyAreTooManyOrFractions) {
  EXPECT_TRUE(distinct_values(gray(3, {1, 2, 3}), 3));
  EXPECT_FALSE(distinct_values(gray(3, {1, 2, 3}), 2));
  EXPECT_FALSE(distinct_values(gray(2, {1, 2.5}), 9));
  EXPECT_FALSE(distinct_values(gray(2, {1, 1e300}), 9));
}

TEST(Values, OfAPaletteAreWhatItShowsAndBearItsIndicesAsNames) {
  Picture picture = gray(2, {90, 10});
  picture.indices = Raster<std::uint8_t>(1, 2);
  picture.indices.data = {4, 3};
  const auto map = distinct_values(picture, 9);
  EXPECT_EQ(map->values, (std::vector<std::int64_t>{10, 90}));
  EXPECT_EQ(map->names, (std::vector<std::int64_t>{3, 4}));
  EXPECT_EQ(specimen::value_text(*map, 1), "4");
}

TEST(Values, OfIndicesWithOneColourAreToldApartOnlyIfAskedFor) {
  Picture picture = gray(3, {90, 90, 10});
  picture.indices = Raster<std::uint8_t>(1, 3);
  picture.indices.data = {4, 3, 7};
  EXPECT_TRUE(specimen::shares_colours(picture));
  EXPECT_EQ(distinct_values(picture, 9)->values, (std::vector<std::int64_t>{10, 90}));
  EXPECT_TRUE(distinct_values(picture, 9)->names.empty());
  const auto map = distinct_values(picture, 9, specimen::Palette::indices);
  EXPECT_EQ(map->values, (std::vector<std::int64_t>{3, 4, 7}));
  EXPECT_EQ(map->black, 2);
}

TEST(Values, OfGreysStoredAsColoursAreGreyValues) {
  Picture picture;
  picture.colour = Raster<specimen::Rgb>(1, 2, {9, 9, 9});
  picture.colour(0, 1) = {4, 4, 4};
  const auto map = distinct_values(picture, 9);
  EXPECT_EQ(map->values, (std::vector<std::int64_t>{4, 9}));
  EXPECT_FALSE(map->colours);
  EXPECT_EQ(map->black, 0);
}

TEST(Values, NotANumberIsOneToo) {
  const auto map = distinct_values(gray(2, {std::nan(""), 3}), 9);
  EXPECT_EQ(map->values, (std::vector<std::int64_t>{specimen::no_number, 3}));
  EXPECT_EQ(specimen::value_text(*map, 0), "NaN");
}

TEST(Values, OfColoursAreTheirHexadecimalNumbers) {
  Picture picture;
  picture.colour = Raster<specimen::Rgb>(1, 2, {255, 128, 1});
  const auto map = distinct_values(picture, 9);
  EXPECT_TRUE(map->colours);
  EXPECT_EQ(map->values, (std::vector<std::int64_t>{0xff8001}));
  EXPECT_EQ(specimen::value_text(*map, 0), "#ff8001");
}

TEST(Values, CoherenceIsOneForAMapAndLowForNoise) {
  EXPECT_EQ(specimen::coherence(*distinct_values(gray(4, {5, 5, 5, 5}), 9)), 1);
  EXPECT_EQ(specimen::coherence(*distinct_values(gray(4, {5, 6, 5, 6}), 9)), 0);
  EXPECT_DOUBLE_EQ(specimen::coherence(*distinct_values(gray(4, {5, 5, 6, 6}), 9)), 2.0 / 3);
}

TEST(Values, LargestPieceOfEach) {
  const auto map = distinct_values(gray(5, {1, 1, 2, 1, 3,  //
                                            1, 2, 2, 1, 1}),
                                   9);
  EXPECT_EQ(specimen::largest_pieces(map->code, 3), (std::vector<std::int64_t>{3, 3, 1}));
}

}  // namespace guess_test
