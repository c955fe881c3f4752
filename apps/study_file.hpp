/// Study files: TOML that says what of a scene varies, and how.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "apps/field.hpp"
#include "apps/study.hpp"

namespace app {

/// Keys of a study file beside its table [vary].
[[nodiscard]] const std::vector<FieldOf<StudyPlan>>& study_fields();

/// Whether a key stands in study files, and in no scene.
[[nodiscard]] bool is_study_key(std::string_view key);

/// The plan that a text says, with what it leaves out filled in but for the default of seed_of, which needs
/// the scene.   @param path  for the messages and the folder that paths are relative to.
/// @throws Rejected (Exit::data) with every complaint.
[[nodiscard]] StudyPlan parse_study(const std::string& text, const std::string& path);

/// Whether a TOML text is that of a study: has a key that no scene has.   @throws Rejected for what is no
/// TOML.
[[nodiscard]] bool is_study(const std::string& text, const std::string& path);

/// The study of a file, its scene read and found valid.
/// @throws Rejected for a study or a scene that is wrong, or cannot be read.
[[nodiscard]] Study read_study(const std::string& path);

/// The same from the texts of a study and its scene; the paths are for messages and folders.
[[nodiscard]] Study study_of(TextFile file, TextFile scene);

}  // namespace app
