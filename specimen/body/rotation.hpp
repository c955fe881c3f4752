/// Sine and cosine of an angle, the same bits on every machine.
#pragma once

namespace specimen {

/// The unit vector at an angle against x: (cos, sin).
struct Rotation {
  double cos = 1;
  double sin = 0;
};

/// Rotation by an angle [rad], to about one unit in the last place within a turn or two.
/// The mathematical library picks its sine by processor, so two machines may differ in the last bit, and a
/// packing that is relaxed over hundreds of sweeps magnifies that bit into another specimen. Only +, -, *
/// and exact functions are used here.
[[nodiscard]] Rotation rotation_by(double angle);

}  // namespace specimen
