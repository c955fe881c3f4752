/// The keys of study files.
/// Study files: TOML that says what of a scene varies, and how.
#pragma once

#include <string>
#include <vector>

#include "apps/settings/schema.hpp"
#include "apps/study/study.hpp"

namespace app {

/// Keys of a study file beside its table [vary].
[[nodiscard]] const std::vector<FieldOf<StudyPlan>>& study_fields();

/// Whether a text is a study, right or wrong: it names a scene, or says what varies. Other keys of studies
/// stand in scenes by mistake.
/// @throws Rejected (Exit::data) where it is no TOML.
[[nodiscard]] bool is_meant_as_study(const std::string& text, const std::string& path);

/// Path of the scene that the text of a study names; empty when it names none.   @throws as
/// is_meant_as_study.
[[nodiscard]] std::string scene_of_study(const std::string& text, const std::string& path);

/// The plan that a text says, with what it leaves out filled in but for the default of seed_of, which needs
/// the scene.   @param path  for the messages and the folder that paths are relative to.
/// @throws Rejected (Exit::data) with every complaint.
[[nodiscard]] StudyPlan parse_study(const std::string& text, const std::string& path);

/// The study of a file, its scene read and found valid.
/// @throws Rejected for a study or a scene that is wrong, or cannot be read.
[[nodiscard]] Study read_study(const std::string& path);

/// The same from the texts of a study and its scene; the paths are for messages and folders.
[[nodiscard]] Study study_of(TextFile file, TextFile scene);

}  // namespace app
