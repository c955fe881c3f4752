/// The argument of a command that names a specimen in any of its forms.
#pragma once

#include <string>
#include <vector>

#include "apps/scene_file.hpp"

namespace app {

/// Settings of a scene file, or of a scene that has but that specimen file or picture; options come after
/// them.
/// @param argument  what the help calls it: "INPUT".   @throws Rejected, for a folder with Exit::usage.
[[nodiscard]] Resolved resolve_input(const char* argument, const std::string& input,
                                     std::vector<Assignment> given);

}  // namespace app
