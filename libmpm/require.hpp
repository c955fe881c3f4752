/// How the checks of a scene are written: one line a rule.
#pragma once

#include <cstdio>
#include <string>

#include "libmpm/error.hpp"

namespace mpm {

/// A value as messages show it: six digits, and its unit if it has one.
[[nodiscard]] inline std::string text(double value, const char* unit) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.6g%s%s", value, *unit != '\0' ? " " : "", unit);
  return buffer;
}

/// `ok` is written so that not-a-number fails it.   @throws Error unless ok.
inline void require(bool ok, const std::string& field, const std::string& value, const char* allowed,
                    const char* cure = "") {
  if (!ok) throw Error(field, value, allowed, cure);
}

}  // namespace mpm
