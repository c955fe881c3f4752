/// Statistics of a specimen: phase fractions, sieve curve, two-point probability, perimeter.
#pragma once

#include <cstdint>
#include <vector>

#include "specimen/body/specimen.hpp"
#include "specimen/pack/grading.hpp"

namespace specimen {

/// A point of a sieve curve.
struct Passing {
  double diameter = 0;  ///< sieve size [m]
  double reached = 0;   ///< area share of the inclusions below the diameter [-]
  double target = 0;    ///< the same for the target grading [-]; NaN without one
};

/// Two-point probability function S2 of a phase: the probability that both ends of a segment lie in the
/// phase. It starts at the fraction of the phase and tends to the square of the fraction. Source: Torquato
/// (2002), Random Heterogeneous Materials, ch. 2.
struct TwoPoint {
  std::vector<double> distance;  ///< length of the segment, in steps of one pixel [m]
  std::vector<double> radial;    ///< mean over all directions, for lengths that round to this distance [-]
  std::vector<double> along_x;   ///< along rows [-]
  std::vector<double> along_y;   ///< along columns [-]
};

/// Share of each label [-], shape (phases.size()).
[[nodiscard]] std::vector<double> fractions(const LabelledMask& mask);

/// Sieve curve of the inclusions at the class limits of a grading, or at ten sizes if the grading is empty.
[[nodiscard]] std::vector<Passing> sieve_curve(const std::vector<Inclusion>& inclusions,
                                               const Grading& target);

/// S2 up to half of the shorter side. Segments that leave the mask are not counted; the mask is not periodic.
[[nodiscard]] TwoPoint two_point_correlation(const LabelledMask& mask, std::uint8_t label);

/// Length of the boundary of a label along pixel edges, corrected for the staircase by the Cauchy-Crofton
/// mean over four directions [m].
[[nodiscard]] double perimeter(const LabelledMask& mask, std::uint8_t label);

}  // namespace specimen
