/// The inks that charts are drawn in, on light and on dark paper, and colours for numbers with a sign.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "specimen/picture/picture.hpp"

namespace output {

/// What a line or a word is for; the colour follows from the paper.
enum class Ink { text, muted, grid, axis, first, second, third, fourth, fifth };

inline constexpr std::array all_inks{Ink::text,   Ink::muted, Ink::grid,   Ink::axis, Ink::first,
                                     Ink::second, Ink::third, Ink::fourth, Ink::fifth};

/// Lines that are told apart by their ink.
inline constexpr std::size_t series_inks = 5;

/// Of the lines of a chart, counted from 0: first ... fifth, and from the first one on again.
[[nodiscard]] Ink ink_of_series(std::size_t number);

/// Colours from Okabe and Ito's list, which stays apart for colour-blind eyes, made darker or lighter until
/// lines have a contrast of at least 3:1 to the paper and words 4.5:1.
[[nodiscard]] specimen::Rgb on_light_paper(Ink ink);
[[nodiscard]] specimen::Rgb on_dark_paper(Ink ink);

/// Name in style sheets, e.g. "first".
[[nodiscard]] std::string_view name_of(Ink ink);

/// "#0072b2".
[[nodiscard]] std::string hex(specimen::Rgb colour);

/// From an end value to another; zero, where it lies between them or is one of them, has the middle colour.
/// So a warm colour is above zero and a cool one below it in every picture, and equal steps of the value are
/// equal steps for the eye on either side.
struct ColourScale {
  double low = -1, high = 1;  ///< low < high, both finite

  /// Of a value; those beyond the ends have the colour of the end.   @pre value is finite.
  [[nodiscard]] specimen::Rgb operator()(double value) const;
};

/// Ends that leave out the smallest and the largest hundredth of the values, made round: from zero where
/// values of one sign are no tenth of the others, else as far below zero as above it.
/// From 0 to 1 where there is nothing but zeros.
/// @param values  finite; in the unit in which the ends shall be round.
[[nodiscard]] ColourScale scale_of(std::vector<double> values);

}  // namespace output
