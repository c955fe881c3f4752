/// calibration.json: what was aimed at, what was free, what was found.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "apps/calibrate/calibration.hpp"

namespace app {

/// SI units in the names of the keys; what is not known is null.
[[nodiscard]] nlohmann::ordered_json calibration_json(const CalibrationTask& task,
                                                      const Calibration& calibration);

}  // namespace app
