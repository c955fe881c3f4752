/// Colours for numbers with a sign.
#pragma once

#include <vector>

#include "specimen/picture/picture.hpp"

namespace output {

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
