/// Run a scene, or resume a run from a checkpoint.
#pragma once

#include "libmpm/run/hooks.hpp"
#include "libmpm/scene/result.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/solver/checkpoint.hpp"

namespace mpm {

struct Plan;

/// Run a scene. Same scene, same bits, on any number of threads.
/// @throws Error for an invalid scene; Diverged if the run becomes unstable; whatever a hook throws.
[[nodiscard]] Result simulate(const Scene& scene, const RunHooks& hooks = {});

/// The same with a plan that may have more features than the scene needs.
[[nodiscard]] Result simulate(const Scene& scene, const Plan& plan, const RunHooks& hooks = {});

/// Resume a run from a checkpoint. Except for its wall time, the result has the same bits as a run that never
/// stopped. The first frame passed to the sink is the one after Checkpoint::frames.
/// @param scene  the scene of the run; only its threads may differ.
/// @throws FileError if the checkpoint belongs to another specimen, precision or kinematics, needs an
/// instruction
///         set that the processor lacks, or contains impossible values; otherwise as simulate().
[[nodiscard]] Result resume(const Scene& scene, const Checkpoint& checkpoint, const RunHooks& hooks = {});

}  // namespace mpm
