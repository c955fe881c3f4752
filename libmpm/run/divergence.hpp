/// What is said of a run whose physics went wrong.
#pragma once

#include <cstdint>
#include <string>

#include "libmpm/solver/plan.hpp"
#include "libmpm/scene/scene.hpp"

namespace mpm {

/// What was seen, when and where.
struct Divergence {
  std::string what = {};   ///< "energy grows without work"
  std::int64_t step = 0;   ///< number of the step
  double time = 0;         ///< [s]
  double dt = 0;           ///< of the step [s]
  std::string point = {};  ///< where it is worst, by name with its phase; empty = nowhere in particular
  bool moving = false;     ///< the points move
};

/// What was seen with step, time and point, the likely cause and the cure: with a solver.cfl that is safe
/// where one is known.
[[nodiscard]] std::string divergence_text(const Scene& scene, const Plan& plan, const Divergence& divergence);

}  // namespace mpm
