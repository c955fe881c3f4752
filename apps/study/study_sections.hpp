/// Sections of the report of a study. Each is empty where the study has nothing to say about it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/study/study_results.hpp"
#include "libmpm/scene/scene.hpp"
#include "specimen/body/mask.hpp"

namespace app {

/// What a report is about.
struct StudyRecord {
  const Study& study;
  const std::vector<Member>& members;
  const StudyResults& results;
  mpm::Scene scene;                            ///< of the first member that is done, without labels
  std::optional<specimen::LabelledMask> mask;  ///< of that member, where all have one size
  std::vector<std::string> doubts = {};        ///< of the specimens, see doubts_of()
};

/// Peak stress and strain: mean, scatter, confidence interval, histogram; by point where parameters vary.
[[nodiscard]] std::string peaks_section(const StudyRecord& record);

/// Weibull plot and parameters, where only seeds vary.
[[nodiscard]] std::string weibull_section(const StudyRecord& record);

/// How the mean settles, and how many members it takes, where only seeds vary.
[[nodiscard]] std::string convergence_section(const StudyRecord& record);

/// All curves, with the mean and the scatter band of each point.
[[nodiscard]] std::string curves_section(const StudyRecord& record);

/// Rank correlations and first-order indices, where parameters vary.
[[nodiscard]] std::string sensitivity_section(const StudyRecord& record);

/// Strength against size, where width or height of random specimens varies.
[[nodiscard]] std::string size_section(const StudyRecord& record);

/// Whether members differ in the size or number of their pixels.
[[nodiscard]] bool varies_pixels(const StudyPlan& plan);

}  // namespace app
