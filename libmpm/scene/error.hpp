/// The exceptions of the solver, and the checks of a scene: one line per rule. faults() collects every fault
/// of a scene; validate() throws the first.
#pragma once

#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "libmpm/scene/scene.hpp"

namespace mpm {

/// A user's mistake: the field, its value, what is allowed, and how to correct it.
/// what() reads "field: value; allowed; cure" without the empty parts. Numbers carry their unit (SI, angles
/// in degrees), e.g. "phases.mortar.young: -2e+10 Pa; must be > 0".
struct Error : std::runtime_error {
  Error(std::string field_name, std::string value_met, std::string what_is_allowed,
        std::string how_to_cure = {});

  std::string field;    ///< path in the scene, e.g. "phases.mortar.young"
  std::string value;    ///< the value found, with its unit
  std::string allowed;  ///< what is accepted instead
  std::string cure;     ///< what to try
};

/// A file could not be read or written; Error::field is its path.
struct FileError : Error {
  using Error::Error;
};

/// A value as messages show it: six significant digits and its unit, e.g. "0.5 m".
/// @param value  in the unit.   @param unit  empty for a dimensionless value.   Never throws.
[[nodiscard]] inline std::string text(double value, const char* unit) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.6g%s%s", value, *unit != '\0' ? " " : "", unit);
  return buffer;
}

/// The faults of a scene, in the order of the checks.
class Faults {
 public:
  /// Adds a fault unless `ok`. Write the condition so that it is false for not-a-number.
  /// @param value  as text, with its unit.   @return ok.
  bool require(bool ok, const std::string& field, const std::string& value, const std::string& allowed,
               const std::string& cure = "") {
    if (!ok) found_.emplace_back(field, value, allowed, cure);
    return ok;
  }

  void add(const std::vector<Error>& others) { found_.insert(found_.end(), others.begin(), others.end()); }

  [[nodiscard]] bool none() const { return found_.empty(); }
  [[nodiscard]] std::vector<Error> found() && { return std::move(found_); }

 private:
  std::vector<Error> found_;
};

/// @throws Error, the first fault, unless the list is empty.
inline void refuse_first(const std::vector<Error>& faults) {
  if (!faults.empty()) throw Error(faults.front());
}

/// Every value of a phase that is out of range; empty for a valid phase.
[[nodiscard]] std::vector<Error> faults(const Phase& phase, Plane plane);

/// Every rule that supports, loads and gauges violate, but for what only their place on the grid shows.
[[nodiscard]] std::vector<Error> fixture_faults(const Scene& scene);

/// Every rule that a scene violates; empty for a valid scene.
[[nodiscard]] std::vector<Error> faults(const Scene& scene);

/// The same without the rules that need a specimen: labels, pixel size, phases and extra points are not
/// checked.
[[nodiscard]] std::vector<Error> faults_beside_specimen(const Scene& scene);

}  // namespace mpm
