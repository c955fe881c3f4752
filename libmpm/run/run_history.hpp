/// What a run writes down at each row of its history, and what the rows tell of it.
#pragma once

#include "libmpm/solver/ledger.hpp"
#include "libmpm/solver/plan.hpp"
#include "libmpm/scene/result.hpp"
#include "libmpm/scene/scene.hpp"

namespace mpm {

/// The row of a specimen that nothing has happened to yet.
[[nodiscard]] HistoryRow first_row(const Scene& scene, const Plan& plan);

/// The row of a ledger; all of it but the points that move.
[[nodiscard]] HistoryRow history_row(const Scene& scene, const Ledger& ledger);

/// Adds a row, and what the result says of all rows together.
void add_row(Result& result, const HistoryRow& row);

/// Of the strain, or without platens of the time, at which the run ends [-].
[[nodiscard]] double share_done(const Scene& scene, const HistoryRow& row);

/// Whether a step made more energy than came in.   @param first  row of the history.
[[nodiscard]] bool makes_energy(const HistoryRow& row, const HistoryRow& first);

/// Says how well the energies of the history add up.
void close_ledger(Result& result);

}  // namespace mpm
