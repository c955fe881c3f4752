/// Which features a run uses, which it does without, and how much this saves.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libmpm/scene/scene.hpp"

namespace mpm {

/// An optional part of the model or of the output.
struct Feature {
  std::string name;  ///< e.g. "shear test"
  bool in = false;   ///< the run uses it
  std::string why;   ///< reason, half a sentence
  double bytes = 0;  ///< memory per point [byte]
  /// Time per point and step [s], measured now on this scene and machine: the run with the feature minus the
  /// run without, each the fastest of several repetitions. Empty if the feature cannot be switched without
  /// changing the physics.
  std::optional<double> time;
};

/// Features and cost of a run.
struct Explanation {
  std::string kinematics;         ///< of the measured solver: "small strain" or "moving points"
  std::vector<Feature> features;  ///< used features first
  double bytes = 0;               ///< memory per point [byte]
  double time = 0;                ///< per point and step [s]
};

/// Time the first steps of a scene with and without each feature; takes about a second.
/// @throws Error for an invalid scene.
[[nodiscard]] Explanation explain(const Scene& scene);

}  // namespace mpm
