/// report.html of a calibration.
#pragma once

#include <string>

#include "apps/calibrate/calibration.hpp"

namespace app {

/// The whole page: target against the curves of all seeds, parameters, peaks, the search, the scene.
[[nodiscard]] std::string calibration_html(const CalibrationTask& task, const Calibration& calibration,
                                           const std::string& title, const std::string& scene_toml);

}  // namespace app
