/// What a stretch of steps ends with, for the history.
#pragma once

#include <cstdint>
#include <string>

namespace mpm {

/// Forces are those on the specimen, up is positive.
struct Ledger {
  double time = 0;                 ///< at the beginning of the last step [s]
  double platen_displacement = 0;  ///< then [m], its amount
  double force_top = 0;            ///< [N/m]
  double force_bottom = 0;         ///< [N/m]
  double platen_work = 0;          ///< [J/m]
  double kinetic = 0;              ///< [J/m]
  double elastic = 0;              ///< [J/m]
  double released = 0;             ///< [J/m]
  double damped = 0;               ///< [J/m]
  double left = 0;                 ///< energy of the points that left through open edges [J/m]
  std::int64_t tension_failures = 0;
  std::int64_t shear_failures = 0;
  std::int64_t left_points = 0;
  std::int64_t carrying_points = 0;  ///< that still have some stiffness
  std::int64_t diverged_at = -1;     ///< step at which something stopped being a number; -1 = nothing did
  std::string trouble;  ///< what went wrong otherwise, with the step and the point; empty = nothing
};

}  // namespace mpm
