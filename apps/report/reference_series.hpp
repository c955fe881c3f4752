/// What design codes would draw for a run, to lay over its curve.
#pragma once

#include <vector>

#include "apps/drawing/chart.hpp"
#include "apps/run/run_folder.hpp"

namespace output {

/// Curves of a concrete with the peak stress of the run, in the units of stress_chart: GB 50010, and EN
/// 1992-1-1 under compression; in tension the softening of Hordijk, smeared over the height of the specimen,
/// with the fracture energy of the fib Model Code 2010. Empty for runs without platens or without a peak.
[[nodiscard]] std::vector<Series> reference_series(const RunRecord& record);

}  // namespace output
