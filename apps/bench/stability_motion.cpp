// Points that move across cells, towards each other, and round and round.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "apps/bench/stability_scenes.hpp"
#include "libmpm/problems/waves.hpp"

namespace app::bench {
namespace {

/// A shape function, and how much energy it may add: with linear ones the force of a point jumps at every
/// edge of a cell, which shakes the points as if from outside.
struct Way {
  mpm::Shape shape;
  const char* name;
  const char* key;
  double added_in_flight;   ///< at most, over that at the start [-]
  double added_in_contact;  ///< at most [-]
  double widest_gap;        ///< at which two bodies may meet, in cells [-]
};

// Two bodies meet when points of both reach a node: at most two cells apart with linear shapes, two and a
// half with GIMP and three with B-splines; the gap is that less half a cell, which is a pixel.
constexpr Way ways[] = {{mpm::Shape::linear, "linear", "linear", 2, 0.5, 1.5},
                        {mpm::Shape::gimp, "GIMP", "gimp", 2e-2, 5e-2, 2},
                        {mpm::Shape::bspline, "B-spline", "bspline", 2e-2, 5e-2, 2.5}};

double momentum_error(const Sums& now, const Sums& before) {
  return std::hypot(now.px - before.px, now.py - before.py) / std::hypot(before.px, before.py);
}

/// A disc, eight cells across, that breathes while it flies askew over a hundred cells.
Finding crossing(const Way& way) {
  mpm::Scene scene = sky(120, 220);
  add_disc(scene, 12, 12, 8);
  scene.motion.shape = way.shape;
  scene.motion.margin = 0.5;
  Flight flight(scene);
  flight.solver.kick([](const mpm::PointView& p, double& vx, double& vy) {
    vx = 10 + 2 * (p.x - 0.6);
    vy = 5 + 2 * (p.y - 0.6);
  });
  const Sums before = sums_of(flight.solver.points());
  double most = 0;
  mpm::Ledger ledger;
  while (flight.solver.time() < 1.0 && ledger.trouble.empty()) {
    ledger = flight.solver.advance(100);
    most = std::max(most, ledger.kinetic + ledger.elastic);
  }
  const Sums after = sums_of(flight.solver.points());
  return Judge()
      .no_trouble(ledger.trouble, flight.solver.steps())
      .must(after.x - before.x > 9.9,
            fmt::format("it has flown over {:.0f} cells", (after.x - before.x) / flight.plan.cell_size))
      .below("momentum off by", momentum_error(after, before), 1e-12)
      .below("most energy over that at the start, less 1,", most / before.kinetic - 1, way.added_in_flight)
      .finding();
}

/// Two blocks of eight by ten pixels that fly at each other at 2 m/s over a gap of ten pixels.
class Meeting {
 public:
  explicit Meeting(mpm::Shape shape) : flight_(scene_of(shape)) {
    flight_.solver.kick(
        [](const mpm::PointView& p, double& vx, double&) { vx = is_left(p) ? speed : -speed; });
    start_ = sums_of(flight_.solver.points());
  }

  /// Until they have parted.
  void run() {
    while (flight_.solver.time() < 0.3 && ledger_.trouble.empty()) {
      ledger_ = flight_.solver.advance(1);
      look();
    }
  }

  /// Between the surfaces when they first felt each other, in cells; < 0 = they have not [-].
  [[nodiscard]] double gap() const { return gap_; }
  /// Mean speed of the left one over that at the start [-].
  [[nodiscard]] double rebound() const { return left_speed_ / speed; }
  /// Momentum of both over that of one at the start [-].
  [[nodiscard]] double momentum() const {
    const Sums now = sums_of(flight_.solver.points());
    return std::hypot(now.px, now.py) / (0.5 * start_.mass * speed);
  }
  [[nodiscard]] double added_energy() const { return most_energy_ / start_.kinetic - 1; }  ///< at most [-]
  [[nodiscard]] const std::string& trouble() const { return ledger_.trouble; }

 private:
  static constexpr double speed = 2;
  static constexpr int columns = 44;

  static mpm::Scene scene_of(mpm::Shape shape) {
    mpm::Scene scene = sky(16, columns);
    scene.labels.block(4, 4, 8, 10).setConstant(first);
    scene.labels.block(4, 24, 8, 10).setConstant(first);
    scene.motion.shape = shape;
    scene.motion.margin = 0.2;
    return scene;
  }
  [[nodiscard]] static bool is_left(const mpm::PointView& p) { return p.id % columns < columns / 2 - 2; }

  void look() {
    most_energy_ = std::max(most_energy_, ledger_.kinetic + ledger_.elastic);
    double end_of_left = 0;
    double begin_of_right = mpm::Phase::unbreakable;
    double momentum = 0;
    for (const mpm::PointView& p : flight_.solver.points()) {
      if (is_left(p)) {
        end_of_left = std::max(end_of_left, p.x);
        momentum += p.mass * p.vx;
      } else {
        begin_of_right = std::min(begin_of_right, p.x);
      }
    }
    left_speed_ = momentum / (0.5 * start_.mass);
    if (gap_ < 0 && std::abs(left_speed_ / speed - 1) > 1e-6)
      gap_ = (begin_of_right - end_of_left - flight_.scene.pixel_size) / flight_.plan.cell_size;
  }

