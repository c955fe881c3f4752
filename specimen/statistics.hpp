/// Figures that describe a specimen.
#pragma once

#include <cstdint>
#include <vector>

#include "specimen/grading.hpp"
#include "specimen/specimen.hpp"

namespace specimen {

/// A point of a sieve curve.
struct Passing {
  double diameter = 0;  ///< [m]
  double reached = 0;   ///< area share of the inclusions below the diameter [-]
  double target = 0;    ///< the same of the grading [-]; NaN when no grading was asked for
};

/// Two-point probability function S2 of one phase.
struct TwoPoint {
  std::vector<double> distance;     ///< [m]
  std::vector<double> probability;  ///< that both ends of a segment of that length lie in the phase [-]
};

/// Share of each label [-], shape (phases.size()).
[[nodiscard]] std::vector<double> fractions(const LabelledMask& mask);

/// Sieve curve of the inclusions at the class limits of the grading (or at ten sizes when it is empty).
[[nodiscard]] std::vector<Passing> sieve_curve(const std::vector<Inclusion>& inclusions,
                                               const Grading& target);

/// S2 along rows and columns, averaged, up to half of the shorter side.
[[nodiscard]] TwoPoint two_point_correlation(const LabelledMask& mask, std::uint8_t label);

/// Length of the boundary of a label along pixel edges, corrected for the staircase by the Cauchy-Crofton
/// mean over four directions [m].
[[nodiscard]] double perimeter(const LabelledMask& mask, std::uint8_t label);

}  // namespace specimen
