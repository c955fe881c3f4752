// A body that turns a thousand times.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/bench/stability.hpp"
#include "apps/bench/stability_motion.hpp"
#include "apps/bench/stability_scenes.hpp"

namespace app::bench {
namespace {

/// A disc of four cells across that turns with a rim speed of a twentieth of that of waves.
class Turning {
 public:
  Turning(mpm::Shape shape, mpm::Transfer transfer) : flight_(scene_of(shape, transfer)) {
    flight_.solver.kick([](const mpm::PointView& p, double& vx, double& vy) {
      vx = -rate * (p.y - 0.4);
      vy = rate * (p.x - 0.4);
    });
    start_ = sums_of(flight_.solver.points());
  }

  /// Goes on until it should have turned so often.
  void turn_until(double turns) {
    while (flight_.solver.time() * rate < turns * 2 * std::numbers::pi && ledger_.trouble.empty()) {
      ledger_ = flight_.solver.advance(200);
      most_energy_ = std::max(most_energy_, (ledger_.kinetic + ledger_.elastic) / start_.kinetic);
      for (const mpm::PointView& p : flight_.solver.points())
        largest_stress_ =
            std::max({largest_stress_, std::abs(p.stress.xx), std::abs(p.stress.yy), std::abs(p.stress.xy)});
    }
  }

  /// Angular momentum over that at the start, with what the velocity gradients of APIC hold [-].
  [[nodiscard]] double kept() const {
    double affine = 0;
    const double variance =
        0.25 * flight_.plan.cell_size * flight_.plan.cell_size;  // of a quadratic B-spline
    const auto points = flight_.solver.points();
    for (const mpm::PointView& p : points) affine += p.mass * variance * (p.gradient[2] - p.gradient[1]);
    return (sums_of(points).spin + affine) / start_.spin;
  }
  /// Distance of the outermost point from the centre, over the radius [-].
  [[nodiscard]] double growth() const {
    const auto points = flight_.solver.points();
    const Sums sums = sums_of(points);
    double largest = 0;
    for (const mpm::PointView& p : points)
      largest = std::max(largest, std::hypot(p.x - sums.x, p.y - sums.y));
    return largest / radius;
  }
  [[nodiscard]] double most_energy() const { return most_energy_; }  ///< over that at the start [-]
  [[nodiscard]] double largest_stress() const {
    return largest_stress_ / (1000 * rim * rim);
  }  ///< over rho v^2 [-]
  [[nodiscard]] const std::string& trouble() const { return ledger_.trouble; }
  [[nodiscard]] std::int64_t steps() const { return flight_.solver.steps(); }

 private:
  static constexpr double rim = 5;              ///< speed [m/s]
  static constexpr double radius = 0.2;         ///< [m]
  static constexpr double rate = rim / radius;  ///< [1/s]
  static mpm::Scene scene_of(mpm::Shape shape, mpm::Transfer transfer) {
    mpm::Scene scene = sky(16, 16);
    add_disc(scene, 8, 8, 4);
    scene.motion.margin = 0.4;
    scene.motion.shape = shape;
    scene.motion.transfer = transfer;
    return scene;
  }

  Flight flight_;
  Sums start_;
  mpm::Ledger ledger_;
  double most_energy_ = 0;
  double largest_stress_ = 0;
};

/// The first gathering takes the angular momentum of the scattered velocities at the rim; then nothing is
/// lost.
Finding turning_with_apic() {
  Turning disc(mpm::Shape::bspline, mpm::Transfer::apic);
  disc.turn_until(1);
  const double first_turn = disc.kept();
  disc.turn_until(1000);
  return Judge()
      .must(disc.trouble().empty(),
            disc.trouble().empty() ? fmt::format("{} steps", disc.steps()) : disc.trouble())
      .near("angular momentum after 1000 turns over that after one", disc.kept() / first_turn, 1, 2e-2)
      .note(fmt::format("of the start {:.3f} is kept", disc.kept()))
      .below("radius over that at the start", disc.growth(), 1.15)
      .below("most energy over that at the start", disc.most_energy(), 1.001)
      .below("largest stress over rho v^2 of the rim", disc.largest_stress(), 1)
      .finding();
}

/// FLIP keeps what the grid does not see: points turn with the smoothed velocity of the grid, behind their
/// own, and within a few turns of so coarse a disc its spin becomes a tremble, which stays bounded.
Finding turning_with_flip() {
  Turning disc(mpm::Shape::gimp, mpm::Transfer::flip);
  disc.turn_until(1);
  const double first_turn = disc.kept();
  disc.turn_until(1000);
  return Judge()
      .must(disc.trouble().empty(),
            disc.trouble().empty() ? fmt::format("{} steps", disc.steps()) : disc.trouble())
      .must(first_turn > 0.4,
            fmt::format("after one turn {:.3f} of the angular momentum is kept, after 1000 {:.3f}",
                        first_turn, disc.kept()))
      .below("radius over that at the start", disc.growth(), 2)
      .below("most energy over that at the start", disc.most_energy(), 2)
      .below("largest stress over rho v^2 of the rim", disc.largest_stress(), 100)
      .finding();
}

}  // namespace

std::vector<StabilityCase> turning_cases() {
  const std::string group = "Motion";
  return {
      {"turning-apic", group,
       "APIC: a disc turns a thousand times, and keeps its size, its energy and its angular momentum",
       turning_with_apic},
      {"turning-flip", group,
       "a limit: with FLIP the spin of a coarse disc becomes a tremble of its points within some turns; "
       "stress, "
       "energy and size stay bounded for a thousand",
       turning_with_flip},
  };
}

}  // namespace app::bench
