/// How a study file says which values a parameter takes.
#pragma once

#include <toml++/toml.h>

#include <string_view>

#include "apps/study/study.hpp"

namespace app {

/// Whether a key is one of those that say how values spread: from, to, steps, low, high.
[[nodiscard]] bool is_spread_key(std::string_view key);

/// Read a list [1, 2, 3], equal steps {from, to, steps} or a range {low, high} into the parameter, whose
/// fields are known, and try each value on all of them.
/// @throws Mistake.
void read_values(const toml::node& node, StudyParameter& parameter);

}  // namespace app
