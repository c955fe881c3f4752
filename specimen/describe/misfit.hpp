/// Agreement of twins with their original.
#pragma once

#include <vector>

#include "specimen/describe/descriptors.hpp"

namespace specimen {

/// A statistic of the original and of the twins, in one unit.
struct FigureMisfit {
  double original = 0;   ///< value of the original
  double mean = 0;       ///< of the twins
  double deviation = 0;  ///< standard deviation of the twins; NaN for a single twin
  double least = 0;      ///< smallest of the twins
  double largest = 0;    ///< largest of the twins

  [[nodiscard]] double difference() const { return mean - original; }
  /// The original lies between the smallest and the largest twin.
  [[nodiscard]] bool within() const { return least <= original && original <= largest; }
};

/// Distance of a curve of the original from the mean of the twins, and distance of each twin from the mean of
/// all other twins. If the original is no farther away than the farthest twin, it is consistent with the
/// twins (deviation test; Diggle (1979), Biometrics 35).
struct CurveMisfit {
  double original = 0;  ///< distance of the original
  double mean = 0;      ///< mean distance of the twins; NaN for a single twin
  double largest = 0;   ///< largest distance of the twins; NaN for a single twin

  [[nodiscard]] bool within() const { return original <= largest; }
};

/// Agreement of every statistic.
struct Misfit {
  FigureMisfit fraction;            ///< [-]
  FigureMisfit median_diameter;     ///< [m]
  FigureMisfit mean_aspect;         ///< [-]
  FigureMisfit strength;            ///< Orientation::strength [-]
  FigureMisfit mean_gap;            ///< [m]
  FigureMisfit specific_perimeter;  ///< [1/m]
  double direction = 0;             ///< mean direction of the twins [rad]
  CurveMisfit sizes;                ///< largest difference of the size curves [-]
  CurveMisfit sizes_mean;           ///< area between the size curves [m]
  CurveMisfit gaps;  ///< largest difference of the distributions of nearest-neighbour distances [-]
  /// Differences of S2 over fraction (1 - fraction) of the original, at the common distances [-].
  CurveMisfit s2_rms, s2_largest, s2_along_x_rms, s2_along_y_rms;
};

/// Values of a curve [-] at other distances [m], by linear interpolation; shorter if the curve ends earlier.
[[nodiscard]] std::vector<double> at_distances(const std::vector<double>& distance,
                                               const std::vector<double>& values,
                                               const std::vector<double>& wanted);

/// Compare twins with their original.   @pre at least one twin.
[[nodiscard]] Misfit compare(const Descriptors& original, const std::vector<Descriptors>& twins);

}  // namespace specimen
