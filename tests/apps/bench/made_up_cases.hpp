/// Cases that hold, fail and throw as they are told.
#pragma once

#include <stdexcept>
#include <vector>

#include "apps/bench/stability.hpp"

namespace test {

inline std::vector<app::bench::StabilityCase> made_up_cases() {
  using app::bench::Finding;
  return {
      {"good", "it holds",
       [] {
         return Finding{true, "0.1 of \"1\", <fine>"};
       },
       "First"},
      {"bad", "it holds",
       [] {
         return Finding{false, "NOT AS IT MUST BE: 3"};
       },
       "First"},
      {"thrown", "it holds", []() -> Finding { throw std::runtime_error("no memory"); }, "Second"},
  };
}

/// Runs those of the cases that are given, by place.
inline app::bench::StabilityOutcome run_made_up(const std::vector<std::size_t>& places, int workers = 1,
                                                const std::function<bool()>& go_on = {}) {
  static const std::vector<app::bench::StabilityCase> cases = made_up_cases();
  std::vector<const app::bench::StabilityCase*> some;
  for (const std::size_t place : places) some.push_back(&cases[place]);
  return app::bench::run_cases(some, workers, {{}, go_on});
}

}  // namespace test
