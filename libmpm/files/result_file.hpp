/// result.h5: history, failure maps and figures of a run.
///
/// Layout, as h5py shows it:
///   /                attributes: format, format_version, peak_stress_Pa, peak_strain, tension_failures,
///                    shear_failures, points, steps, dt_s, wall_time_s, energy_error, instruction_set,
///                    threads, stop_reason ("strain", "time", "drop", "interrupted"), scene (TOML text)
///   /history/NAME    one dataset a column of HistoryRow, shape (rows); attributes unit, meaning
///   /failure_strain  float32, shape (rows, cols), row 0 = top of the picture; NaN = did not fail
///   /failure_mode    uint8, same shape: 0 none, 1 tension, 2 shear
///   /crush_strain    float32, same shape; only with crack closure
///   /end_x, /end_y   float32, same shape, [m]; where the points are at the end; only with moving points
///   /deformation_xx, _xy, _yx, _yy   float32, same shape; only where the scene asks for it
#pragma once

#include <string>

#include "libmpm/scene/result.hpp"

namespace mpm {

/// Write a result: to a temporary name, flushed, closed and renamed. The same result gives the same bytes.
/// @param scene_text  the resolved scene, kept as an attribute.   @throws FileError.
void write_result(const std::string& path, const Result& result, const std::string& scene_text);

/// @throws FileError naming the file and what is wrong.
[[nodiscard]] Result read_result(const std::string& path);

/// The resolved scene that a result file carries.   @throws FileError as read_result does.
[[nodiscard]] std::string read_scene_text(const std::string& path);

}  // namespace mpm
