/// What was measured on twins, for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "apps/twin/twinning.hpp"

namespace app {

/// SI units in the names of the keys; what does not exist is null.
[[nodiscard]] nlohmann::ordered_json twins_json(const TwinTask& task, const std::vector<TwinRecord>& twins,
                                                const specimen::Misfit& misfit);

/// A line for the original and for each twin, SI units in the names of the columns.
[[nodiscard]] std::string twins_csv(const TwinTask& task, const std::vector<TwinRecord>& twins);

}  // namespace app
