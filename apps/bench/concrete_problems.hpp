/// Problems of concrete, whose answer is a slow and fine run of our own.
#pragma once

#include "apps/bench/error_study.hpp"
#include "apps/reproduce/trial.hpp"

namespace app::bench {

/// The paper's tension test: peak stress.
/// @param settings  given to every run, e.g. to make the specimen small.
[[nodiscard]] Problem tension_problem(const std::vector<reproduce::Setting>& settings = {});

/// Young's modulus of the random specimen.
[[nodiscard]] Problem modulus_problem(const std::vector<reproduce::Setting>& settings = {});

}  // namespace app::bench
