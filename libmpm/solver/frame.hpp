/// The points of a run as they are at one time, for those who look on.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "libmpm/scene/scene.hpp"

namespace mpm {

/// A material point. Plain axes: x to the right and y upwards, from the lower left corner of the picture.
struct FramePoint {
  std::uint32_t id = 0;    ///< row * columns + column of its pixel; those of extra points follow
  std::uint8_t phase = 0;  ///< label
  double x = 0, y = 0;     ///< [m]
  double ux = 0, uy = 0;   ///< displacement since the start [m]
  double vx = 0, vy = 0;   ///< [m/s]; with small strain that of half a step later
  /// That the point carries [Pa]; zz is the one out of the plane, 0 in plane stress.
  double sxx = 0, syy = 0, szz = 0, sxy = 0;
  double damage = 0;  ///< 0 = intact, 1 = failed; between them while a crack softens [-]

  friend bool operator==(const FramePoint&, const FramePoint&) = default;
};

struct Frame {
  std::int64_t step = 0;  ///< steps that led here
  double time = 0;        ///< [s]
  double strain = 0;      ///< platen displacement over height; without platens nominal, as in the history [-]
  std::int64_t row =
      0;  ///< of Result::history that was written last; with moving points it is of a step before
  std::vector<FramePoint> points;  ///< by rising id; those that left through open edges are missing

  friend bool operator==(const Frame&, const Frame&) = default;
};

/// Is lent each frame as the run comes to it; the next one takes its place.
using FrameSink = std::function<void(const Frame&)>;

/// What a solver knows of a point beside its motion.
struct FrameState {
  double sxx = 0, syy = 0, sxy = 0;  ///< that the point carries [Pa]
  double kept = 1;                   ///< share of its stiffness that it still has [-]
  double cracked = 0;                ///< share of its resistance to tension that it has lost [-]
};

/// Adds to a point that knows its id, place and velocity what follows from them, from its state and the
/// scene.
[[nodiscard]] FramePoint completed(FramePoint point, const FrameState& state, const Scene& scene);

}  // namespace mpm
