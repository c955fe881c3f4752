#include "libmpm/run/explain.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <memory>
#include <utility>

#include "libmpm/scene/error.hpp"
#include "libmpm/solver/lattice/lattice_solver.hpp"
#include "libmpm/solver/moving/moving_solver.hpp"
#include "libmpm/solver/plan.hpp"

namespace mpm {
namespace {

using kernels::Check;

/// A run that is advanced in stretches and timed.
class Stretches {
 public:
  virtual ~Stretches() = default;
  /// Seconds for so many steps. @param rows  of the history, which closes a ledger each.
  [[nodiscard]] virtual double take(std::int64_t steps, std::int64_t rows) = 0;
};

template <class Solver>
class StretchesOf : public Stretches {
 public:
  template <class... Arguments>
  explicit StretchesOf(const Scene& scene, const Plan& plan, Arguments&&... arguments)
      : plan_(endless(plan)), solver_(scene, plan_, std::forward<Arguments>(arguments)...) {}

  double take(std::int64_t steps, std::int64_t rows) override {
    const auto start = std::chrono::steady_clock::now();
    for (std::int64_t row = 0; row < rows; ++row) (void)solver_.advance(steps / rows);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

 private:
  static Plan endless(Plan plan) {
    plan.steps = std::int64_t{1} << 60;
    plan.threads = 1;  // a time per point and core
    return plan;
  }

  Plan plan_;
  Solver solver_;
};

template <class Real>
std::unique_ptr<Stretches> stretches_of(const Scene& scene, const Plan& plan, bool moving) {
  if (moving)
    return std::make_unique<StretchesOf<MovingSolver<Real>>>(scene, plan, pictured_start(scene, plan));
  return std::make_unique<StretchesOf<LatticeSolver<Real>>>(scene, plan);
}

std::unique_ptr<Stretches> stretches_of(const Scene& scene, const Plan& plan, bool moving) {
  return scene.precision == Precision::single ? stretches_of<float>(scene, plan, moving)
                                              : stretches_of<double>(scene, plan, moving);
}

/// A run to be timed: the plan and which solver, and how often it writes a row.
struct Variant {
  Plan plan;
  bool moving = false;
  bool ledger_each_step = false;
};

/// Times runs of one scene against each other.
class Stopwatch {
 public:
  explicit Stopwatch(const Scene& scene) : scene_(scene) {
    // However short the run, its first steps are to be had.
    scene_.loading.stop_strain = 0.999;
    scene_.loading.duration = 1e9;
    for (const auto label : scene.labels.reshaped()) points_ += scene.phases[label] ? 1 : 0;
    points_ += static_cast<double>(scene.extra_points.size());
  }

  /// Time of a point and step [s]: the fastest of the stretches that the two take in turn, which other
  /// programs disturbed least.
  struct Pair {
    double first = 0, second = 0;
  };
  [[nodiscard]] Pair compare(const Variant& first, const Variant& second) const {
    // A few milliseconds a stretch; the first one warms up.
    const double wanted = first.moving || second.moving ? 3e5 : 1.5e6;
    const auto steps = std::max<std::int64_t>(4, static_cast<std::int64_t>(wanted / points_));
    const auto a = stretches_of(scene_, first.plan, first.moving);
    const auto b = stretches_of(scene_, second.plan, second.moving);
    double fastest_a = Phase::unbreakable;
    double fastest_b = Phase::unbreakable;
    for (int i = 0; i < stretches; ++i) {
      fastest_a = std::min(fastest_a, a->take(steps, first.ledger_each_step ? steps : 1));
      fastest_b = std::min(fastest_b, b->take(steps, second.ledger_each_step ? steps : 1));
    }
    const double updates = points_ * static_cast<double>(steps);
    return {fastest_a / updates, fastest_b / updates};
  }

 private:
  static constexpr int stretches = 9;

  Scene scene_;
  double points_ = 0;
};

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

/// The features of a scene one after the other, each with the plan that has it the other way round.
class Catalogue {
 public:
  Catalogue(const Scene& scene, const Plan& plan)
      : scene_(scene), plan_(plan), moving_(scene.kinematics == Kinematics::moving) {
    real_ = scene.precision == Precision::single ? 4 : 8;
    // Thresholds are kept in 32 bits on the lattice, as all else in the records of moving points.
    threshold_ = moving_ ? real_ : 4;
  }

  struct Entry {
    Feature feature;
    std::optional<Variant> other;  ///< the run with the feature the other way round
  };

  [[nodiscard]] std::vector<Entry> entries() {
    add_kinematics();
    add_failure();
    add_common();
    if (moving_) add_motion();
    return std::move(entries_);
  }

