/// How busy the machine is.
#pragma once

namespace mpm {

/// Cores that nothing else uses at this moment, >= 1; all of them where the system does not tell.
[[nodiscard]] int idle_cores();

}  // namespace mpm
