/// result.h5: history, failure maps and figures of a run.
///
/// Layout:
///   /                attributes: format, format_version, peak_stress_Pa, peak_strain, largest_stress_Pa, ...
///                    shear_failures, points, steps, dt_s, wall_time_s, energy_error, instruction_set,
///                    threads, stop_reason ("strain", "time", "drop", "interrupted"), scene (TOML text),
///                    run and remarks (texts from the caller, where there are some)
///   /history/NAME    one dataset per column of HistoryRow, shape (rows); attributes unit, meaning
///   /failure_strain  float32, shape (rows, cols), row 0 = top of the picture; NaN = did not fail
///   /failure_mode    uint8, same shape: 0 none, 1 tension, 2 shear
///   /crush_strain    float32, same shape; only with crack closure
///   /end_x, /end_y   float32, same shape, [m]; final positions; only with moving points
///   /deformation_xx, _xy, _yx, _yy   float32, same shape; only if the scene asks for it
#pragma once

#include <string>

#include "libmpm/scene/result.hpp"

namespace mpm {

/// What the caller of write_result() keeps beside a result; empty = nothing.
struct RunTexts {
  std::string run;      ///< by which it knows the run
  std::string remarks;  ///< what else it has to say of it
};

/// Write a result to a temporary name, flush, close and rename it. The same result gives the same bytes.
/// @param scene_text  the resolved scene, stored as an attribute.   @throws FileError.
void write_result(const std::string& path, const Result& result, const std::string& scene_text,
                  const RunTexts& texts = {});

/// Read a result.   @throws FileError naming the file and the fault.
[[nodiscard]] Result read_result(const std::string& path);

/// The resolved scene in a result file.   @throws FileError as read_result().
[[nodiscard]] std::string read_scene_text(const std::string& path);

/// @throws FileError as read_result().
[[nodiscard]] RunTexts read_run_texts(const std::string& path);

}  // namespace mpm
