/// Figures that describe a specimen.
#pragma once

#include <cstdint>
#include <vector>

#include "specimen/body/specimen.hpp"
#include "specimen/pack/grading.hpp"

namespace specimen {

/// A point of a sieve curve.
struct Passing {
  double diameter = 0;  ///< [m]
  double reached = 0;   ///< area share of the inclusions below the diameter [-]
  double target = 0;    ///< the same of the grading [-]; NaN when no grading was asked for
};

/// Two-point probability function S2 of one phase: that both ends of a segment lie in the phase. It begins
/// with the fraction of the phase and tends to the square of it. Source: Torquato (2002), Random
/// Heterogeneous Materials, ch. 2.
struct TwoPoint {
  std::vector<double> distance;  ///< length of the segment, a pixel from one to the next [m]
  std::vector<double> radial;    ///< in the mean over all directions, for lengths that round to that [-]
  std::vector<double> along_x;   ///< along rows [-]
  std::vector<double> along_y;   ///< along columns [-]
};

/// Share of each label [-], shape (phases.size()).
[[nodiscard]] std::vector<double> fractions(const LabelledMask& mask);

/// Sieve curve of the inclusions at the class limits of the grading (or at ten sizes when it is empty).
[[nodiscard]] std::vector<Passing> sieve_curve(const std::vector<Inclusion>& inclusions,
                                               const Grading& target);

/// S2 up to half of the shorter side. Segments that leave the mask do not count: nothing is taken to repeat.
[[nodiscard]] TwoPoint two_point_correlation(const LabelledMask& mask, std::uint8_t label);

/// Length of the boundary of a label along pixel edges, corrected for the staircase by the Cauchy-Crofton
/// mean over four directions [m].
[[nodiscard]] double perimeter(const LabelledMask& mask, std::uint8_t label);

}  // namespace specimen
