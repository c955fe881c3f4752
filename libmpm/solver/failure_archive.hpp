/// Failure maps in the archive of a run.
#pragma once

#include <algorithm>

#include "libmpm/solver/archive.hpp"
#include "libmpm/solver/moving_start.hpp"

namespace mpm {

/// @param maps  of the shape that the scene gives them.
template <class Archive, class Maps>
void pass_maps(Archive& archive, Maps& maps) {
  archive.block(maps.failure_strain);
  archive.block(maps.failure_mode);
  archive.block(maps.crush_strain);
  archive.block(maps.extra_failure_strain);
  archive.block(maps.extra_failure_mode);
  if constexpr (Archive::reads) {
    const auto is_mode = [](std::uint8_t mode) {
      return mode <= static_cast<std::uint8_t>(FailureMode::shear);
    };
    const std::uint8_t* first = maps.failure_mode.data();
    if (!std::all_of(first, first + maps.failure_mode.size(), is_mode) ||
        !std::all_of(maps.extra_failure_mode.begin(), maps.extra_failure_mode.end(), is_mode))
      archive.fail("a failure of no mode");
  }
}

}  // namespace mpm