  [[nodiscard]] Variant as_planned() const { return {plan_, moving_, false}; }
  [[nodiscard]] double bytes() const {
    const moving::OptionalFields& optional = plan_.moving.optional;
    const double maps = plan_.features.check != Check::none ? map_bytes() : 0;
    const double frame = scene_.frames > 0 ? sizeof(FramePoint) : 0;
    if (moving_) return record_layout(optional).fields * real_ + 4 + maps + frame;
    double bytes = real_ * (plan_.features.one_poisson_ratio ? 1 : 2);
    if (plan_.features.check != Check::none) bytes += 4;
    if (plan_.features.check == Check::tension_and_shear) bytes += 4;
    if (plan_.features.crack_closure) bytes += 4;
    return bytes + maps + frame;
  }

 private:
  void add(std::string name, bool in, std::string why, double bytes, std::optional<Variant> other) {
    entries_.push_back({{std::move(name), in, std::move(why), bytes, std::nullopt}, other});
  }
  /// The planned run with its plan changed.
  [[nodiscard]] Variant changed(const std::function<void(Plan&)>& change) const {
    Variant variant = as_planned();
    change(variant.plan);
    return variant;
  }
  [[nodiscard]] double map_bytes() const { return 5.0 + (plan_.features.crack_closure ? 4 : 0); }

  void add_kinematics() {
    // A point that stays has neither place, nor velocity, mass and volume, nor stress of its own.
    const double bytes = real_ * 9 + 4;
    const auto kinematics = scene_.kinematics;
    if (moving_) {
      add("moving points", true, "solver.kinematics is moving", bytes, std::nullopt);
      add("checks for the hand-over", false, "points move from the start", 0, std::nullopt);
      return;
    }
    Scene moving = scene_;
    moving.kinematics = Kinematics::moving;
    moving.pixel_cells = false;  // one point a cell instead
    add("moving points", false,
        kinematics == Kinematics::automatic
            ? "small strain at first: stress follows from the nodes, points keep their place"
            : "solver.kinematics is small_strain: stress follows from the nodes, points keep their place",
        bytes,
        scene_.loading.stop_strain > 0 ? std::optional(Variant{mpm::plan(moving), true, false})
                                       : std::nullopt);
    add("checks for the hand-over", kinematics == Kinematics::automatic,
        kinematics == Kinematics::automatic ? "solver.kinematics is auto; checked at each row of the history"
                                            : "solver.kinematics is small_strain",
        0, std::nullopt);
  }

  void add_failure() {
    const Check check = plan_.features.check;
    const bool closure = plan_.features.crack_closure;
    const auto with_check = [&](Check wanted) {
      return changed([&](Plan& plan) {
        plan.features.check = plan.moving.features.check = wanted;
        plan.moving.optional.tension = wanted != Check::none;
        plan.moving.optional.crush = wanted == Check::tension_and_shear;
      });
    };
    const bool usual = scene_.points_per_cell == 2 || scene_.pixel_cells || moving_;
    add("tension test and its threshold", check != Check::none,
        check != Check::none ? "a phase can fail" : "no phase in the specimen can fail", threshold_,
        check == Check::none ? std::optional(with_check(usual ? Check::tension : Check::tension_and_shear))
                             : std::nullopt);
    const bool shear = check == Check::tension_and_shear;
    add("shear test and its threshold", shear,
        shear ? "a phase can fail in shear, or the kernel always includes it"
              : "no phase in the specimen can fail in shear",
        threshold_,
        check == Check::tension ? std::optional(with_check(Check::tension_and_shear)) : std::nullopt);
    add("failure maps", check != Check::none,
        check != Check::none ? "where, when and how points fail" : "nothing can fail", map_bytes(),
        std::nullopt);
    add("stored strength factors", plan_.softens,
        plan_.softens ? "a phase has a fracture energy: its points are checked in many steps"
                      : "no phase has a fracture energy; factors are computed again when a point fails",
        8, std::nullopt);
    add("crack closure", closure,
        closure                                            ? "damage.crack_closure is on"
        : scene_.damage.crack_closure == CrackClosure::off ? "damage.crack_closure is off"
                                                           : "nothing can crack",
        moving_ ? real_ : 4, closure ? std::nullopt : std::optional(with_closure()));
  }

  [[nodiscard]] Variant with_closure() const {
    return changed([](Plan& plan) {
      plan.features.crack_closure = plan.moving.features.crack_closure = true;
      plan.features.check = plan.moving.features.check = Check::tension_and_shear;
      plan.moving.optional.tension = plan.moving.optional.crush = plan.moving.optional.cracked = true;
    });
  }

