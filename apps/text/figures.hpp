/// Numbers and strains as text, the same in every locale.
#pragma once

#include <cstdint>
#include <string>

namespace output {

/// Shortest text that reads back as the same double; "nan", "inf", "-inf".
[[nodiscard]] std::string exact(double value);

/// For the eye: significant digits, thousands set apart by a narrow space, powers of ten beyond 1e-3 ... 1e7
/// ("1.25 × 10⁻⁷"), a proper minus sign; an en dash for what is no number.
[[nodiscard]] std::string rounded(double value, int digits = 3);

/// As rounded(), less the zeros behind the point that say nothing: for what somebody chose ("0.05").
[[nodiscard]] std::string concise(double value, int digits = 6);

/// As concise(), but a power of ten alone: "10⁻⁵" rather than "1 × 10⁻⁵".
[[nodiscard]] std::string concise_power(double value, int digits);

/// A fixed number of decimals, else as rounded().
[[nodiscard]] std::string with_decimals(double value, int decimals);

/// 92628 -> "92 628", with a narrow no-break space.
[[nodiscard]] std::string grouped(std::int64_t value);

/// 0.4513 -> "45.1 %".
[[nodiscard]] std::string percent(double share, int decimals = 1);

}  // namespace output

namespace app {

/// "940.3e-6", and "2.313 %" from 1 % on.
[[nodiscard]] std::string strain_text(double strain);

}  // namespace app
