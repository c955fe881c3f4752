/// The exceptions of the solver.
/// How the checks of a scene are written: one line a rule.
/// All that is wrong with a scene at once; validate() throws the first of it.
#pragma once

#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "libmpm/scene/scene.hpp"

namespace mpm {

/// A user's mistake: which field, the value met, what is allowed, and how to cure it.
/// what() reads "field: value; allowed; cure" with the empty parts left out.
struct Error : std::runtime_error {
  Error(std::string field_name, std::string value_met, std::string what_is_allowed,
        std::string how_to_cure = {});

  std::string field;    ///< path in the scene, e.g. "phases.mortar.young"
  std::string value;    ///< the value met, with its unit
  std::string allowed;  ///< what would have been accepted
  std::string cure;     ///< what to try
};

/// A file could not be written or read.
struct FileError : Error {
  using Error::Error;
};

/// A value as messages show it: six digits, and its unit if it has one.
[[nodiscard]] inline std::string text(double value, const char* unit) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.6g%s%s", value, *unit != '\0' ? " " : "", unit);
  return buffer;
}

/// What is wrong with a scene, in the order in which the rules were looked at.
class Faults {
 public:
  /// `ok` is written so that not-a-number fails it.   @return ok.
  bool require(bool ok, const std::string& field, const std::string& value, const std::string& allowed,
               const std::string& cure = "") {
    if (!ok) found_.emplace_back(field, value, allowed, cure);
    return ok;
  }

  void add(const std::vector<Error>& others) { found_.insert(found_.end(), others.begin(), others.end()); }

  [[nodiscard]] std::vector<Error> found() && { return std::move(found_); }

 private:
  std::vector<Error> found_;
};

/// @throws the first one, where there is one.
inline void refuse_first(const std::vector<Error>& faults) {
  if (!faults.empty()) throw Error(faults.front());
}

/// Every value of a phase that is out of range; none of a valid one.
[[nodiscard]] std::vector<Error> faults(const Phase& phase, Plane plane);

/// Every rule that a scene breaks; none of a valid one.
[[nodiscard]] std::vector<Error> faults(const Scene& scene);

/// Those that can be told before there is a specimen: labels, pixel size, phases and extra points are not
/// looked at.
[[nodiscard]] std::vector<Error> faults_beside_specimen(const Scene& scene);

}  // namespace mpm
