#include "libmpm/scene/scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "libmpm/scene/error.hpp"

namespace mpm {
namespace {

bool positive(double value) { return std::isfinite(value) && value > 0; }

void check_picture(Faults& faults, const Scene& scene) {
  const auto rows = scene.labels.rows();
  const auto cols = scene.labels.cols();
  const std::string shape = std::to_string(cols) + " x " + std::to_string(rows) + " pixels";
  const int k = scene.points_per_cell;
  faults.require(rows > 0 && cols > 0, "specimen.labels", shape, "must hold at least one cell");
  faults.require(positive(scene.pixel_size), "specimen.pixel_size", text(scene.pixel_size, "m"),
                 "must be > 0");
  if (scene.pixel_cells) {
    faults.require(k == 1, "solver.cell", "pixel, with " + std::to_string(k) + " points along an edge",
                   "a pixel cell has one point");
    faults.require(scene.kinematics == Kinematics::small_strain, "solver.cell", "pixel",
                   "must be k x k points for points that move", "choose \"2 x 2\"");
  }
  if (faults.require(k >= 1 && k <= 4, "solver.cell", std::to_string(k) + " points along an edge",
                     "must be 1, 2, 3 or 4"))
    faults.require(rows % k == 0 && cols % k == 0, "specimen.labels", shape,
                   "width and height must be whole numbers of cells of " + std::to_string(k) + " x " +
                       std::to_string(k) + " pixels",
                   "crop or resample the picture, or change solver.cell");
}

/// Labels that some pixel or extra point has.
std::array<bool, 256> labels_in_use(const Scene& scene) {
  std::array<bool, 256> used{};
  for (const auto label : scene.labels.reshaped()) used[label] = true;
  for (const auto& point : scene.extra_points) used[point.phase] = true;
  return used;
}

/// The first extra point that lies outside tells enough.
void check_extra_points(Faults& faults, const Scene& scene) {
  const auto inside = [&](const ExtraPoint& point) {
    return point.x >= 0 && point.x <= scene.width() && point.y >= 0 && point.y <= scene.height();
  };
  const auto& points = scene.extra_points;
  const auto first = std::find_if_not(points.begin(), points.end(), inside);
  if (first != points.end())
    faults.require(false, "specimen.extra_points",
                   "(" + text(first->x, "m") + ", " + text(first->y, "m") + ")",
                   "must lie inside the specimen");
}

/// Without closure a crack takes all stiffness from a point, and leaves nothing that could soften in shear.
void check_shear_band(Faults& faults, const Scene& scene, const Phase& phase) {
  if (!phase.softens_in_shear()) return;
  const std::string field = "phases." + phase.name + ".shear_fracture_energy";
  const std::string value = text(phase.shear_fracture_energy, "J/m2");
  faults.require(scene.damage.crack_closure != CrackClosure::off, field, value, "needs damage.crack_closure",
                 "choose damage.crack_closure = \"unilateral\"");
}

void check_phases(Faults& faults, const Scene& scene) {
  check_extra_points(faults, scene);
  const std::array<bool, 256> used = labels_in_use(scene);
  bool any_solid = false;
  for (std::size_t label = 0; label < used.size(); ++label) {
    if (!used[label]) continue;
    if (!faults.require(label < scene.phases.size(), "specimen.labels", std::to_string(label),
                        "every label needs a phase"))
      return;
    if (!scene.phases[label]) continue;
    any_solid = true;
    faults.add(mpm::faults(*scene.phases[label], scene.plane));
    check_shear_band(faults, scene, *scene.phases[label]);
  }
  faults.require(any_solid, "specimen.labels", "all void",
                 "at least one pixel must be of a phase that carries load");
}

void check_platens(Faults& faults, const Loading& loading) {
  faults.require(positive(loading.velocity), "loading.velocity", text(loading.velocity, "m/s"), "must be > 0",
                 "loading.direction sets the direction");
  faults.require(positive(loading.stop_strain) && loading.stop_strain < 1, "loading.stop_strain",
                 text(loading.stop_strain, ""), "must lie in (0, 1)");
  for (const auto& [field, velocity] : {std::pair{"loading.initial_velocity_x", loading.initial_velocity_x},
                                        std::pair{"loading.initial_velocity_y", loading.initial_velocity_y}})
    faults.require(velocity == 0, field, text(velocity, "m/s"), "with platens the specimen starts at rest",
                   "choose loading.direction none");
  faults.require(loading.duration == 0, "loading.duration", text(loading.duration, "s"),
                 "with platens a run ends at loading.stop_strain", "choose loading.direction none");
  faults.require(!loading.separation || loading.direction == Direction::compression, "loading.separation",
                 "true", "platens that pull must hold the specimen", "choose loading.direction compression");
}

void check_flight(Faults& faults, const Loading& loading) {
  faults.require(std::isfinite(loading.initial_velocity_x), "loading.initial_velocity_x",
                 text(loading.initial_velocity_x, "m/s"), "must be finite");
  faults.require(std::isfinite(loading.initial_velocity_y), "loading.initial_velocity_y",
                 text(loading.initial_velocity_y, "m/s"), "must be finite");
  faults.require(positive(loading.duration), "loading.duration", text(loading.duration, "s"), "must be > 0",
                 "without platens it sets the end of the run");
  faults.require(!loading.separation, "loading.separation", "true", "there are no platens to separate from",
                 "choose a wall in motion.bottom or motion.top");
}

void check_loading(Faults& faults, const Loading& loading) {
  faults.require(std::isfinite(loading.ramp_time), "loading.ramp_time", text(loading.ramp_time, "s"),
                 "must be finite");
  if (loading.stop_drop)
    faults.require(*loading.stop_drop > 0 && *loading.stop_drop < 1, "loading.stop_drop",
                   text(*loading.stop_drop, ""), "must lie in (0, 1)");
  if (loading.direction == Direction::none)
    check_flight(faults, loading);
  else
    check_platens(faults, loading);
}

void check_motion(Faults& faults, const Motion& motion) {
  faults.require(motion.flip_ratio >= 0 && motion.flip_ratio <= 1, "motion.flip_ratio",
                 text(motion.flip_ratio, ""), "must lie in [0, 1]");
  faults.require(motion.transfer == Transfer::flip || motion.flip_ratio == 1, "motion.flip_ratio",
                 text(motion.flip_ratio, ""), "has no effect with motion.transfer apic",
                 "choose one of them");
  faults.require(std::isfinite(motion.margin), "motion.margin", text(motion.margin, "m"), "must be finite");
}

void check_handover(Faults& faults, const Handover& handover) {
  faults.require(positive(handover.strain), "handover.strain", text(handover.strain, ""), "must be > 0");
  faults.require(positive(handover.displacement), "handover.displacement", text(handover.displacement, ""),
                 "must be > 0");
}

const char* name_of(Edge edge) {
  switch (edge) {
    case Edge::closed:
      return "closed";
    case Edge::open:
      return "open";
    case Edge::symmetry:
      return "symmetry";
    case Edge::smooth_wall:
      return "smooth_wall";
    case Edge::rough_wall:
      return "rough_wall";
  }
  return "";
}

void check_edge(Faults& faults, const Scene& scene, const char* field, Edge edge, bool is_held_by_platen) {
  if (edge == Edge::closed) return;
  faults.require(!is_held_by_platen, field, name_of(edge), "there is a platen",
                 "choose loading.direction none");
  // While small strain lasts, all that is not between the platens is free.
  faults.require(scene.kinematics == Kinematics::moving ||
                     (edge == Edge::open && scene.kinematics == Kinematics::automatic),
                 field, name_of(edge), "is for moving points", "choose solver.kinematics moving");
}

/// What only moving points heed must not be asked of small strain.
void check_kinematics(Faults& faults, const Scene& scene) {
  const bool flies = scene.loading.direction == Direction::none;
  faults.require(!flies || scene.kinematics == Kinematics::moving, "loading.direction", "none",
                 "free flight needs moving points", "choose solver.kinematics moving");
  faults.require(!scene.loading.separation || scene.kinematics != Kinematics::small_strain,
                 "loading.separation", "true", "is for moving points",
                 "choose solver.kinematics moving or auto");
  check_edge(faults, scene, "motion.left", scene.motion.left, false);
  check_edge(faults, scene, "motion.right", scene.motion.right, false);
  check_edge(faults, scene, "motion.bottom", scene.motion.bottom, !flies);
  check_edge(faults, scene, "motion.top", scene.motion.top, !flies);
}

/// What equilibrium without inertia does not have, or not yet.
void check_quasi_static(Faults& faults, const Scene& scene) {
  faults.require(scene.event_tolerance >= 0 && scene.event_tolerance < 1, "solver.event_tolerance",
                 text(scene.event_tolerance, ""), "must lie in [0, 1)");
  if (scene.method != SolverMethod::quasi_static) return;
  const char* cure = "choose solver.method = \"explicit\"";
  faults.require(scene.kinematics == Kinematics::small_strain, "solver.method", "quasi_static",
                 "needs solver.kinematics = \"small_strain\"", cure);
  faults.require(scene.loading.direction != Direction::none, "solver.method", "quasi_static",
                 "needs platens, as with loading.direction = \"tension\"", cure);
  // An open crack takes the stress from what is pressed along it, the more the wider it opens, and resists
  // no opening itself: many states are in equilibrium.
  faults.require(scene.damage.crack_closure != CrackClosure::clipped, "damage.crack_closure", "clipped",
                 "leaves it to the motion how far a crack opens, so that equilibrium has no single answer",
                 "choose damage.crack_closure = \"unilateral\", or solver.method = \"explicit\"");
}

void check_solver(Faults& faults, const Scene& scene) {
  faults.require(scene.cfl > 0 && scene.cfl <= 1, "solver.cfl", text(scene.cfl, ""), "must lie in (0, 1]");
  faults.require(scene.local_damping >= 0 && scene.local_damping < 1, "solver.local_damping",
                 text(scene.local_damping, ""), "must lie in [0, 1)");
  faults.require(scene.damage.residual_stiffness >= 0 && scene.damage.residual_stiffness < 1,
                 "damage.residual_stiffness", text(scene.damage.residual_stiffness, ""),
                 "must lie in [0, 1)");
  faults.require(std::isfinite(scene.damage.correlation_length) && scene.damage.correlation_length >= 0,
                 "damage.correlation_length", text(scene.damage.correlation_length, "m"),
                 "must be > 0, or 0 for independent points");
  // The places of the random field are numbered by 31 bits.
  faults.require(scene.damage.correlation_length == 0 ||
                     std::max(scene.width(), scene.height()) / scene.damage.correlation_length < 1e9,
                 "damage.correlation_length", text(scene.damage.correlation_length, "m"),
                 "must be more than a billionth of the specimen", "omit it for independent points");
  faults.require(scene.threads >= 0 && scene.threads <= 1024, "solver.threads", std::to_string(scene.threads),
                 "must lie in [1, 1024], or 0 for a number chosen automatically");
  faults.require(scene.history_rows >= 10, "output.history_rows", std::to_string(scene.history_rows),
                 "must be >= 10");
  faults.require(scene.frames >= 0, "output.frames", std::to_string(scene.frames), "must be >= 0");
}

/// Before a platen that outruns the wave it sends, the specimen would be strained by more than its own size.
void check_velocity(Faults& faults, const Scene& scene) {
  if (scene.method == SolverMethod::quasi_static || scene.loading.direction == Direction::none) return;
  const std::array<bool, 256> used = labels_in_use(scene);
  const Phase* slowest = nullptr;
  const auto speed = [&](const Phase& phase) {
    return std::sqrt(bar_modulus(phase, scene.plane) / phase.density);
  };
  for (std::size_t label = 0; label < scene.phases.size(); ++label) {
    const auto& phase = scene.phases[label];
    if (used[label] && phase && (slowest == nullptr || speed(*phase) < speed(*slowest))) slowest = &*phase;
  }
  if (slowest == nullptr) return;
  faults.require(scene.loading.velocity < speed(*slowest), "loading.velocity",
                 text(scene.loading.velocity, "m/s"),
                 "must be below " + text(speed(*slowest), "m/s") + ", the speed of a wave in " +
                     slowest->name + ", which no platen outruns",
                 "load more slowly");
}

/// What no specimen is needed for.
void check_settings(Faults& faults, const Scene& scene) {
  check_loading(faults, scene.loading);
  check_motion(faults, scene.motion);
  check_handover(faults, scene.handover);
  check_kinematics(faults, scene);
  check_solver(faults, scene);
  check_quasi_static(faults, scene);
  faults.add(fixture_faults(scene));
}

}  // namespace

std::vector<Error> faults(const Scene& scene) {
  Faults faults;
  check_picture(faults, scene);
  check_phases(faults, scene);
  check_settings(faults, scene);
  if (faults.none()) check_velocity(faults, scene);
  return std::move(faults).found();
}

std::vector<Error> faults_beside_specimen(const Scene& scene) {
  Faults faults;
  check_settings(faults, scene);
  return std::move(faults).found();
}

void validate(const Scene& scene) { refuse_first(faults(scene)); }

std::int64_t count_points(const Scene& scene) {
  const auto solid = [&](std::uint8_t label) { return scene.phases[label].has_value(); };
  std::int64_t points = 0;
  for (const auto label : scene.labels.reshaped()) points += solid(label) ? 1 : 0;
  for (const auto& point : scene.extra_points) points += solid(point.phase) ? 1 : 0;
  return points;
}

}  // namespace mpm
