/// From the wish for a calibration, as texts, to its task; and what it leaves on disk.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "apps/calibrate/calibration.hpp"
#include "apps/job/job.hpp"
#include "apps/system/files.hpp"

namespace app {

/// Options of calibrate; empty = not given.
struct CalibrationWish {
  std::string peak_stress;
  std::string peak_strain;
  std::string curve;  ///< path of a CSV file
  std::string free;
  std::string seeds = "4";
  std::string tolerance = "0.5 %";
  std::string evaluations = "100";
};

/// @param measured  a curve that is there already, in place of a file; empty = none.
/// @throws Rejected for none or more than one target, and for what cannot be read.
[[nodiscard]] Target read_target(const CalibrationWish& wish, Curve measured = {});

/// @throws Rejected for a run without platens.
void check_loading(const mpm::Scene& scene);

/// @param job  must outlive the task.   @throws Rejected (Exit::usage).
[[nodiscard]] CalibrationTask make_task(const Job& job, Target target, const CalibrationWish& wish);

/// SI units in the names of the keys; what is not known is null.
[[nodiscard]] nlohmann::ordered_json calibration_json(const CalibrationTask& task,
                                                      const Calibration& calibration);

/// Write scene.toml with what was fitted, calibration.json and report.html into a folder that exists. Every
/// file is tried, whatever became of the others.   @return what the disk did not take.   @pre the calibration
/// has a history.
[[nodiscard]] Attempts write_calibration(const std::filesystem::path& folder, const CalibrationTask& task,
                                         const Calibration& calibration);

}  // namespace app
