/// The keys of study files.
#pragma once

#include <string_view>
#include <vector>

#include "apps/settings/field.hpp"
#include "apps/study/study.hpp"

namespace app {

/// The table of a study file that says which keys of the scene vary.
inline constexpr const char* study_vary = "vary";

/// Keys of a study file beside its table [vary].
[[nodiscard]] const std::vector<FieldOf<StudyPlan>>& study_fields();

/// Whether a key stands in study files, and in no scene.
[[nodiscard]] bool is_study_key(std::string_view key);

}  // namespace app
