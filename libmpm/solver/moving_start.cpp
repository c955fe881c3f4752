#include "libmpm/solver/moving_start.hpp"

#include <utility>

#include "libmpm/solver/grid.hpp"

namespace mpm {

void StartPoint::take(const PointState& state) {
  kept = state.kept;
  cracked = state.cracked;
  strength = state.strength;
  ghost = state.spent && state.kept < 1;
}

void for_each_start_point(const Scene& scene, const std::function<void(const StartPoint&)>& visit) {
  const auto count = points_per_pixel(scene);
  const double area = scene.pixel_size * scene.pixel_size;
  const bool flies = scene.loading.direction == Direction::none;
  StartPoint point;
  if (flies) {
    point.vx = scene.loading.initial_velocity_x;
    point.vy = scene.loading.initial_velocity_y;
  }
  const auto add = [&](double x, double y, const Phase& phase, double share) {
    point.x = x;
    point.y = y;
    point.volume = area * share;
    point.mass = phase.density * point.volume;
    visit(point);
  };
  const auto rows = scene.labels.rows();
  const auto cols = scene.labels.cols();
  for (Eigen::Index row = 0; row < rows; ++row) {
    for (Eigen::Index col = 0; col < cols; ++col) {
      const auto& phase = scene.phases[scene.labels(row, col)];
      if (!phase) continue;
      point.id = static_cast<std::uint32_t>(row * cols + col);
      add((static_cast<double>(col) + 0.5) * scene.pixel_size,
          (static_cast<double>(rows - row) - 0.5) * scene.pixel_size, *phase, 1.0 / count(row, col));
    }
  }
  for (std::size_t i = 0; i < scene.extra_points.size(); ++i) {
    const ExtraPoint& extra = scene.extra_points[i];
    if (!scene.phases[extra.phase]) continue;
    const Pixel pixel = pixel_at(scene, extra.x, extra.y);
    point.id = static_cast<std::uint32_t>(static_cast<std::size_t>(rows * cols) + i);
    add(extra.x, extra.y, *scene.phases[extra.phase], 1.0 / count(pixel.row, pixel.col));
  }
}

MovingStart start_of(const Scene& scene, const Plan& plan) {
  MovingStart start;
  start.maps = empty_maps(scene, plan);
  start.points.reserve(static_cast<std::size_t>(scene.labels.size()) + scene.extra_points.size());
  for_each_start_point(scene, [&](const StartPoint& point) { start.points.push_back(point); });
  return start;
}

MovingStart pictured_start(const Scene& scene, const Plan& plan) {
  MovingStart start;
  start.maps = empty_maps(scene, plan);
  start.as_pictured = true;
  return start;
}

PointOrigin origin_of(const Scene& scene, std::uint32_t id) {
  PointOrigin origin;
  const auto pixels = static_cast<std::size_t>(scene.labels.size());
  if (id < pixels) {
    origin.row = static_cast<int>(id / scene.labels.cols());
    origin.col = static_cast<int>(id % scene.labels.cols());
    origin.label = scene.labels(origin.row, origin.col);
  } else {
    origin.extra = id - pixels;
    origin.label = scene.extra_points[origin.extra].phase;
  }
  origin.phase = &*scene.phases[origin.label];
  return origin;
}

std::string name_of_point(const Scene& scene, std::uint32_t id) {
  const PointOrigin origin = origin_of(scene, id);
  const std::string place = origin.row < 0 ? "extra point " + std::to_string(origin.extra)
                                           : "the point of pixel (row " + std::to_string(origin.row) +
                                                 ", column " + std::to_string(origin.col) + ")";
  return origin.phase->name.empty() ? place : place + ", " + origin.phase->name;
}

double factor_of(const StrengthFactors& factors, const PointOrigin& origin) {
  return origin.row < 0 ? factors.of_extra_point(origin.extra) : factors.of_pixel(origin.row, origin.col);
}

}  // namespace mpm
