/// What a calibration leaves on disk.
#pragma once

#include <filesystem>

#include "apps/system/attempts.hpp"
#include "apps/calibrate/calibration.hpp"

namespace app {

/// Write scene.toml with what was fitted, calibration.json and report.html into a folder that exists. Every
/// file is tried, whatever became of the others.   @return what the disk did not take.   @pre the calibration
/// has a history.
[[nodiscard]] Attempts write_calibration(const std::filesystem::path& folder, const CalibrationTask& task,
                                         const Calibration& calibration);

}  // namespace app