  Flight flight_;
  Sums start_;
  mpm::Ledger ledger_;
  double gap_ = -1;
  double left_speed_ = speed;
  double most_energy_ = 0;
};

Finding closing_gap(const Way& way) {
  Meeting meeting(way.shape);
  meeting.run();
  return Judge()
      .must(meeting.trouble().empty() && meeting.gap() > 0 && meeting.gap() <= way.widest_gap,
            fmt::format("they feel each other at a gap of {:.2f} cells (at most {:g})", meeting.gap(),
                        way.widest_gap))
      .below("momentum over that of one", meeting.momentum(), 1e-12)
      .must(meeting.rebound() < -0.75, fmt::format("they part at {:.2f} of their speed", -meeting.rebound()))
      .below("energy added at most", meeting.added_energy(), way.added_in_contact)
      .finding();
}

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

/// How far a disc that turns may come from what it was [-].
struct TurningLimits {
  double radius, energy, stress;
};

/// A thousand turns.   @param spin  judges what is kept of the angular momentum after one of them, and in the
/// end.
template <class Spin>
Finding turning(mpm::Shape shape, mpm::Transfer transfer, const TurningLimits& limits, const Spin& spin) {
  Turning disc(shape, transfer);
  disc.turn_until(1);
  const double first_turn = disc.kept();
  disc.turn_until(1000);
  Judge judge;
  judge.no_trouble(disc.trouble(), disc.steps());
  spin(judge, first_turn, disc.kept());
  return judge.below("radius over that at the start", disc.growth(), limits.radius)
      .below("most energy over that at the start", disc.most_energy(), limits.energy)
      .below("largest stress over rho v^2 of the rim", disc.largest_stress(), limits.stress)
      .finding();
}

/// The first gathering takes the angular momentum of the scattered velocities at the rim; then nothing is
/// lost.
Finding turning_with_apic() {
  return turning(
      mpm::Shape::bspline, mpm::Transfer::apic, {1.15, 1.001, 1},
      [](Judge& judge, double first_turn, double last) {
        judge.near("angular momentum after 1000 turns over that after one", last / first_turn, 1, 2e-2)
            .note(fmt::format("of the start {:.3f} is kept", last));
      });
}

/// FLIP keeps what the grid does not see: points turn with the smoothed velocity of the grid, behind their
/// own, and within a few turns of so coarse a disc its spin becomes a tremble, which stays bounded.
Finding turning_with_flip() {
  return turning(
      mpm::Shape::gimp, mpm::Transfer::flip, {2, 2, 100}, [](Judge& judge, double first_turn, double last) {
        judge.must(first_turn > 0.4,
                   fmt::format("after one turn {:.3f} of the angular momentum is kept, after 1000 {:.3f}",
                               first_turn, last));
      });
}

/// FLIP keeps the noise of points that cross cells, and MUSL maps it back: the more, the longer and the more
/// steps there are.
Finding fine_grid_of_musl() {
  Judge judge;
  mpm::problems::Method method{mpm::Shape::gimp, mpm::Scheme::musl, mpm::Transfer::flip};
  const auto error = [&](double cfl) {
    const mpm::problems::Deformation found = mpm::problems::deform_as_made_up(method, 64, 0.05, cfl);
    return found.trouble.empty() ? found.error : std::numeric_limits<double>::infinity();
  };
  judge.note(fmt::format("error at CFL 0.4 {:.3g}", error(0.4)));
  judge.below("at CFL 0.2", error(0.2), 0.06);
  method.transfer = mpm::Transfer::apic;
  judge.below("with APIC at CFL 0.4", error(0.4), 0.04);
  return judge.finding();
}

}  // namespace

std::vector<StabilityCase> motion_cases() {
  std::vector<StabilityCase> cases;
  for (const Way& way : ways) {
    const bool adds = way.shape == mpm::Shape::linear;
    cases.push_back(
        {std::string("crossing-") + way.key,
         fmt::format("{}: a disc flies over a hundred cells with its momentum and {}", way.name,
                     adds ? "at most three times its energy (a limit: its points tremble more and more)"
                          : "no more energy"),
         [way] { return crossing(way); }});
    cases.push_back(
        {std::string("gap-") + way.key,
         fmt::format("{}: two blocks close the gap between them, do not stick before a cell or so, and "
                     "part with their momentum{}",
                     way.name, adds ? " (a limit: with more energy)" : ""),
         [way] { return closing_gap(way); }});
  }
  cases.insert(
      cases.end(),
      {
          {"turning-apic",
           "APIC: a disc turns a thousand times, and keeps its size, its energy and its angular momentum",
           turning_with_apic},
          {"turning-flip",
           "a limit: with FLIP the spin of a coarse disc becomes a tremble of its points within some turns; "
           "stress, "
           "energy and size stay bounded for a thousand",
           turning_with_flip},
          {"fine-grid-musl",
           "a limit: GIMP, MUSL and FLIP over six cells of a fine grid go wrong at a CFL number of 0.4; half "
           "of "
           "it, or APIC, is right",
           fine_grid_of_musl},
      });
  return cases;
}

}  // namespace app::bench
