/// Which kernels this machine runs.
#pragma once

#include <string_view>
#include <vector>

#include "libmpm/kernels.hpp"

namespace mpm {

/// The kernels that this processor can run, fastest first; never empty.
[[nodiscard]] std::vector<const kernels::Kernels*> available_kernels();

/// The fastest of them, or the ones named by the environment variable MESOPIX_INSTRUCTION_SET.
/// @throws Error when that names none that this processor can run.
[[nodiscard]] const kernels::Kernels& chosen_kernels();

}  // namespace mpm
