/// How a problem is solved with moving points, and what that took.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "libmpm/solver/ledger.hpp"
#include "libmpm/scene/scene.hpp"

namespace mpm::problems {

struct Method {
  Shape shape = Shape::gimp;
  Scheme scheme = Scheme::musl;
  Transfer transfer = Transfer::flip;
  double flip_ratio = 1;
  Precision precision = Precision::double_;

  /// "GIMP MUSL FLIP"; "blend" for FLIP with a share of PIC, "PIC" without FLIP; "single" when it is.
  [[nodiscard]] std::string name() const;
  void give_to(Scene& scene) const;
};

[[nodiscard]] const std::vector<Shape>& all_shapes();

/// Every shape with every scheme and FLIP, a blend with PIC, and APIC.
[[nodiscard]] std::vector<Method> all_methods(double blend = 0.9);

/// What the time loop took; looking at the points is not counted.
struct Cost {
  double wall_time = 0;  ///< [s]
  std::int64_t point_updates = 0;
};

/// Takes steps of a solver and counts what they cost.
class Meter {
 public:
  explicit Meter(std::int64_t points) : points_(points) {}

  template <class Solver>
  Ledger advance(Solver& solver, std::int64_t steps) {
    const auto start = std::chrono::steady_clock::now();
    const std::int64_t before = solver.steps();
    Ledger ledger = solver.advance(steps);
    cost_.wall_time += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    cost_.point_updates += points_ * (solver.steps() - before);
    return ledger;
  }
  [[nodiscard]] const Cost& cost() const { return cost_; }

 private:
  std::int64_t points_;
  Cost cost_;
};

}  // namespace mpm::problems
