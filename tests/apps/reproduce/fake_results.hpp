/// Results that were never computed, for tests of what figures make of them.
#pragma once

#include <utility>

#include "apps/reproduce/trial.hpp"
#include "libmpm/scene/result.hpp"
#include "tests/apps/triangle.hpp"

namespace test {

/// As if the trial had been run.
inline void put(app::reproduce::TrialResults& outcomes, const app::reproduce::Trial& trial,
                mpm::Result result) {
  outcomes.expect(trial);
  auto& outcome = outcomes.of(trial);
  outcome.result = std::move(result);
  outcome.done = true;
}

}  // namespace test
