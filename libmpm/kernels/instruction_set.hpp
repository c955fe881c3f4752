/// Which kernels this machine runs.
#pragma once

#include <string_view>
#include <vector>

#include "libmpm/kernels/kernels.hpp"
#include "libmpm/kernels/moving_kernels.hpp"

namespace mpm {

/// The kernels that this processor can run, fastest first; never empty.
[[nodiscard]] std::vector<const kernels::Kernels*> available_kernels();

/// The kernels of that name, or the fastest ones for an empty name.
/// @throws Error when this processor runs none of that name.
[[nodiscard]] const kernels::Kernels& chosen_kernels(std::string_view name);

/// The kernels of moving points of the same instruction set.
[[nodiscard]] const moving::Kernels& chosen_moving_kernels(std::string_view name);

}  // namespace mpm
