/// What a run has in it and what it leaves out, as text and as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "libmpm/run/explain.hpp"

namespace app {

/// A table of the features, those that are in first.
[[nodiscard]] std::string explanation_text(const mpm::Explanation& explanation);

[[nodiscard]] nlohmann::ordered_json explanation_json(const mpm::Explanation& explanation);

}  // namespace app
