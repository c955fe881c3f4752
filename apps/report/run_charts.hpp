/// The charts of a run.
#pragma once

#include "apps/drawing/chart.hpp"
#include "apps/run/run_folder.hpp"

namespace output {

/// Stress [MPa] against strain [microstrain], the peak marked.
[[nodiscard]] Chart stress_chart(const RunRecord& record);

/// The ledger of energies [J per m of thickness] against strain; damping only where there is any.
[[nodiscard]] Chart energy_chart(const RunRecord& record);

/// Points that have failed so far, by phase and mode, against strain: pixels, and the extra points in one.
[[nodiscard]] Chart failure_chart(const RunRecord& record);

/// How many pixels failed at which strain, by mode, in sixty classes up to the end of the run.
[[nodiscard]] Chart failure_strain_chart(const RunRecord& record);

}  // namespace output
