/// Checkpoints: the state of a run after a row of its history, from which resume() continues with the same
/// bits; and the SHA-256 digests that identify a specimen and detect damaged files.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "libmpm/scene/scene.hpp"

namespace mpm {

inline constexpr std::size_t sha256_bytes = 32;

/// A digest in progress.
class Sha256 {
 public:
  Sha256();
  Sha256& add(std::string_view bytes);
  /// The digest, 32 bytes. Call it once, after the last add().
  [[nodiscard]] std::string digest();

 private:
  struct Context;
  struct Free {
    void operator()(Context* context) const;
  };
  std::unique_ptr<Context, Free> context_;
};

/// A frame that the run has passed to its sink.
struct FrameTaken {
  double time = 0;          ///< of the points [s]
  std::int64_t points = 0;  ///< number of points in the frame
};

/// The state of a run after a row of its history.
struct Checkpoint {
  Precision precision = Precision::double_;
  bool moving = false;             ///< moving points; with Kinematics::automatic the hand-over has happened
  std::string instruction_set;     ///< used by the kernels; the bits of the result depend on it
  std::string specimen;            ///< specimen_digest() of the scene
  std::int64_t step = 0;           ///< steps so far
  double fraction = 0;             ///< share of the run that is done [-]
  double wall_time = 0;            ///< of the time loop so far, over all resumed parts [s]
  std::vector<FrameTaken> frames;  ///< frames so far, in their order
  std::string state;               ///< state of the solver, without what follows from the scene
};

/// Called with each checkpoint, which it may keep. An exception ends the run.
using CheckpointSink = std::function<void(Checkpoint)>;

/// When a run makes checkpoints.
struct CheckpointWish {
  CheckpointSink sink;  ///< also called when the observer ends the run; empty = no checkpoints
  /// Wall time between checkpoints [s]; 0 = only when the run is ended. Checkpoints are made at rows of the
  /// history.
  double every = 0;
  /// Decides instead, at each row, from the wall time since the state of the last one [s]; empty = `every`
  /// alone.
  std::function<bool(double since)> is_due = {};
};

/// SHA-256 of the specimen of a scene (labels, pixel size and extra points), 32 bytes.
[[nodiscard]] std::string specimen_digest(const Scene& scene);

}  // namespace mpm
