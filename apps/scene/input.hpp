/// From what a command is given, a scene, a picture or a specimen, to settings.
#pragma once

#include <string>
#include <vector>

#include "apps/scene/scene_file.hpp"

namespace app {

/// What an INPUT is, told by its first bytes and, for scenes, by its name.
enum class InputKind { hdf5, scene, picture, folder };

/// @throws Rejected (Exit::io) when there is nothing that can be read.
[[nodiscard]] InputKind kind_of_input(const std::string& path);

/// What generate draws: ellipses, of a scene or by settings alone.
/// @param scene  path; empty = none.   @throws Rejected, also for a scene whose specimen is a picture or a
/// file.
[[nodiscard]] Resolved resolve_ellipses(const std::string& scene, const std::vector<Assignment>& given);

/// What convert segments: a picture, or the one that a scene names.   @throws Rejected.
[[nodiscard]] Resolved resolve_picture(const std::string& input, std::vector<Assignment> given);

/// What simulate breaks and twin measures: a scene, or one that has but that specimen file or picture.
/// @param argument  what the help calls it: "INPUT".   @throws Rejected, for a folder with Exit::usage.
[[nodiscard]] Resolved resolve_input(const char* argument, const std::string& input,
                                     std::vector<Assignment> given);

/// Where calibrate begins.   @throws Rejected for what is no scene.
[[nodiscard]] Resolved resolve_scene(const std::string& input, const std::vector<Assignment>& given);

}  // namespace app
