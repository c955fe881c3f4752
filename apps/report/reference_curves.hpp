/// The curves of the design codes, normalised: stress over strength [-] against x = strain over the strain at
/// the peak [-], for a strength [Pa] of positive sign.
/// What design codes would draw for a run, to lay over its curve.
#pragma once

#include <vector>

#include "apps/drawing/chart.hpp"
#include "apps/report/run_record.hpp"

namespace output {

/// Tension.   Source: GB 50010, Annex C.
[[nodiscard]] double gb_tension(double x, double strength);
[[nodiscard]] double gb_tension_peak_strain(double strength);  ///< [-]

/// Compression; Young's modulus [Pa].   Source: GB 50010, Annex C.
[[nodiscard]] double gb_compression(double x, double strength, double young);
[[nodiscard]] double gb_compression_peak_strain(double strength);  ///< [-]

/// Compression; NaN beyond the ultimate strain of 3.5e-3, where the curve ends.   Source: EN 1992-1-1, 3.1.5.
[[nodiscard]] double en_compression(double x, double strength);
[[nodiscard]] double en_compression_peak_strain(double strength);  ///< [-]
[[nodiscard]] double en_young(double strength);                    ///< [Pa]
/// Mean compressive strength [Pa] of a concrete of a mean tensile strength [Pa], at most that of C50.
/// Source: EN 1992-1-1, table 3.1: f_ctm = 0.3 f_ck^(2/3) and f_cm = f_ck + 8 MPa.
[[nodiscard]] double en_compressive_strength(double tensile_strength);

/// Stress over tensile strength [-] against the opening of a crack over that at which it carries nothing [-],
/// in [0, 1].   Source: Hordijk (1991).
[[nodiscard]] double hordijk_softening(double opening);
/// Opening at which a crack carries nothing any more [m]; fracture energy [N/m].   Source: Hordijk (1991).
[[nodiscard]] double hordijk_last_opening(double fracture_energy, double tensile_strength);
/// Fracture energy [N/m] of a concrete of a mean compressive strength [Pa].   Source: fib Model Code
/// 2010, 5.1-9.
[[nodiscard]] double fib_fracture_energy(double compressive_strength);

/// Curves of a concrete with the peak stress of the run, in the units of stress_chart: GB 50010, and EN
/// 1992-1-1 under compression; in tension the softening of Hordijk, smeared over the height of the specimen,
/// with the fracture energy of the fib Model Code 2010. Empty for runs without platens or without a peak.
[[nodiscard]] std::vector<Series> reference_series(const RunRecord& record);

}  // namespace output
