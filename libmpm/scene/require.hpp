/// How the checks of a scene are written: one line a rule.
#pragma once

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "libmpm/scene/error.hpp"

namespace mpm {

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

}  // namespace mpm
