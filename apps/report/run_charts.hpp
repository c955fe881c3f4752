/// The charts of a run and its specimen.
#pragma once

#include <string>
#include <vector>

#include "apps/drawing/chart.hpp"
#include "apps/report/run_record.hpp"
#include "specimen/body/specimen.hpp"

namespace output {

/// The stress [MPa] of a result against its strain in a unit.
[[nodiscard]] Series stress_series(const std::string& name, Ink ink, const mpm::Result& result,
                                   double per_strain = 1e6);

/// Stress [MPa] against strain [microstrain], the peak marked.
[[nodiscard]] Chart stress_chart(const RunRecord& record);

/// The ledger of energies [J per m of thickness] against strain; damping only where there is any.
[[nodiscard]] Chart energy_chart(const RunRecord& record);

/// Points that have failed so far, by phase and mode, against strain: pixels, and the extra points in one.
[[nodiscard]] Chart failure_chart(const RunRecord& record);

/// Number of pixels that failed, by strain and mode, in sixty classes up to the end of the run.
[[nodiscard]] Chart failure_strain_chart(const RunRecord& record);

/// Sieve curve of the aggregates by area [%] against diameter [mm]; without series when there are none.
[[nodiscard]] Chart sieve_chart(const specimen::Specimen& specimen);

/// The sieve curves of DIN 1045-2 and of Fuller between the sizes of the specimen, and Fuller's in a plane
/// cut after Walraven.
[[nodiscard]] std::vector<Series> sieve_references(const specimen::Specimen& specimen);

}  // namespace output
