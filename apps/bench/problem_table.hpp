/// All problems of the bench of errors.
#pragma once

#include <string>
#include <vector>

#include "apps/bench/error_study.hpp"

namespace app::bench {

[[nodiscard]] std::vector<Problem> all_problems();

/// Those of these names, or all for none.   @throws Rejected (Exit::usage) for a name that is not there.
[[nodiscard]] std::vector<Problem> select_problems(const std::vector<std::string>& names);

}  // namespace app::bench
