/// Where the localised crack of a specimen with few aggregates runs.
#pragma once

#include <string>

#include "libmpm/scene/result.hpp"
#include "specimen/body/specimen.hpp"

namespace app::reproduce {

/// The late failures of a column of the specimen: those between the strain at the peak and 150 % of it. The
/// crack is the band of `crack_band` that holds the most of them. A run without a peak has none.
struct CrackPlace {
  double height = 0;  ///< mean height of the failures in the band [m]; NaN without late failures
  double share = 0;   ///< of the late failures that lie in the band [-]
};

inline constexpr double crack_band = 5e-3;  ///< [m]

/// @param left, right  the columns whose centres lie between them [m].
/// @pre the maps of the result have the shape of the mask.
[[nodiscard]] CrackPlace crack_between(const specimen::LabelledMask& mask, const mpm::Result& result,
                                       double left, double right);

/// Past which end of an aggregate the crack runs.
enum class CrackSide { top, bottom, elsewhere };

struct CrackBeside {
  CrackSide side = CrackSide::elsewhere;
  double height = 0;  ///< of the crack [m]; NaN without one
};

/// The crack in the columns that an aggregate covers: near its top or bottom when its height is within
/// `crack_band` of it.
[[nodiscard]] CrackBeside crack_beside(const specimen::LabelledMask& mask, const mpm::Result& result,
                                       const specimen::Ellipse& aggregate);

}  // namespace app::reproduce
