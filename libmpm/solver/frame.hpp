/// Frames: the state of all points at one time.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "libmpm/scene/scene.hpp"

namespace mpm {

/// A material point. x points to the right and y upwards, from the lower left corner of the specimen.
struct FramePoint {
  std::uint32_t id = 0;    ///< row * columns + column of its pixel; those of extra points follow
  std::uint8_t phase = 0;  ///< label
  double x = 0, y = 0;     ///< position [m]
  double ux = 0, uy = 0;   ///< displacement since the start [m]
  double vx = 0, vy = 0;   ///< velocity [m/s]; with small strain, half a step later
  /// Stress that the point carries [Pa]; zz is out of the plane, 0 in plane stress.
  double sxx = 0, syy = 0, szz = 0, sxy = 0;
  double damage = 0;  ///< 0 = intact, 1 = failed, in between while a crack softens [-]

  friend bool operator==(const FramePoint&, const FramePoint&) = default;
};

/// The state of all points at one time.
struct Frame {
  std::int64_t step = 0;  ///< steps so far
  double time = 0;        ///< of the points [s]
  double strain = 0;      ///< platen displacement over height; nominal without platens, as in the history [-]
  std::int64_t row = 0;   ///< last row of Result::history; with moving points it is one step older
  std::vector<FramePoint> points;  ///< by increasing id; points that left through open edges are missing
  std::string run = {};            ///< of a frame that was read: by which its writer knew the run

  friend bool operator==(const Frame&, const Frame&) = default;
};

/// Called with each frame, which is valid during the call.
using FrameSink = std::function<void(const Frame&)>;

/// State of a point besides its motion.
struct FrameState {
  double sxx = 0, syy = 0, sxy = 0;  ///< stress that the point carries [Pa]
  double kept = 1;                   ///< share of its stiffness that remains [-]
  double cracked = 0;                ///< share of its tensile strength that is lost [-]
};

/// Completes a point that has id, position and velocity with its phase, displacement, stress and damage.
[[nodiscard]] FramePoint completed(FramePoint point, const FrameState& state, const Scene& scene);

}  // namespace mpm
