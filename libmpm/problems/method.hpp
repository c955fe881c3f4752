/// How a problem is solved with moving points, and what that took.
/// Soft bodies of moving points, thrown or driven, and sums over their points.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "libmpm/scene/scene.hpp"
#include "libmpm/solver/failure_maps.hpp"
#include "libmpm/solver/moving/moving_solver.hpp"
#include "libmpm/solver/plan.hpp"

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

inline constexpr std::uint8_t soft = 1;  ///< label of the material of soft_body()

/// A rectangle of a soft elastic material in which waves run at 100 m/s (nu = 0) or a little faster, so that
/// bodies can be thrown, turned and squeezed within few steps. Young's modulus 10 MPa, density 1000 kg/m^3.
[[nodiscard]] Scene soft_body(int rows, int cols, double pixel_size, double poisson = 0);

/// Leaves only the pixels whose centre lies in the disc; places in pixels from the lower left corner.
void keep_disc(Scene& scene, double x, double y, double radius);

/// Adds `count` points of a phase at irregular places that do not depend on anything else.
void add_irregular_points(Scene& scene, int count, std::uint8_t phase = soft);

/// Place in the picture [m].
struct Place {
  double x = 0, y = 0;
};

/// Where the point of a pixel, or an extra point, is before anything moves.
[[nodiscard]] Place rest_place(const Scene& scene, std::uint32_t id);

/// A scene with its plan and its solver.
template <class Real = double>
struct Moving {
  Scene scene;
  Plan plan;
  MovingSolver<Real> solver;
  Meter meter;

  explicit Moving(Scene what)
      : scene(std::move(what)),
        plan(mpm::plan(scene)),
        solver(scene, plan, pictured_start(scene, plan)),
        meter(count_points(scene)) {}
  Moving(const Moving&) = delete;
  Moving& operator=(const Moving&) = delete;

  Ledger advance(std::int64_t steps) { return meter.advance(solver, steps); }
  [[nodiscard]] Place rest_place(std::uint32_t id) const { return problems::rest_place(scene, id); }
};

/// Sums over all points.
struct Sums {
  double mass = 0, volume = 0;
  double px = 0, py = 0;  ///< momentum [kg/s]
  double spin = 0;        ///< angular momentum about the corner of the picture [kg m/s]
  double kinetic = 0;     ///< [J/m]
};
[[nodiscard]] Sums sums_of(const std::vector<PointView>& points);
template <class Real>
[[nodiscard]] Sums sums_of(const MovingSolver<Real>& solver) {
  return sums_of(solver.points());
}

/// Calls `solve` with a number of the precision that the method asks for.
template <class Solve>
auto in_precision(const Method& method, const Solve& solve) {
  if (method.precision == Precision::single) return solve(float());
  return solve(double());
}

}  // namespace mpm::problems
