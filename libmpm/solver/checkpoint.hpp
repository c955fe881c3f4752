/// SHA-256, by which a checkpoint tells whether it is whole, and whose it is.
/// A run as it stands after a row of its history, from which it goes on as if it had never stopped.
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

/// One under way.
class Sha256 {
 public:
  Sha256();
  Sha256& add(std::string_view bytes);
  /// The digest as 32 bytes; nothing may be added any more.
  [[nodiscard]] std::string digest();

 private:
  struct Context;
  struct Free {
    void operator()(Context* context) const;
  };
  std::unique_ptr<Context, Free> context_;
};

/// A frame that a run has lent to its sink.
struct FrameTaken {
  double time = 0;          ///< [s]
  std::int64_t points = 0;  ///< in it
};

struct Checkpoint {
  Precision precision = Precision::double_;
  bool moving = false;             ///< points move; with Kinematics::automatic small strain has ended
  std::string instruction_set;     ///< that the kernels run on: the bits depend on it
  std::string specimen;            ///< specimen_digest() of the scene
  std::int64_t step = 0;           ///< steps that led here
  double fraction = 0;             ///< of the run that is done [-]
  double wall_time = 0;            ///< of the time loop so far, in all its parts [s]
  std::vector<FrameTaken> frames;  ///< taken so far, in their order
  std::string state;               ///< all that the next steps depend on, but what follows from the scene
};

/// Is lent each checkpoint as the run comes to it. What it throws ends the run.
using CheckpointSink = std::function<void(const Checkpoint&)>;

/// What is asked of a run that may have to go on another day.
struct CheckpointWish {
  CheckpointSink sink;  ///< gets one when the observer ends the run, too; none: there are no checkpoints
  /// Wall time between two of them [s]; 0: none on the way. They come at rows of the history, and further
  /// apart where making one takes more than a hundredth of this.
  double every = 0;
};

/// SHA-256 of what is broken: labels, pixel size and extra points, 32 bytes.
[[nodiscard]] std::string specimen_digest(const Scene& scene);

}  // namespace mpm
