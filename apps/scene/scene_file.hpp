/// Scene files: TOML whose keys are those of the schema, and [[ellipses]].
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "apps/settings/assignment.hpp"

namespace app {

/// The table of a study file that says which keys of the scene vary.
inline constexpr const char* study_vary = "vary";
/// Keys that stand in study files and in no scene.
inline constexpr std::array<std::string_view, 7> study_keys{study_vary,      "scene", "sampling", "samples",
                                                            "sampling_seed", "seeds", "seed_of"};

/// A scene file as it was written, not yet applied.
struct SceneFile {
  std::vector<Assignment> assignments;          ///< in the order of the file
  std::vector<specimen::Ellipse> ellipse_list;  ///< of [[ellipses]]
  Place ellipses_place;
  std::vector<Complaint> complaints;  ///< what is no scene, whatever the schema says
};

/// Paths in it are made relative to the folder of the file.   @throws Rejected when it cannot be read or is
/// no TOML.
[[nodiscard]] SceneFile read_scene_file(const std::string& path);

/// The same from text; `path` is for the messages and the folder.
[[nodiscard]] SceneFile parse_scene(const std::string& text, const std::string& path);

/// What the user asked for, defaults included, and where they said it.
struct Resolved {
  Settings settings;
  Origins origins;
};

/// The same without what is refused, which keeps its default; what would have no effect is not looked for.
/// @param[out] complaints  about that, those about the file first and in its order; they are appended.
[[nodiscard]] Resolved resolve_what_can_be(const SceneFile& scene,
                                           const std::vector<Assignment>& command_line,
                                           std::vector<Complaint>& complaints);

/// Settings from the defaults, the scene, then the command line; a later one wins.
/// @throws Rejected with every complaint about file and command line.
[[nodiscard]] Resolved resolve(const SceneFile& scene, const std::vector<Assignment>& command_line);

/// The same from settings that are resolved already.
[[nodiscard]] Resolved resolve_over(Resolved base, const std::vector<Assignment>& given);

}  // namespace app
