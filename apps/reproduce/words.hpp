/// Numbers of a reproduction in sentences.
#pragma once

#include <string>

#include "apps/reproduce/figure.hpp"
#include "apps/statistics/statistics.hpp"

namespace app::reproduce {

[[nodiscard]] std::string megapascals(double stress);  ///< 3.43e6 -> "3.43 MPa"
[[nodiscard]] std::string microstrain(double strain);  ///< 149e-6 -> "149 microstrain"

/// Mean and standard deviation: "3.43 ± 0.05 MPa".
[[nodiscard]] std::string megapascals(const Spread& stress);
[[nodiscard]] std::string microstrain(const Spread& strain);

/// "one random specimen", "20 random specimens".
[[nodiscard]] std::string counted(int count, const std::string& noun);

/// Spread as JSON: mean, standard_deviation, least, largest.
[[nodiscard]] nlohmann::json json_of(const Spread& spread);

}  // namespace app::reproduce
