/// Which phases failed, and how.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "apps/run/run_folder.hpp"

namespace output {

struct FailureCount {
  std::string phase;
  std::int64_t points = 0;   ///< pixels of the phase, or extra points
  std::int64_t tension = 0;  ///< first failed in tension
  std::int64_t shear = 0;    ///< first failed in shear
  std::int64_t crushed = 0;  ///< failed in tension, then crushed in shear (crack closure only)
  [[nodiscard]] std::int64_t intact() const { return points - tension - shear; }
};

/// One row per phase that the mask holds, in the order of labels, voids included.
[[nodiscard]] std::vector<FailureCount> failures_by_phase(const RunRecord& record);

/// Extra points, which no pixel shows: what the totals of the result leave over. Crushed ones are among the
/// shear failures.
[[nodiscard]] FailureCount failures_of_extra_points(const RunRecord& record,
                                                    const std::vector<FailureCount>& by_phase);

}  // namespace output
