/// A measured stress-strain curve, as a calibration aims at it.
#pragma once

#include <string>
#include <vector>

namespace app {

/// Stress over strain, positive in the direction of the loading; strains do not fall.
struct TargetCurve {
  std::vector<double> strain;  ///< [-]
  std::vector<double> stress;  ///< [Pa], same length

  [[nodiscard]] bool empty() const { return strain.empty(); }
  [[nodiscard]] double last_strain() const { return strain.back(); }
  [[nodiscard]] double peak_stress() const;  ///< [Pa]
  [[nodiscard]] double peak_strain() const;  ///< where the stress is highest
};

/// Columns "strain" (or "strain_%", "strain_microstrain") and "stress_MPa" (or _Pa, _kPa, _GPa) of a table
/// with a header and cells between commas; further columns are skipped, so that curve.csv of a run will do.
/// Empty lines and lines that begin with # are skipped too.
/// @throws Rejected (Exit::data) with every mistake at its line and column, (Exit::io) when the file cannot
/// be read.
[[nodiscard]] TargetCurve read_target_curve(const std::string& path);

/// The same from text; `path` is for the messages.
[[nodiscard]] TargetCurve parse_target_curve(const std::string& text, const std::string& path);

}  // namespace app