  void add_common() {
    add("out-of-plane stress", false,
        scene_.plane == Plane::stress
            ? "it is zero in plane stress"
            : "in plane strain it is nu (sx + sy), always the middle principal stress",
        real_, std::nullopt);
    const bool damping = plan_.features.damping;
    add("local damping", damping,
        damping ? "solver.local_damping is " + number(scene_.local_damping) : "solver.local_damping is 0", 0,
        changed([&](Plan& plan) { plan.features.damping = plan.moving.features.damping = !damping; }));
    if (damping) entries_.back().other.reset();
    if (!moving_) {
      const bool one = plan_.features.one_poisson_ratio;
      Variant other = as_planned();
      other.plan.features.one_poisson_ratio = false;
      add("second elastic constant per point", !one,
          one ? "all phases in the specimen have the same Poisson's ratio"
              : "Poisson's ratios differ, or cells do not have 2 x 2 points",
          real_, one ? std::optional(other) : std::nullopt);
    }
    Variant each = as_planned();
    each.ledger_each_step = true;
    add("energies at every step", plan_.steps_per_row == 1,
        plan_.steps_per_row == 1 ? "every step is a row of the history"
                                 : "the ledger is computed once per row of the history, every " +
                                       std::to_string(plan_.steps_per_row) + " steps",
        0, plan_.steps_per_row == 1 ? std::nullopt : std::optional(each));
    add("frames for ParaView", scene_.frames > 0,
        scene_.frames > 0 ? "output.frames is " + number(scene_.frames) + "; one at a time is in memory"
                          : "output.frames is 0",
        sizeof(FramePoint), std::nullopt);
    add("extra material points", !scene_.extra_points.empty(),
        scene_.extra_points.empty() ? "the specimen has none"
                                    : "the specimen has " + std::to_string(scene_.extra_points.size()),
        0, std::nullopt);
  }

  void add_motion() {
    const MovingPlan& moving = plan_.moving;
    const bool apic = moving.optional.affine;
    add("velocity gradient of the points (APIC)", apic,
        apic ? "motion.transfer is apic" : "motion.transfer is flip", 4 * real_,
        apic ? std::nullopt : std::optional(changed([](Plan& plan) {
          plan.moving.optional.affine = true;
          plan.moving.features.transfer = moving::Return::apic;
        })));
    const bool blends = moving.features.transfer == moving::Return::blend;
    add("blend with PIC", blends,
        blends ? "motion.flip_ratio is " + number(scene_.motion.flip_ratio)
        : apic ? "motion.transfer is apic"
               : "motion.flip_ratio is 1",
        0,
        moving.features.transfer == moving::Return::flip ? std::optional(changed([](Plan& plan) {
          plan.moving.features.transfer = moving::Return::blend;
        }))
                                                         : std::nullopt);
    add("second transfer of momentum to the nodes", moving.mapped_back,
        moving.mapped_back ? "motion.scheme is musl, or usl with apic" : "motion.scheme maps nothing back", 0,
        std::nullopt);
    const bool deforms = moving.optional.deformation;
    add("deformation gradient", deforms,
        deforms ? "motion.deformation_gradient is on"
                : "motion.deformation_gradient is off; only the volume is updated",
        4 * real_, changed([&](Plan& plan) { plan.moving.optional.deformation = !deforms; }));
    add("sorting of the points", false, "a point moves in memory only when it leaves its tile", 0,
        std::nullopt);
  }

  const Scene& scene_;
  const Plan& plan_;
  bool moving_;
  double real_ = 8, threshold_ = 4;
  std::vector<Entry> entries_;
};

}  // namespace

Explanation explain(const Scene& scene) {
  if (scene.method == SolverMethod::quasi_static)
    throw Error("solver.method", "quasi_static", "has no steps in time to explain",
                "choose solver.method = \"explicit\"");
  const Plan decided = plan(scene);
  Catalogue catalogue(scene, decided);
  const Stopwatch stopwatch(scene);
  Explanation explanation;
  explanation.kinematics = scene.kinematics == Kinematics::moving ? "moving points" : "small strain";
  explanation.bytes = catalogue.bytes();
  explanation.time = stopwatch.compare(catalogue.as_planned(), catalogue.as_planned()).first;
  for (Catalogue::Entry& entry : catalogue.entries()) {
    if (entry.other) {
      const auto times = stopwatch.compare(catalogue.as_planned(), *entry.other);
      entry.feature.time = (entry.feature.in ? -1 : 1) * (times.second - times.first);
    }
    explanation.features.push_back(std::move(entry.feature));
  }
  std::stable_partition(explanation.features.begin(), explanation.features.end(),
                        [](const Feature& feature) { return feature.in; });
  return explanation;
}

}  // namespace mpm
