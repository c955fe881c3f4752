/// The curves of the design codes, normalised: stress over strength [-] against x = strain over the strain at
/// the peak [-], for a strength [Pa] of positive sign.
#pragma once

namespace app::reproduce {

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

}  // namespace app::reproduce
