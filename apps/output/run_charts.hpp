/// The charts of a run.
#pragma once

#include "apps/output/chart.hpp"
#include "apps/run_folder.hpp"

namespace output {

/// Stress [MPa] against strain [microstrain], the peak marked.
[[nodiscard]] Chart stress_chart(const RunRecord& record);

/// The ledger of energies [J per m of thickness] against strain; damping only where there is any.
[[nodiscard]] Chart energy_chart(const RunRecord& record);

/// Points that have failed so far, against strain.
[[nodiscard]] Chart failure_chart(const RunRecord& record);

}  // namespace output
