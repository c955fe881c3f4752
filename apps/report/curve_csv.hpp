/// curve.csv: the history as a table.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "libmpm/scene/result.hpp"

namespace output {

/// "stress_Pa", "work_J_per_m"; the name alone where the unit is "1".
[[nodiscard]] std::string column_title(std::string_view name, std::string_view unit);

/// All columns of the history, comma separated, one header line with the SI unit in each name (strain,
/// stress_Pa, platen_work_J_per_m ...). Numbers read back as the same doubles, in any locale.
[[nodiscard]] std::string curve_csv(const std::vector<mpm::HistoryRow>& history);

}  // namespace output
