/// All cases of the bench of limits.
#pragma once

#include <string>
#include <vector>

#include "apps/bench/stability_case.hpp"

namespace app::bench {

/// In the order in which they are reported, those of a group one after the other; no name comes twice.
[[nodiscard]] const std::vector<StabilityCase>& stability_cases();

/// Cases by name, in the order of the table; all of them for no names.
/// @throws Rejected for a name that is none.
[[nodiscard]] std::vector<const StabilityCase*> select_cases(const std::vector<std::string>& names);

}  // namespace app::bench
