/// How wrong the peak of a run may be, source by source.
#pragma once

#include <string>
#include <vector>

namespace output {

/// What one choice of the numerics adds.
struct ErrorSource {
  std::string name;         ///< "loading rate"
  std::string compared;     ///< what a second run did otherwise: "0.025 m/s"
  double peak_stress = 0;   ///< of that run [Pa]
  double peak_strain = 0;   ///< of that run [-]
  double stress_error = 0;  ///< estimated, of the peak stress over it [-]
  double strain_error = 0;  ///< estimated, of the peak strain over it [-]
  double wall_time = 0;     ///< of the time loop of that run [s]
};

struct ErrorEstimate {
  std::vector<ErrorSource> sources;  ///< empty: none was asked for

  /// Sums over the sources: they may all point the same way.
  [[nodiscard]] double stress_error() const { return sum(&ErrorSource::stress_error); }  ///< [-]
  [[nodiscard]] double strain_error() const { return sum(&ErrorSource::strain_error); }  ///< [-]
  [[nodiscard]] double wall_time() const { return sum(&ErrorSource::wall_time); }        ///< [s]

 private:
  [[nodiscard]] double sum(double ErrorSource::*value) const {
    double total = 0;
    for (const ErrorSource& source : sources) total += source.*value;
    return total;
  }
};

}  // namespace output
