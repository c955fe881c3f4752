/// The parameters that a calibration may change: which settings, how far, and how they are set.
#pragma once

#include <string>
#include <vector>

#include "apps/settings/schema.hpp"
#include "libmpm/scene/scene.hpp"

namespace app {

/// A setting that is scaled.
struct ScaledSetting {
  Field field;
  double start = 0;  ///< value in the scene, SI units, > 0

  /// Value at a factor, rounded to five digits as it is written into scenes.
  [[nodiscard]] double value(double factor) const;
  /// The same in the unit of the start: "8.1234 MPa".
  [[nodiscard]] std::string text(double factor) const;
};

/// One unknown of the fit: a factor on one or more settings, which keep their ratios.
struct FreeParameter {
  std::string name;                     ///< as the user wrote it: "tensile_scale"
  std::vector<ScaledSetting> settings;  ///< at least one
  double low = 0;                       ///< least factor [-], > 0
  double high = 0;                      ///< largest factor [-], > low
};

/// Read a list such as "tensile_scale,mortar.young=10 GPa..30 GPa".
///
/// Parameters stand between commas. Each is a key of the scene ("phases.mortar.young", or without "phases."),
/// a property alone, which means that of every phase of the specimen that has it ("tensile_scale"), or
/// several of these with + between them. "=LOW..HIGH" gives bounds for the first of its settings; without
/// them it may be a twentieth to twenty times its value, as far as the setting allows.
/// @param scene  tells which phases the specimen has.
/// @throws Rejected (Exit::usage) about the option --free.
[[nodiscard]] std::vector<FreeParameter> parse_free(const std::string& text, const Settings& settings,
                                                    const mpm::Scene& scene);

/// Set all settings by the factors of their parameters.   @pre one factor a parameter.
void scale(Settings& settings, const std::vector<FreeParameter>& parameters,
           const std::vector<double>& factors);

/// Whether a factor has come to one of its bounds: within 5 %, as close as jumps of the peak
/// let a search come.
[[nodiscard]] bool is_at_low_bound(const FreeParameter& parameter, double factor);
[[nodiscard]] bool is_at_high_bound(const FreeParameter& parameter, double factor);

}  // namespace app
