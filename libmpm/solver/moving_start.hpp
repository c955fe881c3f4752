/// What moving points start from: the specimen at rest or in flight, or a run that small strain has begun.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "libmpm/material/failure.hpp"
#include "libmpm/material/strength.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/solver/failure_maps.hpp"
#include "libmpm/solver/plan.hpp"

namespace mpm {

/// A material point as it comes to the solver of moving points.
struct StartPoint {
  std::uint32_t id = 0;   ///< row * columns + column of its pixel; those of extra points follow
  double x = 0, y = 0;    ///< in the picture [m]
  double vx = 0, vy = 0;  ///< [m/s]
  double mass = 0;        ///< [kg/m]
  double volume = 0;      ///< [m^2]
  Stress<double> stress;  ///< of the intact material, or with its residual stiffness [Pa]
  double kept = 1;        ///< share of its stiffness that it still has [-]
  double cracked = 0;     ///< share of its resistance to tension that it has lost (crack closure) [-]
  double strength = -1;   ///< largest principal stress that it still carries [Pa]; < 0 = its first strength
  bool ghost = false;     ///< nothing can happen to it any more

  void take(const PointState& state);
};

struct MovingStart {
  std::vector<StartPoint> points;
  bool as_pictured = false;  ///< the points are those of for_each_start_point(); `points` is empty
  std::int64_t step = 0;
  double time = 0;                 ///< [s]
  double platen_displacement = 0;  ///< of the top platen, upwards positive [m]
  double platen_velocity = 0;      ///< in the step before, upwards positive [m/s]
  Tally tally;
  FailureMaps maps;
};

/// Visit the points of the specimen as the picture shows it, without stress, at its initial velocity.
void for_each_start_point(const Scene& scene, const std::function<void(const StartPoint&)>& visit);
/// The same as a start, with its points in a list.
[[nodiscard]] MovingStart start_of(const Scene& scene, const Plan& plan);
/// The same without a list, which would take as much memory as the solver itself.
[[nodiscard]] MovingStart pictured_start(const Scene& scene, const Plan& plan);

/// A point by its id: what the scene says of it.
struct PointOrigin {
  const Phase* phase = nullptr;
  std::uint8_t label = 0;
  int row = -1, col = -1;  ///< of its pixel; -1 for extra points
  std::size_t extra = 0;   ///< index in Scene::extra_points, when row < 0
};
[[nodiscard]] PointOrigin origin_of(const Scene& scene, std::uint32_t id);
/// "the point of pixel (row 3, column 4), mortar".
[[nodiscard]] std::string name_of_point(const Scene& scene, std::uint32_t id);
/// Factor on its strength [-].
[[nodiscard]] double factor_of(const StrengthFactors& factors, const PointOrigin& origin);

}  // namespace mpm
