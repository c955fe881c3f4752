/// A calibration in words, for the terminal, and its report.html.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "apps/calibrate/calibration.hpp"

namespace app {

/// That a measured curve ends before its peak; empty for others.
[[nodiscard]] std::string doubt_of(const Target& target);

/// "a peak of 1.75 MPa at strain 75e-6", "a curve to strain 200e-6 with its peak of ...".
[[nodiscard]] std::string target_text(const Target& target);

/// Its settings at a factor: "phases.mortar.young = 21 GPa".
[[nodiscard]] std::vector<std::string> setting_texts(const FreeParameter& parameter, double factor);

/// "the misfit came below 0.5 %", "100 evaluations were made" ...
[[nodiscard]] std::string end_text(const CalibrationTask& task, SearchEnd end);

/// Why the target was not met, where the nearest lies and what holds it; empty when it was met: a peak to
/// 2 %, or, with no parameter at a bound, to the standard error of its mean over the seeds; a curve to 10 %
/// of its peak, or with no parameter at a bound.
[[nodiscard]] std::string why_not_met(const CalibrationTask& task, const Calibration& calibration);

/// What was found, a line each.
[[nodiscard]] std::vector<std::string> outcome_lines(const CalibrationTask& task,
                                                     const Calibration& calibration);

/// "evaluation 12   misfit 1.20 %   best 0.90 %   tensile_scale x 0.530 young x 1.100".
[[nodiscard]] std::string evaluation_text(const CalibrationTask& task, const Calibration& so_far);

/// The whole page: target against the curves of all seeds, parameters, peaks, the search, the scene.
[[nodiscard]] std::string calibration_html(const CalibrationTask& task, const Calibration& calibration,
                                           const std::string& title, const std::string& scene_toml);

}  // namespace app
