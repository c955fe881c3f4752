/// The loop that drives a run.
#pragma once

#include "libmpm/run/hooks.hpp"
#include "libmpm/scene/result.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/solver/checkpoint.hpp"

namespace mpm {

struct Plan;

/// Solve a scene.
/// @throws Error for a scene that is not valid, Diverged with the step, time and place, and what to try.
[[nodiscard]] Result simulate(const Scene& scene, const RunHooks& hooks = {});

/// The same by a plan that may do more than the scene needs.
[[nodiscard]] Result simulate(const Scene& scene, const Plan& plan, const RunHooks& hooks = {});

/// Go on from a checkpoint: the result has the same bits as if the run had never stopped, its wall time
/// apart. Frames are lent from the one on that comes after Checkpoint::frames.
/// @param scene  that of the checkpoint, but for its threads.
/// @throws FileError where the checkpoint is of another specimen, precision or kinematics, of an instruction
///         set that the processor lacks, or holds what cannot be; and what simulate() throws.
[[nodiscard]] Result resume(const Scene& scene, const Checkpoint& checkpoint, const RunHooks& hooks = {});

}  // namespace mpm
