/// How well twins match their original.
#pragma once

#include <vector>

#include "specimen/describe/descriptors.hpp"

namespace specimen {

/// A figure of the original beside those of the twins.
struct FigureMisfit {
  double original = 0;
  double mean = 0;       ///< of the twins
  double deviation = 0;  ///< standard deviation from twin to twin; NaN for a single one
  double least = 0;      ///< of the twins
  double largest = 0;    ///< of the twins

  [[nodiscard]] double difference() const { return mean - original; }
  /// The original lies between the least and the largest twin.
  [[nodiscard]] bool within() const { return least <= original && original <= largest; }
};

/// How far a curve of the original lies from the mean of the twins, beside how far each twin does from the
/// mean of all others: if not farther than the farthest twin, the original may be one of them (deviation
/// test; Diggle (1979), Biometrics 35).
struct CurveMisfit {
  double original = 0;
  double mean = 0;     ///< of the twins; NaN for a single one
  double largest = 0;  ///< of the twins; NaN for a single one

  [[nodiscard]] bool within() const { return original <= largest; }
};

/// Misfit of every statistic.
struct Misfit {
  FigureMisfit fraction;            ///< [-]
  FigureMisfit median_diameter;     ///< [m]
  FigureMisfit mean_aspect;         ///< [-]
  FigureMisfit strength;            ///< of the orientation [-]
  FigureMisfit mean_gap;            ///< [m]
  FigureMisfit specific_perimeter;  ///< [1/m]
  double direction = 0;             ///< mean of the twins [rad]
  CurveMisfit sizes;                ///< largest difference of the size curves [-]
  CurveMisfit sizes_mean;           ///< area between the size curves [m]
  CurveMisfit gaps;  ///< largest difference of the distributions of distances to nearest neighbours [-]
  /// Differences of S2 over fraction (1 - fraction) of the original, at the distances that all have [-].
  CurveMisfit s2_rms, s2_largest, s2_along_x_rms, s2_along_y_rms;
};

/// Values of one curve of S2 at other distances, by straight lines [-]; shorter where it ends sooner.
[[nodiscard]] std::vector<double> at_distances(const std::vector<double>& distance,
                                               const std::vector<double>& values,
                                               const std::vector<double>& wanted);

/// @pre at least one twin.
[[nodiscard]] Misfit compare(const Descriptors& original, const std::vector<Descriptors>& twins);

}  // namespace specimen
