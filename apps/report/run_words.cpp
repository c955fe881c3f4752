#include "apps/report/run_words.hpp"

#include <fmt/format.h>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "apps/text/figures.hpp"
#include "apps/text/words.hpp"

namespace output {

std::string word_of(mpm::Direction direction) {
  using enum mpm::Direction;
  return app::word_in({{tension, "tension"}, {compression, "compression"}, {none, "none"}}, direction);
}

std::string word_of(mpm::Platen platen) { return platen == mpm::Platen::smooth ? "smooth" : "rough"; }

std::string word_of(mpm::Plane plane) {
  return plane == mpm::Plane::strain ? "plane strain" : "plane stress";
}

std::string word_of(mpm::Precision precision) {
  return precision == mpm::Precision::single ? "single" : "double";
}

std::string word_of(mpm::CrackClosure law) {
  using enum mpm::CrackClosure;
  return app::word_in({{off, "off"}, {clipped, "clipped"}, {unilateral, "unilateral"}}, law);
}

std::string word_of(mpm::Kinematics kinematics) {
  using enum mpm::Kinematics;
  return app::word_in({{small_strain, "small_strain"}, {moving, "moving"}, {automatic, "auto"}}, kinematics);
}

std::string word_of(mpm::SolverMethod method) {
  return method == mpm::SolverMethod::quasi_static ? "quasi_static" : "explicit";
}

std::string word_of(mpm::LoadingPath path) {
  return path == mpm::LoadingPath::snap_back ? "snap_back" : "strain";
}

std::string word_of(mpm::StopReason reason) {
  using enum mpm::StopReason;
  return app::word_in({{strain, "strain"}, {time, "time"}, {drop, "drop"}, {interrupted, "interrupted"}},
                      reason);
}

std::string phrase_of(mpm::StopReason reason) {
  using enum mpm::StopReason;
  return app::word_in({{strain, "the final strain was reached"},
                       {time, "its duration was over"},
                       {drop, "the stress had dropped"},
                       {interrupted, "it was interrupted"}},
                      reason);
}

namespace {

bool is_wall(mpm::Edge edge) { return edge == mpm::Edge::smooth_wall || edge == mpm::Edge::rough_wall; }

/// "smooth wall at the bottom", for each wall of a flight.
std::vector<std::string> walls(const mpm::Motion& motion) {
  const std::array<std::pair<mpm::Edge, const char*>, 4> edges{{{motion.bottom, "at the bottom"},
                                                                {motion.top, "at the top"},
                                                                {motion.left, "at the left"},
                                                                {motion.right, "at the right"}}};
  std::vector<std::string> found;
  for (const auto& [edge, place] : edges)
    if (is_wall(edge))
      found.push_back(fmt::format("{} wall {}", edge == mpm::Edge::smooth_wall ? "smooth" : "rough", place));
  return found;
}

std::string transfer_name(const mpm::Motion& motion) {
  if (motion.transfer == mpm::Transfer::apic) return "APIC";
  if (motion.flip_ratio == 1) return "FLIP";
  return motion.flip_ratio == 0 ? "PIC" : fmt::format("{} FLIP", percent(motion.flip_ratio));
}

}  // namespace

bool has_platens(const mpm::Scene& scene) { return scene.loading.direction != mpm::Direction::none; }

std::string name_of_loading(const mpm::Scene& scene) {
  if (scene.fixture.has_loads()) return "a test with loads";
  if (has_platens(scene)) return word_of(scene.loading.direction);
  return walls(scene.motion).empty() ? "flight" : "impact";
}

namespace {

/// "3 supports, 1 load, 2 gauges".
std::string fixture_words(const mpm::Fixture& fixture) {
  const auto count = [](std::size_t number, const char* what) {
    return app::counted(static_cast<std::int64_t>(number), what);
  };
  std::string words = "test with " + count(fixture.supports.size(), "support") + " and " +
                      count(fixture.loads.size(), "load");
  if (const mpm::Gauge* gauge = fixture.controlling()) words += " controlled by " + gauge->name;
  return words;
}

}  // namespace

std::string setting_of_loading(const mpm::Scene& scene) {
  const mpm::Loading& loading = scene.loading;
  if (scene.method == mpm::SolverMethod::quasi_static)
    return fmt::format("quasi-static {}{}",
                       scene.fixture.has_loads()
                           ? fixture_words(scene.fixture)
                           : name_of_loading(scene) + ", " + word_of(loading.platen) + " platens",
                       loading.path == mpm::LoadingPath::snap_back ? " that may go back" : "");
  if (has_platens(scene))
    return fmt::format("{} at {} m/s, {} platens{}", name_of_loading(scene), concise(loading.velocity),
                       word_of(loading.platen), loading.separation ? " with separation" : "");
  std::string text = fmt::format("{} at {} m/s", name_of_loading(scene),
                                 concise(std::hypot(loading.initial_velocity_x, loading.initial_velocity_y)));
  for (const std::string& wall : walls(scene.motion)) text += ", " + wall;
  return text;
}

std::string name_of_strain(const mpm::Scene& scene) {
  if (scene.fixture.has_loads()) return "displacement over height";
  return has_platens(scene) ? "platen strain" : "nominal strain";
}

std::string name_of_stress(const mpm::Scene& scene) {
  if (scene.fixture.has_loads()) return "force over width";
  return has_platens(scene) ? "stress" : "stress on the walls";
}

std::string meaning_of_curve(const mpm::Scene& scene) {
  if (scene.fixture.has_loads())
    return "Force is that of the leading load, for a specimen as thick as loading.thickness. Strains under "
           "the "
           "film and the pictures are the displacement of this load over the height.";
  if (has_platens(scene))
    return "Stress is the mean of the reactions of both platens over the width; strain is the displacement "
           "of the platens over the height. The secant modulus is taken where the stress first reaches 40 % "
           "of its peak.";
  return "There are no platens, so stress and strain are nominal. Stress is the reaction of the lower edge, "
         "and of the upper one if it is a wall, over the width. Strain is the distance of a free flight over "
         "the "
         "height.";
}

std::string meaning_of_energy(const mpm::Scene& scene) {
  const bool moves = scene.method == mpm::SolverMethod::explicit_;
  std::vector<std::string> parts{"elastic energy"};
  if (moves) parts.emplace_back("kinetic energy");
  parts.emplace_back("energy released by failing points");
  if (moves && scene.local_damping > 0) parts.emplace_back("damped energy");
  std::string text = fmt::format("The energy ledger, per metre of thickness: {} is the sum of {}.",
                                 has_platens(scene) ? "the work of the platens" : "the initial energy",
                                 app::listed(parts, "and"));
  if (scene.kinematics != mpm::Kinematics::small_strain)
    text += " Any difference is numerical dissipation of the moving points.";
  return text;
}

namespace {

/// Where the run ended, which the stress would have to go beyond.
std::string end_of_run(const mpm::Result& result, const mpm::Scene& scene) {
  if (result.stop != mpm::StopReason::strain || !has_platens(scene)) return "when the run ended";
  return "at stop_strain, " + app::strain_text(result.history.back().strain);
}

std::string how_it_ended(const mpm::Result& result, const mpm::Scene& scene) {
  const std::string end = end_of_run(result, scene);
  if (!(result.peak_stress > 0)) return "the stress never rose above 0";
  const double fall = mpm::fall_after_peak(result);
  const std::string largest = rounded(1e-6 * result.peak_stress, 4) + " MPa";
  if (fall > 0)
    return fmt::format("the stress had fallen by no more than {} from its largest value, {}, {}",
                       percent(fall, 1), largest, end);
  return fmt::format("the stress was still rising {}, to {}", end, largest);
}

}  // namespace

std::string no_peak_text(const mpm::Result& result, const mpm::Scene& scene) {
  if (result.history.empty() || mpm::peak_reached(result)) return {};
  if (!has_platens(scene) && walls(scene.motion).empty()) return {};
  const char* cure = has_platens(scene) ? "a larger loading.stop_strain" : "a longer loading.duration";
  return fmt::format("no peak was reached: {}; choose {}", how_it_ended(result, scene), cure);
}

std::string name_of_kinematics(const mpm::Scene& scene) {
  if (scene.method == mpm::SolverMethod::quasi_static) return "small strain, in equilibrium";
  if (scene.kinematics == mpm::Kinematics::small_strain) return "small strain";
  const char* shape = scene.motion.shape == mpm::Shape::linear ? "linear"
                      : scene.motion.shape == mpm::Shape::gimp ? "GIMP"
                                                               : "B-spline";
  const char* scheme = scene.motion.scheme == mpm::Scheme::usf   ? "USF"
                       : scene.motion.scheme == mpm::Scheme::usl ? "USL"
                                                                 : "MUSL";
  return fmt::format("{}moving points ({}, {}, {})",
                     scene.kinematics == mpm::Kinematics::automatic ? "small strain, then " : "", shape,
                     scheme, transfer_name(scene.motion));
}

}  // namespace output
