#include "apps/bench/stability_motion.hpp"

#include <cmath>

#include "apps/bench/stability_scenes.hpp"

namespace app::bench {

mpm::Scene sky(int rows, int cols) {
  mpm::Scene scene = block(rows, cols, elastic(1e7, 0, 1000));
  scene.labels.setConstant(0);
  scene.pixel_size = 0.05;
  scene.kinematics = mpm::Kinematics::moving;
  scene.loading = {};
  scene.loading.direction = mpm::Direction::none;
  scene.loading.duration = 1e6;
  return scene;
}

void add_disc(mpm::Scene& scene, double x, double y, double radius) {
  for (int row = 0; row < scene.labels.rows(); ++row)
    for (int col = 0; col < scene.labels.cols(); ++col)
      if (std::hypot(col + 0.5 - x, static_cast<double>(scene.labels.rows()) - row - 0.5 - y) <= radius)
        scene.labels(row, col) = first;
}

Sums sums_of(const std::vector<mpm::PointView>& points) {
  Sums sums;
  for (const mpm::PointView& p : points) {
    sums.mass += p.mass;
    sums.px += p.mass * p.vx;
    sums.py += p.mass * p.vy;
    sums.x += p.mass * p.x;
    sums.y += p.mass * p.y;
    sums.kinetic += 0.5 * p.mass * (p.vx * p.vx + p.vy * p.vy);
  }
  sums.x /= sums.mass;
  sums.y /= sums.mass;
  for (const mpm::PointView& p : points)
    sums.spin += p.mass * ((p.x - sums.x) * p.vy - (p.y - sums.y) * p.vx);
  return sums;
}

}  // namespace app::bench
