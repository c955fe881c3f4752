#include "libmpm/problems/method.hpp"

#include <cmath>

namespace mpm::problems {

std::string Method::name() const {
  const char* shapes[] = {"linear", "GIMP", "B-spline"};
  const char* schemes[] = {"USF", "USL", "MUSL"};
  const char* back = transfer == Transfer::apic ? "APIC"
                     : flip_ratio <= 0          ? "PIC"
                     : flip_ratio < 1           ? "blend"
                                                : "FLIP";
  return std::string(shapes[static_cast<int>(shape)]) + " " + schemes[static_cast<int>(scheme)] + " " + back +
         (precision == Precision::single ? " single" : "");
}

void Method::give_to(Scene& scene) const {
  scene.motion.shape = shape;
  scene.motion.scheme = scheme;
  scene.motion.transfer = transfer;
  scene.motion.flip_ratio = flip_ratio;
  scene.precision = precision;
}

const std::vector<Shape>& all_shapes() {
  static const std::vector<Shape> shapes{Shape::linear, Shape::gimp, Shape::bspline};
  return shapes;
}

std::vector<Method> all_methods(double blend) {
  std::vector<Method> methods;
  for (const auto shape : all_shapes())
    for (const auto scheme : {Scheme::usf, Scheme::usl, Scheme::musl}) {
      methods.push_back({shape, scheme, Transfer::flip, 1});
      methods.push_back({shape, scheme, Transfer::flip, blend});
      methods.push_back({shape, scheme, Transfer::apic, 1});
    }
  return methods;
}

Scene soft_body(int rows, int cols, double pixel_size, double poisson) {
  Scene scene;
  scene.labels.setConstant(rows, cols, soft);
  scene.pixel_size = pixel_size;
  Phase phase;
  phase.name = "soft";
  phase.young = 1e7;
  phase.poisson = poisson;
  phase.density = 1000;
  scene.phases = {std::nullopt, phase};
  scene.kinematics = Kinematics::moving;
  scene.loading.direction = Direction::none;
  scene.loading.duration = 1e3;
  return scene;
}

void keep_disc(Scene& scene, double x, double y, double radius) {
  for (int row = 0; row < scene.labels.rows(); ++row)
    for (int col = 0; col < scene.labels.cols(); ++col)
      if (std::hypot(col + 0.5 - x, static_cast<double>(scene.labels.rows()) - row - 0.5 - y) > radius)
        scene.labels(row, col) = 0;
}

void add_irregular_points(Scene& scene, int count, std::uint8_t phase) {
  // Additive recurrence with the plastic number: covers the plane evenly, without a pattern.
  const double g = 1.32471795724474602596;
  for (int i = 1; i <= count; ++i) {
    const double x = i / g - std::floor(i / g);
    const double y = i / (g * g) - std::floor(i / (g * g));
    scene.extra_points.push_back({x * scene.width(), y * scene.height(), phase});
  }
}

Place rest_place(const Scene& scene, std::uint32_t id) {
  const auto pixels = static_cast<std::uint32_t>(scene.labels.size());
  if (id >= pixels) return {scene.extra_points[id - pixels].x, scene.extra_points[id - pixels].y};
  const auto cols = static_cast<std::uint32_t>(scene.labels.cols());
  const std::uint32_t row = id / cols;
  return {(id % cols + 0.5) * scene.pixel_size,
          (static_cast<double>(scene.labels.rows()) - row - 0.5) * scene.pixel_size};
}

Sums sums_of(const std::vector<PointView>& points) {
  Sums sums;
  for (const PointView& p : points) {
    sums.mass += p.mass;
    sums.volume += p.volume;
    sums.px += p.mass * p.vx;
    sums.py += p.mass * p.vy;
    sums.spin += p.mass * (p.x * p.vy - p.y * p.vx);
    sums.kinetic += 0.5 * p.mass * (p.vx * p.vx + p.vy * p.vy);
  }
  return sums;
}

}  // namespace mpm::problems
