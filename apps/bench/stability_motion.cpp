// Points that move across cells, and towards each other.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/bench/stability.hpp"
#include "apps/bench/stability_motion.hpp"
#include "apps/bench/stability_scenes.hpp"

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
      .must(ledger.trouble.empty(),
            ledger.trouble.empty() ? fmt::format("{} steps", flight.solver.steps()) : ledger.trouble)
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

}  // namespace

std::vector<StabilityCase> motion_cases() {
  const std::string group = "Motion";
  std::vector<StabilityCase> cases;
  for (const Way& way : ways) {
    const bool adds = way.shape == mpm::Shape::linear;
    cases.push_back(
        {std::string("crossing-") + way.key, group,
         fmt::format("{}: a disc flies over a hundred cells with its momentum and {}", way.name,
                     adds ? "at most three times its energy (a limit: its points tremble more and more)"
                          : "no more energy"),
         [way] { return crossing(way); }});
    cases.push_back(
        {std::string("gap-") + way.key, group,
         fmt::format("{}: two blocks close the gap between them, do not stick before a cell or so, and "
                     "part with their momentum{}",
                     way.name, adds ? " (a limit: with more energy)" : ""),
         [way] { return closing_gap(way); }});
  }
  return cases;
}

}  // namespace app::bench
