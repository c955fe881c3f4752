/// Figures that follow from a result and its scene, curve.csv among them.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "apps/report/run_record.hpp"
#include "libmpm/scene/result.hpp"

namespace output {

/// What of a peak is not the strength of a specimen in equilibrium [-].
struct InertiaShares {
  double imbalance = 0;  ///< see mpm::platen_imbalance()
  double kinetic = 0;    ///< kinetic energy over the work of the platens
  double damped = 0;     ///< work of local damping so far over that of the platens
};

/// Row of the history at the peak; the one with the largest stress where no stress has passed through the
/// specimen.   @pre the history is not empty.
[[nodiscard]] const mpm::HistoryRow& peak_row(const mpm::Result& result);

/// All 0 at rest.
[[nodiscard]] InertiaShares inertia_of(const mpm::HistoryRow& row);

/// "stress_Pa", "work_J_per_m"; the name alone where the unit is "1".
[[nodiscard]] std::string column_title(std::string_view name, std::string_view unit);

/// All columns of the history, comma separated, one header line with the SI unit in each name (strain,
/// stress_Pa, platen_work_J_per_m ...). Numbers read back as the same doubles, in any locale.
[[nodiscard]] std::string curve_csv(const std::vector<mpm::HistoryRow>& history);

/// The same with what a fixture adds: displacement_m and force_N of the leading load, and a column for each
/// gauge, NAME_m.
[[nodiscard]] std::string curve_csv(const RunRecord& record);

/// Force of the leading load [N] at a stress [Pa], its displacement [m] at a strain [-].
[[nodiscard]] double leading_force(const mpm::Scene& scene, double stress);
[[nodiscard]] double leading_displacement(const mpm::Scene& scene, double strain);

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

/// Of summary.json and of all that names a run in JSON: peak_reached, peak_stress_Pa and peak_strain, which
/// are null where the largest stress is no peak, and that stress and its strain under names of their own.
[[nodiscard]] nlohmann::json peak_figures(const mpm::Result& result);

/// Stress over strain where the stress first reaches 40 % of its largest value [Pa]; NaN where there is none.
[[nodiscard]] double secant_modulus(const mpm::Result& result);

/// Area share of each phase that the mask holds [-], in the order of labels.
[[nodiscard]] std::vector<std::pair<std::string, double>> phase_shares(const specimen::LabelledMask& mask);

/// Notes of the record, and the one about damage pictures that are missing.
[[nodiscard]] std::vector<std::string> all_notes(const RunRecord& record);

}  // namespace output
