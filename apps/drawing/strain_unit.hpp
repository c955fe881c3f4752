/// The unit in which strains are shown.
#pragma once

#include <string>

#include "libmpm/scene/result.hpp"

namespace output {

struct StrainUnit {
  std::string name;   ///< "microstrain"
  double per_strain;  ///< how many of it are a strain of 1
};

/// Percent from a strain of 1 % on, microstrain below.
[[nodiscard]] StrainUnit strain_unit(double largest_strain);

/// For all strains of a run: that of the largest one.
[[nodiscard]] StrainUnit strain_unit(const mpm::Result& result);

/// "118 microstrain, 82 % of the peak strain"; without the share where the run has no peak.
/// @param decimals  of the share.
[[nodiscard]] std::string strain_words(const mpm::Result& result, double strain, int decimals);

}  // namespace output
