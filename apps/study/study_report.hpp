/// report.html of a study: what its members say together.
#pragma once

#include <string>
#include <vector>

#include "apps/study/study_sections.hpp"

namespace app {

/// Whether there is a picture of how often each pixel failed.
[[nodiscard]] bool has_crack_picture(const StudyRecord& record);

/// A section each for what there is: warnings, peaks, Weibull plot, convergence, curves, cracks,
/// sensitivities, size effect, failures, notes, the study itself.
/// @param study_toml  the study file.
[[nodiscard]] std::string study_html(const StudyRecord& record, const std::string& study_toml);

/// Write report.html and, where all members have one size, cracks.png.
/// @param doubts  of the specimens, see doubts_of().   @throws mpm::FileError, specimen::Error, Rejected.
void write_study_report(const StudyFolder& folder, const Study& study, const std::vector<Member>& members,
                        const StudyResults& results, std::vector<std::string> doubts = {});

}  // namespace app
