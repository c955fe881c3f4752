#include "libmpm/scene.hpp"

#include <array>
#include <cmath>
#include <string>

#include "libmpm/error.hpp"
#include "libmpm/require.hpp"

namespace mpm {
namespace {

bool positive(double value) { return std::isfinite(value) && value > 0; }

void validate_picture(const Scene& scene) {
  const auto rows = scene.labels.rows();
  const auto cols = scene.labels.cols();
  const std::string shape = std::to_string(cols) + " x " + std::to_string(rows) + " pixels";
  const int k = scene.points_per_cell;
  require(rows > 0 && cols > 0, "specimen.labels", shape, "must hold at least one cell");
  require(positive(scene.pixel_size), "specimen.pixel_size", text(scene.pixel_size, "m"), "must be > 0");
  require(k >= 1 && k <= 4, "solver.points_per_cell", std::to_string(k), "must be 1, 2, 3 or 4");
  if (rows % k != 0 || cols % k != 0)
    throw Error("specimen.labels", shape,
                "width and height must be whole numbers of cells of " + std::to_string(k) + " x " +
                    std::to_string(k) + " pixels",
                "crop or resample the picture, or change solver.points_per_cell");
}

void validate_phases(const Scene& scene) {
  std::array<bool, 256> used{};
  for (const auto label : scene.labels.reshaped()) used[label] = true;
  for (const auto& point : scene.extra_points) {
    used[point.phase] = true;
    require(point.x >= 0 && point.x <= scene.width() && point.y >= 0 && point.y <= scene.height(),
            "specimen.extra_points", "(" + text(point.x, "m") + ", " + text(point.y, "m") + ")",
            "must lie inside the specimen");
  }
  bool any_solid = false;
  for (std::size_t label = 0; label < used.size(); ++label) {
    if (!used[label]) continue;
    require(label < scene.phases.size(), "specimen.labels", std::to_string(label),
            "every label needs a phase");
    if (!scene.phases[label]) continue;
    any_solid = true;
    validate(*scene.phases[label], scene.plane);
  }
  require(any_solid, "specimen.labels", "all void",
          "at least one pixel must be of a phase that carries load");
}

void validate_loading(const Loading& loading) {
  require(positive(loading.velocity), "loading.velocity", text(loading.velocity, "m/s"), "must be > 0",
          "the direction is told by loading.direction");
  require(std::isfinite(loading.ramp_time), "loading.ramp_time", text(loading.ramp_time, "s"),
          "must be finite");
  require(positive(loading.stop_strain) && loading.stop_strain < 1, "loading.stop_strain",
          text(loading.stop_strain, ""), "must lie in (0, 1)");
  if (loading.stop_drop)
    require(*loading.stop_drop > 0 && *loading.stop_drop < 1, "loading.stop_drop",
            text(*loading.stop_drop, ""), "must lie in (0, 1)");
}

void validate_solver(const Scene& scene) {
  require(scene.cfl > 0 && scene.cfl <= 1, "solver.cfl", text(scene.cfl, ""), "must lie in (0, 1]");
  require(scene.local_damping >= 0 && scene.local_damping < 1, "solver.local_damping",
          text(scene.local_damping, ""), "must lie in [0, 1)");
  require(scene.damage.residual_stiffness >= 0 && scene.damage.residual_stiffness < 1,
          "damage.residual_stiffness", text(scene.damage.residual_stiffness, ""), "must lie in [0, 1)");
  require(scene.threads >= 1 && scene.threads <= 1024, "solver.threads", std::to_string(scene.threads),
          "must lie in 1 ... 1024");
  require(scene.history_rows >= 10, "output.history_rows", std::to_string(scene.history_rows),
          "must be >= 10");
}

}  // namespace

void validate(const Scene& scene) {
  validate_picture(scene);
  validate_phases(scene);
  validate_loading(scene.loading);
  validate_solver(scene);
}

}  // namespace mpm
