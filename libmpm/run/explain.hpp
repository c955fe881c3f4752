/// What a run computes, what it leaves out, and what that saves.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libmpm/scene/scene.hpp"

namespace mpm {

/// A part of the model, or of the bookkeeping, that a run may go without.
struct Feature {
  std::string name;  ///< e.g. "shear test"
  bool in = false;   ///< this run has it
  std::string why;   ///< half a sentence
  double bytes = 0;  ///< memory that it takes a point [byte]
  /// Time that it takes a point and step, measured on this scene, on this machine, just now [s]: that of the
  /// run with the feature less that of the run without, each the fastest of several stretches. Empty where
  /// the one cannot be had without changing the physics of the other.
  std::optional<double> time;
};

struct Explanation {
  std::string kinematics;         ///< of the solver that was measured: "small strain" or "moving points"
  std::vector<Feature> features;  ///< those that are in first
  double bytes = 0;               ///< memory of a point [byte]
  double time = 0;                ///< of a point and step [s]
};

/// Plan the scene, and time its first steps with and without each feature; takes a second or so.
/// @throws Error for a scene that is not valid.
[[nodiscard]] Explanation explain(const Scene& scene);

}  // namespace mpm
