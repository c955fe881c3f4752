/// The format of result.h5, its stop reasons and the names of the deformation; the columns of the history are
/// in libmpm/scene/result.cpp, other names in result_file*.cpp. Not installed: private to result_file*.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "libmpm/files/hdf5_handle.hpp"
#include "libmpm/scene/result.hpp"

namespace mpm::result_file {

inline constexpr const char* format_name = "mesopix result";
inline constexpr std::int64_t format_version = 1;
inline constexpr std::array<std::pair<StopReason, const char*>, 4> stop_reasons{{
    {StopReason::strain, "strain"},
    {StopReason::time, "time"},
    {StopReason::drop, "drop"},
    {StopReason::interrupted, "interrupted"},
}};

inline constexpr std::array<const char*, 4> deformation_names{"deformation_xx", "deformation_xy",
                                                              "deformation_yx", "deformation_yy"};

}  // namespace mpm::result_file
