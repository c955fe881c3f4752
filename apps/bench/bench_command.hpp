/// What the benches found, as JSON: a list with an object for each line of their tables.
/// mesopix bench: how exact the program is for its time, measured on the spot.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "apps/bench/error_study.hpp"
#include "apps/bench/feature_study.hpp"
#include "apps/bench/stability.hpp"
#include "apps/command/command.hpp"

namespace app::bench {

[[nodiscard]] nlohmann::ordered_json error_json(const std::vector<ProblemResult>& results);
[[nodiscard]] nlohmann::ordered_json stability_json(const StabilityOutcome& outcome);
[[nodiscard]] nlohmann::ordered_json feature_json(const std::vector<FeatureCost>& costs);

}  // namespace app::bench

namespace app {

[[nodiscard]] CommandPointer bench_command(CLI::App& program);

}  // namespace app
