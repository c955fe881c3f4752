/// What stands along an axis: round numbers, the unit of strains; and lines no longer than can be seen.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "apps/drawing/drawing.hpp"
#include "libmpm/scene/result.hpp"

namespace output {

/// Smallest of the factors, which rise, times a power of ten that is not below a positive value.
[[nodiscard]] double rounded_up(double value, std::initializer_list<double> factors);

struct Ticks {
  double step = 1;             ///< 1, 2 or 5 times a power of ten
  std::vector<double> values;  ///< whole multiples of the step in [low, high], rising
};

/// The most ticks that are at most `at_most`.   @pre low < high, both finite, at_most >= 2.
[[nodiscard]] Ticks ticks_between(double low, double high, int at_most);

/// Of a logarithmic axis: powers of ten in [low, high]; where there are fewer than two, 2 and 5 times them as
/// well. Never empty, rising, at most about `at_most`.   @pre 0 < low < high, both finite, at_most >= 2.
[[nodiscard]] std::vector<double> logarithmic_ticks(double low, double high, int at_most);

/// A tick with as many decimals as the step needs; powers of ten where that would be long.
[[nodiscard]] std::string tick_text(double value, double step);

/// Runs of points that are finite; a run of one point is dropped.   @pre x and y have one length.
[[nodiscard]] std::vector<std::vector<Place>> unbroken_lines(const std::vector<double>& x,
                                                             const std::vector<double>& y);

/// Of the points in each half column of pixels, in their order: the first, the lowest, the highest and the
/// last.
[[nodiscard]] std::vector<Place> thin_line(const std::vector<Place>& places);

struct StrainUnit {
  std::string name;   ///< "microstrain"
  double per_strain;  ///< how many of it are a strain of 1
};

/// Of the strains of a run that are numbers; 0 where there is none above it.
[[nodiscard]] double largest_strain(const mpm::Result& result);

/// Percent from a strain of 1 % on, microstrain below.
[[nodiscard]] StrainUnit strain_unit(double largest_strain);

/// For all strains of a run: that of the largest one.
[[nodiscard]] StrainUnit strain_unit(const mpm::Result& result);

/// What shares of Result::peak_strain are shares of: "the peak strain", or "the strain at the largest stress,
/// which is no peak".
[[nodiscard]] const char* reference_strain(const mpm::Result& result);

/// "118 microstrain, 82 % of the peak strain"; without the share where the run has no peak.
/// @param decimals  of the share.
[[nodiscard]] std::string strain_words(const mpm::Result& result, double strain, int decimals);

}  // namespace output
