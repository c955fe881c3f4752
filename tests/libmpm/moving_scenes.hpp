/// Scenes of moving points that several tests share, and sums over their points.
#pragma once

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "libmpm/moving_solver.hpp"
#include "libmpm/scene.hpp"

namespace samples {

/// Whether tests print what they measured: with MESOPIX_FIGURES in the environment.
inline const bool figures = std::getenv("MESOPIX_FIGURES") != nullptr;

/// A method of moving points.
struct Method {
  mpm::Shape shape = mpm::Shape::gimp;
  mpm::Scheme scheme = mpm::Scheme::musl;
  mpm::Transfer transfer = mpm::Transfer::flip;
  double flip_ratio = 1;

  [[nodiscard]] std::string name() const {
    const char* shapes[] = {"linear", "GIMP", "B-spline"};
    const char* schemes[] = {"USF", "USL", "MUSL"};
    const char* back = transfer == mpm::Transfer::apic ? "APIC" : flip_ratio < 1 ? "blend" : "FLIP";
    return std::string(shapes[static_cast<int>(shape)]) + " " + schemes[static_cast<int>(scheme)] + " " +
           back;
  }
  void give_to(mpm::Scene& scene) const {
    scene.motion.shape = shape;
    scene.motion.scheme = scheme;
    scene.motion.transfer = transfer;
    scene.motion.flip_ratio = flip_ratio;
  }
};

inline const std::vector<mpm::Shape>& all_shapes() {
  static const std::vector<mpm::Shape> shapes{mpm::Shape::linear, mpm::Shape::gimp, mpm::Shape::bspline};
  return shapes;
}

/// Every shape with every scheme and FLIP, a blend with PIC, and APIC.
inline std::vector<Method> all_methods(double blend = 0.9) {
  std::vector<Method> methods;
  for (const auto shape : all_shapes())
    for (const auto scheme : {mpm::Scheme::usf, mpm::Scheme::usl, mpm::Scheme::musl}) {
      methods.push_back({shape, scheme, mpm::Transfer::flip, 1});
      methods.push_back({shape, scheme, mpm::Transfer::flip, blend});
      methods.push_back({shape, scheme, mpm::Transfer::apic, 1});
    }
  return methods;
}

inline constexpr std::uint8_t soft = 1;

/// Void round or instead of a soft elastic material in which waves run at 100 m/s (nu = 0) or a little
/// faster, so that bodies can be thrown, turned and squeezed within few steps.
inline mpm::Scene soft_body(int rows, int cols, double pixel_size, double poisson = 0) {
  mpm::Scene scene;
  scene.labels.setConstant(rows, cols, soft);
  scene.pixel_size = pixel_size;
  mpm::Phase phase;
  phase.name = "soft";
  phase.young = 1e7;
  phase.poisson = poisson;
  phase.density = 1000;
  scene.phases = {std::nullopt, phase};
  scene.kinematics = mpm::Kinematics::moving;
  scene.loading.direction = mpm::Direction::none;
  scene.loading.duration = 1e3;
  return scene;
}

/// Leaves only the pixels whose centre lies in the disc; places in pixels from the lower left corner.
inline void keep_disc(mpm::Scene& scene, double x, double y, double radius) {
  for (int row = 0; row < scene.labels.rows(); ++row)
    for (int col = 0; col < scene.labels.cols(); ++col)
      if (std::hypot(col + 0.5 - x, static_cast<double>(scene.labels.rows()) - row - 0.5 - y) > radius)
        scene.labels(row, col) = 0;
}

/// Adds `count` points of a phase at irregular places that do not depend on anything else.
inline void add_irregular_points(mpm::Scene& scene, int count, std::uint8_t phase = soft) {
  // Additive recurrence with the plastic number: covers the plane evenly, without a pattern.
  const double g = 1.32471795724474602596;
  for (int i = 1; i <= count; ++i) {
    const double x = i / g - std::floor(i / g);
    const double y = i / (g * g) - std::floor(i / (g * g));
    scene.extra_points.push_back({x * scene.width(), y * scene.height(), phase});
  }
}

/// A scene with its plan and its solver.
template <class Real = double>
struct Moving {
  mpm::Scene scene;
  mpm::Plan plan;
  mpm::MovingSolver<Real> solver;

  explicit Moving(mpm::Scene what)
      : scene(std::move(what)), plan(mpm::plan(scene)), solver(scene, plan, mpm::start_of(scene, plan)) {}
  Moving(const Moving&) = delete;
  Moving& operator=(const Moving&) = delete;

  /// Place of a pixel's point in the picture before anything moved [m].
  struct Place {
    double x = 0, y = 0;
  };
  [[nodiscard]] Place rest_place(std::uint32_t id) const {
    const auto pixels = static_cast<std::uint32_t>(scene.labels.size());
    if (id >= pixels) return {scene.extra_points[id - pixels].x, scene.extra_points[id - pixels].y};
    const auto cols = static_cast<std::uint32_t>(scene.labels.cols());
    return {(id % cols + 0.5) * scene.pixel_size,
            (static_cast<double>(scene.labels.rows()) - id / cols - 0.5) * scene.pixel_size};
  }
};

/// Sums over all points.
struct Sums {
  double mass = 0, volume = 0;
  double px = 0, py = 0;  ///< momentum [kg/s]
  double spin = 0;        ///< angular momentum about the corner of the picture [kg m/s]
  double kinetic = 0;     ///< [J/m]
};
/// @param variance  of the weights about a point, for the affine part of APIC [m^2].
template <class Real>
Sums sums_of(const mpm::MovingSolver<Real>& solver, double variance = 0) {
  Sums sums;
  for (const mpm::PointView& p : solver.points()) {
    sums.mass += p.mass;
    sums.volume += p.volume;
    sums.px += p.mass * p.vx;
    sums.py += p.mass * p.vy;
    sums.spin += p.mass * (p.x * p.vy - p.y * p.vx + variance * (p.gradient[2] - p.gradient[1]));
    sums.kinetic += 0.5 * p.mass * (p.vx * p.vx + p.vy * p.vy);
  }
  return sums;
}

}  // namespace samples
